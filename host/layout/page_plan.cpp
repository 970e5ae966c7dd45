#include "layout/page_plan.h"

#include "layout/balance.h"

namespace layout {

PagePlan::PagePlan(const Surroundings& in, const model::Model& model, Notes& notes)
    : pageHeight_(in.pageHeight), model_(model), notes_(notes), ahead_(in, model.blocks) {
    if (!model.page.balance)
        return;
    goesOnInList_.resize(model.blocks.size());
    for (const model::Container& one : model.containers)
        if (one.role == schemas::ContainerRole::list)
            for (std::size_t block = one.first + 1; block <= one.last; ++block)
                goesOnInList_[block] = true;
}

double PagePlan::costOf(const Strip& first) const {
    if (!first.firstOfBlock)
        return withinBlockCost;
    if (goesOnInList_[first.block])
        return withinListCost;
    return model_.blocks[first.block]->headingLevel > 0 ? headingCost : 0;
}

double PagePlan::notesOf(const Group& group) {
    std::vector<Notes::Pointer> all;
    for (const Strip& strip : group.strips)
        all.insert(all.end(), strip.footnotes.begin(), strip.footnotes.end());
    return all.empty() ? 0 : notes_.wanted(all, pageHeight_).all;
}

void PagePlan::begin(const GroupStart& first) {
    forget();
    if (!model_.page.balance)
        return;
    constexpr double pagesAhead = 6;
    std::vector<Portion> portions;
    std::vector<Flow::Place> places;
    bool goesOn = true;
    ahead_.seek(first);
    for (double height = 0; height < pagesAhead * pageHeight_;) {
        Group group;
        Made made = Made::pause;
        while (made == Made::pause)
            made = ahead_.read(group);
        reached_ = ahead_.reached() + (made == Made::end ? 1 : 0); // the end is read, too
        const bool isBehindBreak =
            made == Made::end || (!portions.empty() && group.strips.front().breakBefore);
        if (isBehindBreak || group.height > pageHeight_) {
            goesOn = !isBehindBreak;
            break;
        }
        const Strip& strip = group.strips.front();
        places.push_back(group.start.at);
        const double onTop = strip.beginsDocument() ? strip.before : 0;
        portions.push_back({onTop + group.height + notesOf(group), strip.before,
                            group.strips.back().after, costOf(strip)});
        height += group.height;
    }
    const std::size_t next = secondPage(portions, goesOn, pageHeight_);
    if (next < places.size())
        next_ = places[next];
}

void PagePlan::forget() {
    next_.reset();
    reached_ = 0;
}

} // namespace layout

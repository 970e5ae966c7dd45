#include "session/folded_pages.h"

#include <QElapsedTimer>
#include <algorithm>
#include <iterator>

namespace session {

using sgml::NodeId;

namespace {

std::size_t placeOf(const std::shared_ptr<const document::Tracker::Place>& fold) {
    return fold->offset;
}

// The beginning of an element's text, behind its tags and the brace, and its end.
std::size_t firstLetterIn(const sgml::Tree& tree, NodeId element) {
    NodeId at = element;
    while (tree.node(at).firstChild != sgml::noNode)
        at = tree.node(at).firstChild;
    return tree.isElement(at) ? tree.node(at).startTag.to : tree.node(at).range.from + 1;
}

std::size_t lastLetterIn(const sgml::Tree& tree, NodeId element) {
    NodeId at = element;
    while (tree.node(at).lastChild != sgml::noNode)
        at = tree.node(at).lastChild;
    return tree.isElement(at) ? tree.node(at).range.from : tree.node(at).range.to - 1;
}

} // namespace

FoldedPages::FoldedPages(OpenDocument& document)
    : document_(document), tracker_(document.document()) {}

FoldedPages::~FoldedPages() = default;

// --- the pages ---------------------------------------------------------------------------------

void FoldedPages::present(const QString& presentation) {
    if (whole_)
        disconnect(whole_.get(), nullptr, this, nullptr);
    isOwn_ = false;
    stop();
    setBase({});
    whole_ = document_.presented(presentation);
    connect(whole_.get(), &Presented::modelled, this, &FoldedPages::update);
    connect(whole_.get(), &Presented::grown, this, [this] {
        if (!isOwn_)
            Q_EMIT grown();
    });
    connect(whole_.get(), &Presented::complete, this, &FoldedPages::followPages);
    update();
}

bool FoldedPages::isComplete() const {
    return isOwn_ ? whole_->isModelled() && GrowingPages::isComplete()
                  : whole_->isComplete() && !hides();
}

const layout::Pages& FoldedPages::pages() const {
    return isOwn_ ? GrowingPages::pages() : whole_->pages();
}

void FoldedPages::settle(int mostMs) {
    QElapsedTimer time;
    time.start();
    if (!isOwn_)
        whole_->settle(mostMs); // with followPages()
    if (!isOwn_)
        return;
    whole_->settleModel(mostMs);
    if (whole_->isModelled())
        GrowingPages::settle(std::max(0, mostMs - static_cast<int>(time.elapsed())));
}

bool FoldedPages::step() {
    if (!std::exchange(isDue_, false))
        return GrowingPages::step();
    if (!whole_->model()) { // Presented::modelled comes
        stop();
        return false;
    }
    const Sections folded = foldedSections();
    if (whole_->isModelled())
        forgetOthers(folded);
    if (!hides()) {
        update();
        return false;
    }
    layOut(folding_.folded(*whole_->model(), folded), whole_->objects());
    return true;
}

// A fold whose heading is gone, or that has nothing to hide any more.
void FoldedPages::forgetOthers(const Sections& folded) {
    std::vector<Fold> left;
    for (const model::Section& section : folded)
        left.push_back(foldIn(elementOf(section.heading)));
    folds_ = std::move(left);
}

// Of the whole. The first pages with folds begin with these.
void FoldedPages::followPages() {
    if (isOwn_)
        Q_EMIT wholeChanged();
    else if (hides())
        update();
    else
        Q_EMIT complete();
}

void FoldedPages::update() {
    if (!whole_)
        return; // present() comes
    if (!hides()) {
        if (!std::exchange(isOwn_, false))
            return;
        stop();
        setBase({});
        if (whole_->isComplete())
            Q_EMIT complete();
        else
            Q_EMIT grown();
        return;
    }
    if (!isOwn_) {
        if (!whole_->isComplete())
            return; // followPages() comes
        isOwn_ = true;
        setBase(whole_->pages());
        Q_EMIT grown();
    }
    isDue_ = true;
    startAnew();
}

// --- sections ----------------------------------------------------------------------------------

const FoldedPages::Sections& FoldedPages::sections() {
    if (const auto model = whole_->model(); model != read_) {
        sections_ = model ? model::sectionsOf(*model) : Sections();
        std::erase_if(sections_, [](const model::Section& one) { return one.isEmpty(); });
        read_ = model;
    }
    return sections_;
}

// Of the model, which may be older than the document.
NodeId FoldedPages::elementOf(std::size_t block) const {
    const auto model = whole_->model();
    if (!model || block >= model->blocks.size())
        return sgml::noNode;
    const NodeId element = model->blocks[block]->element;
    return document_.document().tree().holds(element) ? element : sgml::noNode;
}

FoldedPages::Fold FoldedPages::foldIn(NodeId heading) const {
    if (heading == sgml::noNode || !document_.document().tree().holds(heading))
        return nullptr;
    const text::Range range = document_.document().tree().node(heading).range;
    const auto fold = std::ranges::lower_bound(folds_, range.from, {}, placeOf);
    return fold != folds_.end() && (*fold)->offset < range.to ? *fold : nullptr;
}

FoldedPages::Sections FoldedPages::foldedSections() {
    Sections result;
    std::ranges::copy_if(sections(), std::back_inserter(result), [&](const model::Section& one) {
        return foldIn(elementOf(one.heading)) != nullptr;
    });
    return result;
}

const model::Section* FoldedPages::sectionOf(NodeId heading) {
    const auto isIt = [&](const model::Section& one) { return elementOf(one.heading) == heading; };
    if (heading == sgml::noNode)
        return nullptr;
    const auto found = std::ranges::find_if(sections(), isIt);
    return found == sections_.end() ? nullptr : &*found;
}

// To the end of its last block.
text::Range FoldedPages::bytesUnder(const model::Section& section) const {
    const sgml::Tree& tree = document_.document().tree();
    const NodeId heading = elementOf(section.heading), last = elementOf(section.last);
    if (heading == sgml::noNode || last == sgml::noNode)
        return {};
    return {tree.node(heading).range.to, tree.node(last).range.to};
}

std::vector<NodeId> FoldedPages::headingsAround(std::size_t place) {
    whole_->settleModel();
    const sgml::Tree& tree = document_.document().tree();
    std::vector<NodeId> result;
    for (const model::Section& section : sections()) {
        const NodeId heading = elementOf(section.heading);
        if (heading == sgml::noNode)
            continue;
        if (tree.node(heading).range.from > place)
            break;
        if (place < bytesUnder(section).to)
            result.push_back(heading);
    }
    return result;
}

bool FoldedPages::isFolded(NodeId heading) const { return hides() && foldIn(heading) != nullptr; }

model::SectionCounts FoldedPages::counts(NodeId heading) {
    const model::Section* section = sectionOf(heading);
    return section != nullptr ? model::countsOf(*read_, *section) : model::SectionCounts();
}

NodeId FoldedPages::hiding(std::size_t place) {
    if (!hides())
        return sgml::noNode;
    const Sections folded = foldedSections();
    const auto outermost = std::ranges::find_if(
        folded, [&](const model::Section& section) { return bytesUnder(section).contains(place); });
    return outermost == folded.end() ? sgml::noNode : elementOf(outermost->heading);
}

// --- folding -----------------------------------------------------------------------------------

void FoldedPages::change(std::vector<Fold> folds) {
    folds_ = std::move(folds);
    std::ranges::sort(folds_, {}, placeOf);
    update();
}

void FoldedPages::setFolded(NodeId heading, bool isFolded) {
    if (isFolded == this->isFolded(heading) || (isFolded && !isFoldable(heading)))
        return;
    std::vector<Fold> folds = folds_;
    std::erase(folds, foldIn(heading));
    if (isFolded)
        folds.push_back(tracker_.track(document_.document().tree().node(heading).startTag.to,
                                       text::Gravity::behind));
    change(std::move(folds));
}

void FoldedPages::foldAll() {
    whole_->settleModel();
    std::vector<std::size_t> places;
    for (const model::Section& section : sections())
        if (const NodeId heading = elementOf(section.heading); heading != sgml::noNode)
            places.push_back(document_.document().tree().node(heading).startTag.to);
    restore(places);
}

void FoldedPages::unfoldAll() {
    if (!folds_.empty())
        change({});
}

template <class Holds> bool FoldedPages::revealWhere(Holds holds) {
    if (!hides())
        return false;
    whole_->settleModel();
    std::vector<Fold> folds = folds_;
    for (const model::Section& section : foldedSections())
        if (holds(section))
            std::erase(folds, foldIn(elementOf(section.heading)));
    if (folds.size() == folds_.size())
        return false;
    change(std::move(folds));
    return true;
}

bool FoldedPages::reveal(std::size_t place) {
    return revealWhere(
        [&](const model::Section& section) { return bytesUnder(section).contains(place); });
}

bool FoldedPages::reveal(const std::string& anchor) {
    return revealWhere([&](const model::Section& section) {
        for (std::size_t i = section.heading + 1; i <= section.last; ++i)
            if (std::ranges::find(read_->blocks[i]->anchors, anchor) !=
                read_->blocks[i]->anchors.end())
                return true;
        return false;
    });
}

// The heading's own text is seen. A selection from its first letter on to the last hidden one
// is all of the section.
FoldedPages::Touched FoldedPages::isTouched(const model::Section& section, const text::Edits& edits,
                                            text::Range selected) const {
    const NodeId heading = elementOf(section.heading), last = elementOf(section.last);
    if (heading == sgml::noNode || last == sgml::noNode)
        return Touched::no;
    const sgml::Tree& tree = document_.document().tree();
    const sgml::Node& title = tree.node(heading);
    const text::Range all{title.range.from, tree.node(last).range.to};
    const bool isOne = std::ranges::any_of(edits, [&](const text::Edit& edit) {
        const auto [from, to] = edit.range;
        const bool isAll = from <= all.from && to >= all.to;
        const bool isBefore = to <= all.from, isBehind = from >= all.to;
        const bool isInHeading = from >= title.startTag.to && to <= title.endTag.from;
        return !isAll && !isBefore && !isBehind && !isInHeading;
    });
    if (!isOne)
        return Touched::no;
    const bool isSelected =
        selected.from <= firstLetterIn(tree, heading) && selected.to >= lastLetterIn(tree, last);
    return isSelected ? Touched::selected : Touched::partly;
}

bool FoldedPages::revealTouched(const text::Edits& edits, text::Range selected) {
    const auto revealThose = [&](Touched how) {
        return revealWhere([&](const model::Section& section) {
            return isTouched(section, edits, selected) == how;
        });
    };
    if (edits.empty())
        return false;
    if (revealThose(Touched::partly))
        return true;
    (void)revealThose(Touched::selected);
    return false;
}

std::vector<std::size_t> FoldedPages::places() const {
    std::vector<std::size_t> result;
    result.reserve(folds_.size());
    for (const Fold& fold : folds_)
        result.push_back(fold->offset);
    return result;
}

void FoldedPages::restore(const std::vector<std::size_t>& places) {
    std::vector<Fold> folds;
    folds.reserve(places.size());
    for (const std::size_t place : places)
        folds.push_back(tracker_.track(place, text::Gravity::behind));
    change(std::move(folds));
}

} // namespace session

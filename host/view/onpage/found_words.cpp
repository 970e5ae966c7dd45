#include "onpage/found_words.h"

namespace view {

namespace {

// On pages that were made of the same blocks, of which some are folded.
bool isSameWord(const places::Found& one, const places::Found& other) {
    const auto& first = one.parts.front().paragraph;
    const auto& second = other.parts.front().paragraph;
    if (one.from != other.from)
        return false;
    if (first == second)
        return true;
    const auto textOf = [](const paragraphs::Paragraph& of) {
        const model::Run& run = of.block()->runs.front();
        return std::tuple(of.block()->element, run.content, run.offset);
    };
    return !first->block()->runs.empty() && !second->block()->runs.empty() &&
           textOf(*first) == textOf(*second);
}

} // namespace

void FoundWords::look(const places::Search& search, const layout::Pages& whole,
                      const layout::Pages* folded) {
    search_ = search;
    folds_ = folded != nullptr;
    whole_.look(search, whole);
    if (folded != nullptr)
        folded_.look(search, *folded);
    shown_ = 0;
}

void FoundWords::follow(const layout::Pages& whole, const layout::Pages* folded) {
    if (search_.words.isEmpty())
        return;
    if (folded != nullptr && folds_)
        folded_.follow(*folded);
    else if (folded != nullptr)
        folded_.look(search_, *folded);
    folds_ = folded != nullptr;
    if (whole_.count() == 0) {
        whole_.follow(whole);
        return;
    }
    const places::Found was = whole_.at(shown_);
    whole_.follow(whole);
    shown_ = sameAs(was);
}

std::size_t FoundWords::sameAs(const places::Found& was) const {
    constexpr std::size_t pagesAround = 1;
    for (std::size_t page = was.page - std::min(was.page, pagesAround);
         page <= was.page + pagesAround; ++page) {
        std::size_t index = whole_.firstFrom(page);
        for (const places::Found& one : whole_.on(page)) {
            if (one.parts.front().paragraph == was.parts.front().paragraph && one.from == was.from)
                return index;
            ++index;
        }
    }
    const double bottom = was.parts.front().bottom();
    std::size_t index = whole_.firstFrom(was.page);
    for (const places::Found& one : whole_.on(was.page)) {
        if (one.parts.front().bottom() >= bottom)
            break;
        ++index;
    }
    return index < whole_.count() ? index : 0;
}

const places::Found* FoundWords::seen(std::size_t index) const {
    if (index >= whole_.count())
        return nullptr;
    const places::Found& wanted = whole_.at(index);
    if (!folds_)
        return &wanted;
    for (std::size_t i = 0; i < folded_.count(); ++i)
        if (const places::Found& one = folded_.at(i); isSameWord(one, wanted))
            return &one;
    return nullptr;
}

std::size_t FoundWords::numberOf(std::size_t onPages) const {
    if (!folds_ || onPages >= folded_.count())
        return onPages;
    const places::Found& one = folded_.at(onPages);
    for (std::size_t i = 0; i < whole_.count(); ++i)
        if (isSameWord(whole_.at(i), one))
            return i;
    return 0;
}

std::size_t FoundWords::firstFrom(std::size_t page, double y) const {
    const places::Finder& finder = onPages();
    std::size_t index = finder.firstFrom(page);
    for (const places::Found& one : finder.on(page)) {
        if (one.parts.front().bottom() >= y)
            break;
        ++index;
    }
    return finder.count() > 0 ? numberOf(index < finder.count() ? index : 0) : 0;
}

} // namespace view

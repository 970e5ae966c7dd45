#include "view/found_words.h"

namespace view {

void FoundWords::look(const layout::Search& search, const layout::Pages& pages) {
    searches_ = !search.words.isEmpty();
    finder_.look(search, pages);
    shown_ = 0;
}

void FoundWords::follow(const layout::Pages& pages) {
    if (!searches_)
        return;
    if (finder_.count() == 0) {
        finder_.follow(pages);
        return;
    }
    const layout::Found was = finder_.at(shown_);
    finder_.follow(pages);
    shown_ = sameAs(was);
}

std::size_t FoundWords::sameAs(const layout::Found& was) const {
    constexpr std::size_t pagesAround = 1;
    for (std::size_t page = was.page - std::min(was.page, pagesAround);
         page <= was.page + pagesAround; ++page) {
        std::size_t index = finder_.firstFrom(page);
        for (const layout::Found& one : finder_.on(page)) {
            if (one.parts.front().paragraph == was.parts.front().paragraph && one.from == was.from)
                return index;
            ++index;
        }
    }
    return firstFrom(was.page, was.parts.front().bottom());
}

std::size_t FoundWords::firstFrom(std::size_t page, double y) const {
    std::size_t index = finder_.firstFrom(page);
    for (const layout::Found& one : finder_.on(page)) {
        if (one.parts.front().bottom() >= y)
            break;
        ++index;
    }
    return index < finder_.count() ? index : 0;
}

} // namespace view

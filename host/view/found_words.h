// The words that are found in a view, and which of them is shown.
#pragma once

#include "layout/find.h"

namespace view {

class FoundWords {
public:
    void look(const layout::Search& search, const layout::Pages& pages);
    // The word that is shown stays the same where it still is; else it is the next one behind it.
    void follow(const layout::Pages& pages);

    [[nodiscard]] const layout::Finder& finder() const { return finder_; }
    [[nodiscard]] std::size_t shown() const { return shown_; }
    void show(std::size_t index) { shown_ = index; }
    // The first one whose end is at or below a height of a page; the first of all behind the last.
    [[nodiscard]] std::size_t firstFrom(std::size_t page, double y) const;

private:
    [[nodiscard]] std::size_t sameAs(const layout::Found& was) const;

    layout::Finder finder_;
    bool searches_ = false;
    std::size_t shown_ = 0;
};

} // namespace view

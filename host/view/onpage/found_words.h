// The words that are found in a view, and which of them is shown.
//
// They are counted in all of the document. If the view folds sections, some of them stand on
// none of its pages.
#pragma once

#include "places/find.h"

namespace view {

class FoundWords {
public:
    // `folded`: the view's own pages, where they are not `whole`; else null.
    void look(const places::Search& search, const layout::Pages& whole,
              const layout::Pages* folded = nullptr);
    // The word that is shown stays the same where it still is; else it is the next one behind it.
    void follow(const layout::Pages& whole, const layout::Pages* folded = nullptr);

    [[nodiscard]] const places::Finder& finder() const { return whole_; }
    [[nodiscard]] std::size_t shown() const { return shown_; }
    void show(std::size_t index) { shown_ = index; }

    // --- on the pages of the view
    [[nodiscard]] const places::Finder& onPages() const { return folds_ ? folded_ : whole_; }
    // The place of a word there; null: its section is folded.
    [[nodiscard]] const places::Found* seen(std::size_t index) const;
    // Of all words the number of that one of these.
    [[nodiscard]] std::size_t numberOf(std::size_t onPages) const;
    // The first one whose end is at or below a height of a page; the first of all behind the last.
    [[nodiscard]] std::size_t firstFrom(std::size_t page, double y) const;

private:
    [[nodiscard]] std::size_t sameAs(const places::Found& was) const;

    places::Finder whole_;
    places::Finder folded_;
    bool folds_ = false; // then these are on the pages of the view
    places::Search search_;
    std::size_t shown_ = 0;
};

} // namespace view

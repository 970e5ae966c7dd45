// Pages of a model before, as far as those of the model now are the same.
#pragma once

#include "layout/changes.h"
#include "layout/page_start.h"
#include "layout/pages.h"

namespace layout {

struct Basis {
    Basis(ModelPointer of, std::shared_ptr<Stock> stockOf)
        : model(std::move(of)), stock(std::move(stockOf)), sizes(stock->sizes().rounds()),
          frames(*model) {}
    ModelPointer model;
    std::shared_ptr<Stock> stock; // pages of several models of one document may share it
    std::size_t sizes = 0;        // of the stock: the round that they were asked for in
    Frames frames;
    std::vector<PageStart> starts; // of each page
};

class OldPages {
public:
    // Without `old` there are none. `resized`: objects whose sizes are others.
    OldPages(Pages old, const Basis& now, const paragraphs::Sizes::Changed& resized);

    // Old pages that follow those that are made, and what is made after them.
    struct Part {
        std::size_t from = 0, to = 0;  // of the old pages
        std::size_t shift = 0;         // of their blocks' numbers
        std::optional<PageStart> next; // nothing: they are the last
    };
    // Those before the first change.
    [[nodiscard]] std::optional<Part> first() const;
    // Those that follow a page that begins so.
    [[nodiscard]] std::optional<Part> met(const PageStart& start);

    [[nodiscard]] const Pages& pages() const { return old_; }
    [[nodiscard]] PageStart startOf(std::size_t page, std::size_t shift) const;
    // The old page that begins about there.
    [[nodiscard]] std::size_t behind(const PageStart& start) const;

private:
    [[nodiscard]] const std::vector<PageStart>& starts() const { return old_.basis->starts; }
    [[nodiscard]] Part before(std::size_t hunk, std::size_t from, std::size_t shift) const;

    Pages old_;
    std::vector<Hunk> hunks_;
    std::size_t passed_ = 0; // hunks
};

} // namespace layout

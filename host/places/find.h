// The places of words on the pages.
#pragma once

#include "excerpts/selected.h"
#include "layout/pages.h"

#include <optional>
#include <span>

namespace places {

struct Search {
    QString words{};
    bool matchesCase = false;
    bool isWhole = false; // no letter or digit stands beside it

    bool operator==(const Search&) const = default;
};

struct Found {
    // In one line.
    struct Part {
        std::shared_ptr<const paragraphs::Paragraph> paragraph;
        int line = 0, from = 0, to = 0;      // letters of the paragraph
        QPointF at;                          // the top left of the line
        [[nodiscard]] double bottom() const; // cheap, where the place in the line is not
        [[nodiscard]] QRectF rect() const;
    };
    std::size_t page = 0;
    std::vector<Part> parts; // in twips on that page
    int from = 0, to = 0;    // letters of the paragraph, on the next page, too
};

// In the order of the pages, headers and footers left out. A word that goes on on the next page is
// marked on the first.
[[nodiscard]] std::vector<Found> findText(const layout::Pages& pages, const Search& search);
[[nodiscard]] inline std::vector<Found> findText(const layout::Pages& pages, const QString& words) {
    return findText(pages, Search{words});
}

// The bytes of the document that were found; nothing: some of it is generated.
[[nodiscard]] std::optional<text::Range> placesOf(const Found& found,
                                                  const model::RunPlaces& places);
// The same of letters of a paragraph.
[[nodiscard]] std::optional<text::Range> placesOf(const paragraphs::Paragraph& of, int from, int to,
                                                  const model::RunPlaces& places);

// The same for pages that change: those that stay are not read again.
class Finder {
public:
    void look(const Search& search, const layout::Pages& pages);
    void follow(const layout::Pages& pages);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] const Found& at(std::size_t index) const;
    [[nodiscard]] std::span<const Found> on(std::size_t page) const;
    // Of the first one on that page or behind it.
    [[nodiscard]] std::size_t firstFrom(std::size_t page) const;
    // Since it was made, for tests.
    [[nodiscard]] std::size_t pagesRead() const { return pagesRead_; }

private:
    struct OnPage {
        std::shared_ptr<const layout::Page> page;
        std::vector<Found> found;
        std::size_t before = 0; // on the pages before it
    };

    Search search_;
    std::vector<OnPage> pages_;
    std::size_t count_ = 0;
    std::size_t pagesRead_ = 0;
};

} // namespace places

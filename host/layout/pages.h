// The pages of a document: every piece with its place.
//
// Strips go onto pages from the top, by a first fit that keeps together what asks for it: headings
// with what follows, at least two lines of a paragraph, a picture with its caption. A figure for
// which there is no room is put at the top of the next page, and the text after it fills the page
// before. Footnotes stand on the page of their mark; of what does not fit there, and of a table's
// row that is taller than a page, the rest goes on to the next pages. All of it is linear in the
// size of the document, and may be done in slices: see Pagination.
#pragma once

#include "layout/flow.h"

namespace layout {

struct Page {
    std::vector<Piece> pieces; // in twips from the page's top left, in painting order
};

struct PlacedSubdocument {
    document::SubdocumentId subdocument = document::noSubdocument;
    std::size_t page = 0;
    QRectF rect;
};

struct Heading {
    QString text;
    int level = 0;
    std::size_t page = 0;
    double top = 0;
};

struct Pages {
    QSizeF size; // of each, in twips
    QColor paper;
    std::vector<Page> pages;
    std::vector<PlacedSubdocument> subdocuments; // in order of place
    std::vector<Heading> outline;
    std::map<std::string, std::pair<std::size_t, double>> anchors; // page and height on it
    Work work;
};

[[nodiscard]] Pages layOut(const document::Model& model, const Objects& objects);

// The same a little at a time, from the first page to the last. Headers and footers come at the
// end, when the number of pages is known. Model and objects are read until then.
class Pagination {
public:
    Pagination(const document::Model& model, const Objects& objects);
    ~Pagination();
    Pagination(const Pagination&) = delete;
    Pagination& operator=(const Pagination&) = delete;

    // Some paragraphs' or a page's worth of work; false: there is none left.
    [[nodiscard]] bool step();
    // All but the last of them are full.
    [[nodiscard]] const Pages& pages() const;
    [[nodiscard]] Pages take();

private:
    std::unique_ptr<class Paginator> paginator_;
};

// The run under a point of a page, or nullptr.
[[nodiscard]] const document::Run* runAt(const Page& page, QPointF point);

// One line per piece (for tests).
[[nodiscard]] std::string printed(const Pages& pages);

} // namespace layout

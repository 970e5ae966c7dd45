// The pages of a document: every piece with its place.
//
// Strips go onto pages from the top, by a first fit that keeps together what asks for it: headings
// with what follows, at least two lines of a paragraph, a picture with its caption. A figure that
// may float and has no room is put at the top of the next page, and the text after it fills the
// page before. Footnotes stand on the page of their mark; of what does not fit there, and of a
// table's row that is taller than a page, the rest goes on to the next pages. All of it is linear
// in the size of the document, and may be done in slices: see Pagination.
//
// Pages follow a change of the model. Those before the first changed block stay. From there on
// pages are filled until one begins as an old one did, with the same blocks behind it; the old ones
// follow it up to the next change. Blocks are the same when their pointers are.
#pragma once

#include "layout/headers.h"
#include "strips/work.h"

#include <QColor>

namespace layout {

struct Heading {
    QString text;
    int level = 0;
    double top = 0;
};

// A subdocument or an image on a page.
struct PlacedObject {
    document::SubdocumentId subdocument = document::noSubdocument;
    std::string image{}; // its source
    QRectF rect;
    const model::Block* block = nullptr; // of the model, that it or its mark is in; to compare
    sgml::NodeId element = sgml::noNode; // of an image
    schemas::Align align = schemas::Align::left;
};

// Rows of a table that stand on a page, one below the other.
struct PlacedRows {
    std::shared_ptr<const Columns> columns;
    double left = 0, top = 0, bottom = 0;
};

// Knows nothing of other pages, nor how many there are before it.
struct Page {
    std::vector<Piece> pieces; // in twips from the page's top left, in painting order; no headers
    std::vector<PlacedObject> objects;
    std::vector<Heading> headings;
    std::vector<std::pair<std::string, double>> anchors; // and the height on it
    std::vector<PlacedRows> tables;                      // LIMIT: not those in cells
    bool hasPageNumbers = false; // of other pages: it looks otherwise when these change
};

struct PlacedSubdocument {
    document::SubdocumentId subdocument = document::noSubdocument;
    std::size_t page = 0;
    QRectF rect;
};

struct OutlineEntry {
    std::size_t page = 0;
    Heading heading;
};

struct Basis; // what pages were made of: what the next ones begin with

struct Pages {
    QSizeF size; // of each, in twips
    QColor paper;
    std::vector<std::shared_ptr<const Page>> pages;
    std::shared_ptr<const Headers> headers; // null while there are no pages
    std::shared_ptr<const Basis> basis;     // null while pages are missing
    Work work;                              // for those that were made last

    // With the headers and footers, which come last.
    [[nodiscard]] std::vector<TextPiece> headersOf(std::size_t page) const;
    // Over all pages, in order of place. Each takes a look at every page.
    [[nodiscard]] std::vector<PlacedSubdocument> subdocuments() const;
    [[nodiscard]] std::vector<OutlineEntry> outline() const;
    [[nodiscard]] std::optional<std::pair<std::size_t, double>>
    anchor(const std::string& name) const; // page and height on it
};

using ModelPointer = std::shared_ptr<const model::Model>;

[[nodiscard]] Pages layOut(const ModelPointer& model, const paragraphs::Objects& objects);

// The pages of `model`, of which as many as possible are those of `old`.
[[nodiscard]] Pages relaid(const Pages& old, const ModelPointer& model,
                           const paragraphs::Objects& objects);

// The same a little at a time, from the first page that is made to the last.
class Pagination {
public:
    Pagination(const ModelPointer& model, const paragraphs::Objects& objects,
               const Pages& old = {});
    ~Pagination();
    Pagination(const Pagination&) = delete;
    Pagination& operator=(const Pagination&) = delete;

    // Some paragraphs' or a page's worth of work; false: there is none left.
    [[nodiscard]] bool step();
    // So far. Pages that are not made yet are old, if there are old ones.
    [[nodiscard]] Pages pages() const;
    [[nodiscard]] std::size_t count() const; // of pages that are made
    [[nodiscard]] Pages take();

private:
    std::unique_ptr<class Paginator> paginator_;
};

// The run under a point of a page, or nullptr.
[[nodiscard]] const model::Run* runAt(const Page& page, QPointF point);

// One line per piece (for tests).
[[nodiscard]] std::string printed(const Pages& pages);

} // namespace layout

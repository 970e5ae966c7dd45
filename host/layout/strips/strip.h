// Pages are filled with strips, one above the other: a line of text, a rendition, a row of a table.
// A strip says how much space it wants to its neighbours and whether it may be the last on its
// page. It stands on one page; only a row that is taller than a page is divided, between the lines
// of its cells.
#pragma once

#include "paragraphs/paragraph.h"

#include <variant>

namespace layout {

struct TextPiece {
    std::shared_ptr<const paragraphs::Paragraph> paragraph;
    int line = 0;
    QPointF at;              // its top left
    bool isRepeated = false; // of a table's header, on a later page: it has no places of its own
    bool isOfNote = false;   // of a footnote
    [[nodiscard]] const paragraphs::Paragraph::Line& letters() const {
        return paragraph->lines()[static_cast<std::size_t>(line)];
    }
};
struct SubdocumentPiece {
    document::SubdocumentId subdocument = document::noSubdocument;
    QRectF rect;
    schemas::Align align = schemas::Align::left; // in its room
};
struct ImagePiece {
    std::string source; // as Objects::imageSize was asked
    QRectF rect;
    QString alternative; // shown when there is no picture
    sgml::NodeId element = sgml::noNode;
    schemas::Align align = schemas::Align::left; // in its room
};
// Filled, and with those of its sides stroked that the border has.
struct FramePiece {
    QRectF rect;
    std::optional<schemas::Color> background;
    schemas::Border border;
};
// The number of the page that an anchor is on, at the right end of a line, and dots that lead to
// it.
struct PageNumberPiece {
    std::string target; // Pages::anchor()
    schemas::TextStyle style;
    QRectF rect; // from the end of the line's text
    double baseline = 0;
};
using Piece = std::variant<FramePiece, TextPiece, SubdocumentPiece, ImagePiece, PageNumberPiece>;

[[nodiscard]] Piece moved(Piece piece, QPointF by);

class Cells;
struct Columns;

struct Strip {
    double height = 0;
    double before = 0, after = 0; // the larger of two that meet counts
    bool keepWithNext = false;
    bool keepWithNextLine = false; // also where all that keeps together is taller than a page
    bool breakBefore = false;
    bool mayFloat = false; // begins a figure, which may stand at the top of the next page
    bool firstOfBlock = false, lastOfBlock = false;
    std::size_t block = 0; // index into the model's blocks; of a table's rows all the same
    // Then the space before it counts at the top of its page, too.
    [[nodiscard]] bool beginsDocument() const { return firstOfBlock && block == 0; }
    std::vector<Piece> pieces;
    std::vector<std::shared_ptr<const model::Footnote>> footnotes;
    std::shared_ptr<Cells> cells; // instead of pieces: too tall for a page; taken in parts
    std::shared_ptr<const Columns> columns; // of a table's row
    double left = 0;                        // of these
    std::shared_ptr<const Strip> header;    // of a table: above this at the top of a page
};

} // namespace layout

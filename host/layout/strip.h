// What pages are filled with: strips, one above the other, each of which stands on one page.
// A line of text is a strip, a rendition is one, a row of a table is one. A strip says how much
// space it wants to its neighbours and whether it may be the last on its page.
#pragma once

#include "layout/paragraph.h"

#include <QImage>
#include <variant>

namespace layout {

struct TextPiece {
    std::shared_ptr<const Paragraph> paragraph;
    int line = 0;
    QPointF at; // its top left
};
struct SubdocumentPiece {
    document::SubdocumentId subdocument = document::noSubdocument;
    QRectF rect;
};
struct ImagePiece {
    QImage image;
    QRectF rect;
    QString alternative; // shown when there is no image
};
// Filled, and with those of its sides stroked that the border has.
struct FramePiece {
    QRectF rect;
    std::optional<document::Color> background;
    document::Border border;
};
using Piece = std::variant<FramePiece, TextPiece, SubdocumentPiece, ImagePiece>;

[[nodiscard]] Piece moved(Piece piece, QPointF by);

struct Strip {
    double height = 0;
    double before = 0, after = 0; // the larger of two that meet counts
    bool keepWithNext = false;
    bool breakBefore = false;
    bool mayFloat = false; // begins a figure, which may stand at the top of the next page
    std::size_t block = 0; // index into the model's blocks; of a table's rows all the same
    std::vector<Piece> pieces;
    std::vector<std::size_t> footnotes;
};

struct StripBuilder {
    const document::Model& model;
    const Objects& objects;
    double width = 0;      // of the text area
    double mostHeight = 0; // of a picture

    [[nodiscard]] std::vector<Strip> strips(const std::vector<document::Block>& blocks) const;

private:
    void text(const document::Block& block, std::vector<Strip>& into) const;
    void addMarker(const document::Block& block, Strip& strip, double lineBaseline) const;
    void subdocument(const document::Block& block, std::vector<Strip>& into) const;
    void image(const document::Block& block, std::vector<Strip>& into) const;
    void rule(const document::Block& block, std::vector<Strip>& into) const;
    void table(const document::Block& block, std::vector<Strip>& into) const;
    [[nodiscard]] std::vector<double> columns(const document::Block& block, double room) const;
    [[nodiscard]] Strip row(const document::Row& row, const std::vector<double>& columns,
                            double left) const;
    [[nodiscard]] double left(const document::Block& block) const;
    [[nodiscard]] double room(const document::Block& block) const;
    [[nodiscard]] double aligned(const document::Block& block, double itsWidth) const;
};

// Strips below each other without page breaks: the content of a cell, a footnote.
struct Stack {
    double height = 0;
    std::vector<Piece> pieces;
    std::vector<std::size_t> footnotes;
};
[[nodiscard]] Stack stacked(const std::vector<Strip>& strips);

} // namespace layout

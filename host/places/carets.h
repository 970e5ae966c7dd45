// Places of a caret between letters on the pages: which byte of the document is there, and where
// the caret goes.
//
// A caret stands in text of the document, never inside what is generated. Between two texts it
// belongs to the end of the first. Where no text is, as behind a formula or a footnote's mark that
// ends its line, it stands beside the element of that unit. Any other place of the document
// (between paragraphs, in blanks that are shown as one) has the nearest caret.
#pragma once

#include "excerpts/selected.h"
#include "layout/pages.h"

namespace places {

struct Caret {
    std::size_t page = 0;
    std::size_t piece = 0; // of the page, a TextPiece
    int letter = 0;        // of its paragraph: the caret stands before it
    bool operator==(const Caret&) const = default;
};

enum class Move {
    left, // as the line looks, whatever the direction of its letters
    right,
    wordLeft,
    wordRight,
    up,
    down,
    lineStart,
    lineEnd,
    documentStart,
    documentEnd,
};

class Carets {
public:
    // Both are read as long as this lives. The tree is that of the pages, or a later one: then text
    // that is gone from it has no caret.
    Carets(const layout::Pages& pages, const sgml::Tree& tree)
        : pages_(pages), tree_(tree), places_(tree) {}

    // Nearest to a point of a page, in twips; nothing: there is no text on any page.
    [[nodiscard]] std::optional<Caret> at(std::size_t page, QPointF point) const;
    // Is the point on the last page, below all that stands there?
    [[nodiscard]] bool isBelowAll(std::size_t page, QPointF point) const;
    // At a place in the document's bytes, looked for from that page on to both sides.
    [[nodiscard]] std::optional<Caret> of(std::size_t place, std::size_t page) const;
    [[nodiscard]] std::size_t placeOf(const Caret& caret) const;

    // In twips of its page, as high as its line, without a width.
    [[nodiscard]] QRectF rectOf(const Caret& caret) const;
    // The same place where it cannot go there. `x`: where it would like to be, for up and down.
    [[nodiscard]] Caret moved(const Caret& caret, Move move, double x = 0) const;
    // The carets around a word or the blanks between two words, and around a paragraph.
    [[nodiscard]] std::pair<Caret, Caret> wordAt(const Caret& caret) const;
    [[nodiscard]] std::pair<Caret, Caret> paragraphAt(const Caret& caret) const;

    // The part of a page that lies in an interval of the document's bytes, in twips. A paragraph's
    // end that is selected is shown behind its last line.
    [[nodiscard]] std::vector<QRectF> selected(std::size_t page, text::Range interval) const;

private:
    using Line =
        std::pair<const layout::TextPiece*, std::size_t>; // a piece with places, and its index
    enum class Search { before, behind, nearest };

    [[nodiscard]] const layout::TextPiece& pieceOf(const Caret& caret) const;
    [[nodiscard]] std::vector<Line> linesOn(std::size_t page) const;
    [[nodiscard]] bool hasPlaces(const paragraphs::Paragraph& paragraph) const;
    // In a line; a display is a block of its own.
    [[nodiscard]] bool isUnitIn(const paragraphs::Paragraph& paragraph,
                                const model::Run& run) const;
    // The run of text that the place belongs to; nothing: none ends or begins there.
    [[nodiscard]] std::optional<std::size_t> runAt(const paragraphs::Paragraph& paragraph,
                                                   int letter) const;
    // The place of the document; nothing: it is in what is generated.
    [[nodiscard]] std::optional<std::size_t> placeAt(const paragraphs::Paragraph& paragraph,
                                                     int letter) const;
    [[nodiscard]] std::optional<int> placeFrom(const paragraphs::Paragraph& paragraph, int letter,
                                               Search search) const;
    [[nodiscard]] std::optional<Caret> caretIn(const paragraphs::Paragraph& paragraph, int letter,
                                               std::size_t page) const;
    [[nodiscard]] std::optional<Caret> inContent(sgml::NodeId content, std::size_t place,
                                                 std::size_t page) const;
    // Of a unit that begins or ends at the place.
    [[nodiscard]] std::optional<Caret> besideUnit(std::size_t place, std::size_t page) const;
    // The first caret that a paragraph has, from that page on to both sides; each is asked once on
    // a page.
    template <typename Find>
    [[nodiscard]] std::optional<Caret> inParagraphs(std::size_t page, const Find& find) const;
    [[nodiscard]] std::optional<Caret> nearestTo(std::size_t place) const;
    [[nodiscard]] std::optional<Caret> nextParagraph(const Caret& caret) const;
    [[nodiscard]] std::optional<Caret> previousParagraph(const Caret& caret) const;
    [[nodiscard]] std::optional<Caret> firstOn(std::size_t page) const;
    // By the order of the document.
    [[nodiscard]] std::optional<Caret> lastOn(std::size_t page) const;
    [[nodiscard]] Caret sideways(const Caret& caret, Move move) const;
    [[nodiscard]] Caret vertically(const Caret& caret, Move move, double x) const;
    [[nodiscard]] Caret inLine(std::size_t page, const Line& line, double x) const;
    void addSelected(const layout::TextPiece& piece, const std::vector<model::SelectedRun>& runs,
                     text::Range interval, std::vector<QRectF>& result) const;

    const layout::Pages& pages_;
    const sgml::Tree& tree_;
    model::RunPlaces places_;
};

} // namespace places

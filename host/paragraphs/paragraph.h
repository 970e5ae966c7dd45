// Runs of a block broken into lines of a width. typography says where lines end; Qt's text layout
// measures the words, and places and paints the letters of each line.
// An image or a formula in a line is a blank of its width there; the line grows to its height.
//
// Lines are made as they are asked for. A paragraph is laid out in segments of some thousand
// letters; what a segment's end cuts, its last line, is where the next segment begins. So the first
// page of a text costs what stands on that page, and the whole costs what its length does, however
// long it is and without any blank. Lines are the best ones together within a segment.
//
// A line is kept as its place in the text and its height. Its letters, and Qt's layout of them, are
// kept of those paragraphs alone that were asked for last, and are made again when one is painted:
// so a long document keeps what its windows show.
#pragma once

#include "paragraphs/run_letters.h"

#include <QTextLayout>
#include <unordered_map>

namespace paragraphs {

// Of a text without breaks, of its widest word, and of its widest number.
struct Widths {
    double natural = 0, least = 0, number = 0;
};

class Paragraph final : private Kept::Owner {
public:
    // `markerInFront`: the block's marker is set before its runs, on the first line.
    Paragraph(std::shared_ptr<Materials> materials, BlockPointer block, double width,
              bool markerInFront = false);
    ~Paragraph();
    Paragraph(const Paragraph&) = delete;
    Paragraph& operator=(const Paragraph&) = delete;

    struct Line {
        double height = 0;    // with its share of the space between lines
        double baseline = 0;  // below its top
        int from = 0, to = 0; // its letters
        int end = 0;          // of those that are shown: blanks where the line ends are not
        double stretch = 0;   // of its blanks, in parts of their width; negative: they shrink
        double apart = 0;     // by how much its letters move apart
        bool hyphen = false;  // ends within a word: a hyphen is shown that is no letter
    };
    // Makes lines up to this one; false: there are fewer.
    bool makeLine(std::size_t line);
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; } // that are made
    [[nodiscard]] std::span<const InlineObject> objectsOf(int line) const;
    [[nodiscard]] std::span<const NoteMark> notesOf(int line) const;
    // Letters given to the text layout for lines so far: those of a segment's last line twice.
    [[nodiscard]] std::size_t lettersShaped() const { return lettersShaped_; }
    // Of the widest line; of the widest word, and of words between which no line ends; of the
    // widest number.
    [[nodiscard]] const Widths& widths() const { return widths_; }
    [[nodiscard]] double naturalWidth() const { return widths_.natural; }
    // Are the objects in it as large as they were when it was made?
    [[nodiscard]] bool isOf(Sizes& sizes) const;

    void paintLine(QPainter& painter, int line, QPointF topLeft) const;
    // The place of an object of a line, the line's top left at the origin.
    [[nodiscard]] QRectF objectRect(int line, const InlineObject& object) const;

    [[nodiscard]] const BlockPointer& block() const { return letters_.block(); }
    // The look that its runs call by that number.
    [[nodiscard]] const schemas::TextStyle& style(std::uint32_t number) const {
        return materials().looks.style(number);
    }
    // The run that the letter at `x` belongs to, or nullptr.
    [[nodiscard]] const model::Run* runAt(int line, double x) const;
    // So many letters from there on, as far as there are.
    [[nodiscard]] QString text(int from, int count) const;
    [[nodiscard]] QString textOfLine(int line) const;
    // The letters [first, second) that stand on it, and where one begins in it.
    [[nodiscard]] std::pair<int, int> rangeOfLine(int line) const;
    [[nodiscard]] double leftOf(int line, int position) const;
    // Of its letters as they are painted, also where they go beyond the line's end.
    [[nodiscard]] double widthOfLine(int line) const { return drawn(line).horizontalAdvance(); }

    // --- places between letters, for a caret
    [[nodiscard]] double width() const { return letters_.width(); } // that lines are broken to
    [[nodiscard]] bool isRightToLeft() const;
    [[nodiscard]] int startOfRun(std::size_t run) const { return letters_.startOfRun(run); }
    [[nodiscard]] int endOfRun(std::size_t run) const { return letters_.endOfRun(run); }
    // Between the letters of a run and the bytes of its text.
    [[nodiscard]] int letterAt(std::size_t run, std::size_t byte) const {
        return letters_.letterAt(run, byte);
    }
    [[nodiscard]] std::size_t byteAt(std::size_t run, int letter) const {
        return letters_.byteAt(run, letter);
    }
    // The line that the place before the letter is on: of two, the later one.
    [[nodiscard]] int lineOf(int letter) const;
    // The place nearest to `x`, and the one that the caret at a line's end has.
    [[nodiscard]] int placeAt(int line, double x) const;
    [[nodiscard]] int endOfLine(int line) const;
    enum class Side { left, right };
    // The next place to that side as the line looks, where a letter with its accents is one; the
    // same place at the paragraph's end.
    [[nodiscard]] int placeBeside(int letter, Side side) const;
    // The beginning of the next word, or of the one before it; the same place at the paragraph's
    // end.
    [[nodiscard]] int nextWord(int letter) const;
    [[nodiscard]] int previousWord(int letter) const;
    // The edges of a letter in its line, from left to right.
    [[nodiscard]] std::pair<double, double> edgesOf(int line, int letter) const;

    static constexpr int segmentLength = 8192; // letters
    // Pieces of different looks, since the text layout's effort grows with their square.
    static constexpr int segmentFormats = 2048;

    // Of all paragraphs together, for tests.
    static constexpr std::size_t mostKept = 2 * Kept::most;
    [[nodiscard]] static std::size_t lettersKept();
    [[nodiscard]] static std::size_t layoutsMade(); // so far, those made again included

private:
    class Breaking; // of a segment into lines
    // A line's letters in their places, between marks that make them go in the directions that they
    // have in the paragraph.
    struct Drawn {
        std::unique_ptr<QTextLayout> layout;
        int marks = 0; // in front of the letters
        Kept::Place kept{};
    };

    [[nodiscard]] Materials& materials() const { return letters_.materials(); }
    [[nodiscard]] std::uint32_t firstStyle() const; // of its first letter
    void breakSegment();
    [[nodiscard]] int lengthOfSegment(const Letters& letters) const;
    [[nodiscard]] double indentOf(int from) const;
    [[nodiscard]] QTextOption optionOf() const;
    [[nodiscard]] std::unique_ptr<QTextLayout>
    layoutFor(const QString& text, const QList<QTextLayout::FormatRange>& formats,
              const QTextOption& option) const;
    [[nodiscard]] std::unique_ptr<QTextLayout> shaped(const Line& line, int& marks) const;
    static QList<QTextLayout::FormatRange> formatsOf(const Letters& letters, int from, int to,
                                                     double stretch = 0, double apart = 0);
    void measure(Line& line, double ascent, double descent);
    [[nodiscard]] std::pair<double, double> extentOf(const Line& line, double ascent,
                                                     double descent) const;
    void makeRoom(Line& line, const InlineObject& object) const;
    void paintFormulas(QPainter& painter, int line, QPointF topLeft) const;
    [[nodiscard]] const Drawn& drawnOf(int line) const;
    [[nodiscard]] QTextLine drawn(int line) const { return drawnOf(line).layout->lineAt(0); }
    // Between letters of the paragraph and those of a line's layout.
    [[nodiscard]] int inLayout(int line, int letter) const;
    [[nodiscard]] int fromLayout(int line, int position) const;
    void forget(int line) const override;

    static inline std::size_t layoutsMade_ = 0;

    RunLetters letters_;
    double leading_ = 0;
    bool complete_ = false;
    int next_ = 0; // the first letter without a line
    Qt::LayoutDirection direction_ = Qt::LayoutDirectionAuto;
    Widths widths_;
    std::size_t lettersShaped_ = 0;
    std::vector<Line> lines_;
    mutable std::unordered_map<int, Drawn> drawn_; // by line
};

// Of its first `letters`, from which those that are read are taken off.
[[nodiscard]] Widths widthsOf(const std::shared_ptr<Materials>& materials,
                              const model::Block& block, std::size_t& letters);

} // namespace paragraphs

// Runs of a block broken into lines of a width, by Qt's text layout.
// A subdocument within a line is a blank of its width; the line grows to its height.
//
// Lines are made as they are asked for. A paragraph is laid out in segments of some thousand
// letters; what a segment's end cuts, its last line, is where the next segment begins. So the first
// page of a text costs what stands on that page, and the whole costs what its length does, however
// long it is and without any blank. LIMIT: marks for the direction of writing that enclose more
// than a segment count in their segment.
//
// A line is kept as its place in the text and its height. Its letters, and Qt's layout of them, are
// kept of those paragraphs alone that were asked for last, and are made again when one is painted:
// so a long document keeps what its windows show.
#pragma once

#include "formulas/typeset.h"
#include "layout/materials.h"

#include <QTextLayout>
#include <list>
#include <memory>
#include <span>

namespace layout {

using BlockPointer = std::shared_ptr<const model::Block>;

// A subdocument, or a piece of a formula.
struct InlineObject {
    std::size_t run = 0;
    int position = 0; // of its blank in the paragraph's text
    QSizeF size;
    double left = 0;                                // of its blank in its line
    double depth = 0;                               // of its size, below the base line
    std::shared_ptr<const formulas::Set> formula{}; // null: a subdocument
    std::size_t piece = 0;                          // of the formula
};

struct NoteMark {
    int position = 0;
    std::shared_ptr<const model::Footnote> note;
};

class Paragraph {
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
        int segment = 0;      // where these are
        int index = 0;        // in it
    };
    // Makes lines up to this one; false: there are fewer.
    bool makeLine(std::size_t line);
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; } // that are made
    [[nodiscard]] std::span<const InlineObject> objectsOf(int line) const;
    [[nodiscard]] std::span<const NoteMark> notesOf(int line) const;
    // Letters given to the text layout for lines so far: those of a segment's last line twice.
    [[nodiscard]] std::size_t lettersShaped() const { return lettersShaped_; }
    [[nodiscard]] double naturalWidth() const { return naturalWidth_; } // of the widest line
    [[nodiscard]] double leastWidth() const { return leastWidth_; }     // of the widest word
    // Are the objects in it as large as they were when it was made?
    [[nodiscard]] bool isOf(Sizes& sizes) const;

    void paintLine(QPainter& painter, int line, QPointF topLeft) const;
    // Where an object of a line stands, the line's top left at the origin.
    [[nodiscard]] QRectF objectRect(int line, const InlineObject& object) const;

    [[nodiscard]] const BlockPointer& block() const { return block_; }
    // The run that the letter at `x` belongs to, or nullptr.
    [[nodiscard]] const model::Run* runAt(int line, double x) const;
    // So many letters from there on, as far as there are.
    [[nodiscard]] QString text(int from, int count) const;
    [[nodiscard]] QString textOfLine(int line) const;
    // The letters [first, second) that stand on it, and where one begins in it.
    [[nodiscard]] std::pair<int, int> rangeOfLine(int line) const;
    [[nodiscard]] double leftOf(int line, int position) const;

    // --- places between letters, for a caret
    [[nodiscard]] double width() const { return width_; } // that lines are broken to
    [[nodiscard]] bool isRightToLeft() const;
    [[nodiscard]] int startOfRun(std::size_t run) const; // in letters
    [[nodiscard]] int endOfRun(std::size_t run) const;
    // Between the letters of a run and the bytes of its text.
    [[nodiscard]] int letterAt(std::size_t run, std::size_t byte) const;
    [[nodiscard]] std::size_t byteAt(std::size_t run, int letter) const;
    // The line that the place before the letter is on: of two, the later one.
    [[nodiscard]] int lineOf(int letter) const;
    // The place nearest to `x`, and the one that the caret at a line's end has.
    [[nodiscard]] int placeAt(int line, double x) const;
    [[nodiscard]] int endOfLine(int line) const;
    enum class Side { left, right };
    // The next place to that side as the line looks, where a letter with its accents is one; the
    // same place at the paragraph's end.
    [[nodiscard]] int placeBeside(int letter, Side side) const;
    // Where the next word begins, or the one before it; the same place at the paragraph's end.
    [[nodiscard]] int nextWord(int letter) const;
    [[nodiscard]] int previousWord(int letter) const;
    // The edges of a letter in its line, from left to right.
    [[nodiscard]] std::pair<double, double> edgesOf(int line, int letter) const;

    static constexpr int segmentLength = 8192; // letters
    // Pieces of different looks, since the text layout's effort grows with their square.
    static constexpr int segmentFormats = 2048;

    // Letters that all paragraphs together keep, and keep laid out: those of some fifty pages.
    // The one that is asked for is kept, however long it is.
    static constexpr std::size_t mostKept = 200'000;
    [[nodiscard]] static std::size_t lettersKept();
    [[nodiscard]] static std::size_t layoutsMade(); // so far, those made again included

private:
    static constexpr int ofLetters = -1; // instead of a segment's index
    class Kept;
    struct KeptItem { // letters, or the layout of a segment, of one of all paragraphs
        const Paragraph* of = nullptr;
        int segment = ofLetters;
        std::size_t letters = 0;
    };
    using KeptPlace = std::list<KeptItem>::iterator;
    struct Letters {
        QString text;
        QList<QTextLayout::FormatRange> formats;
        std::vector<int> runStarts;             // of the runs that are read, in order of place
        std::optional<std::uint32_t> lastStyle; // of the last format, unless it is an object
        std::optional<KeptPlace> kept;          // once the last line is made
    };
    struct Segment {
        int from = 0, length = 0;
        std::unique_ptr<QTextLayout> layout{}; // null: it is made again when it is asked for
        KeptPlace kept{};                      // of the layout
    };

    const Letters& read(int to, std::size_t runs = 0) const;
    struct InSegment { // a place in a text layout
        const QTextLayout& layout;
        int from = 0; // the letter that it begins with
    };
    [[nodiscard]] InSegment segmentAt(int letter) const;
    void append(std::size_t index) const;
    void appendFormula(std::size_t index) const;
    void appendBlank(QChar sign, double width, QTextCharFormat format) const;
    [[nodiscard]] std::shared_ptr<const formulas::Set> formulaOf(std::size_t run,
                                                                 int position) const;
    [[nodiscard]] QSizeF sizeOfObject(std::size_t run, int position) const;
    void breakSegment();
    [[nodiscard]] int lengthOfSegment(const Letters& letters) const;
    [[nodiscard]] std::unique_ptr<QTextLayout> shaped(int from, int length) const;
    [[nodiscard]] double indentOf(int from) const;
    [[nodiscard]] const QTextLayout& layoutOf(int segment) const;
    static QList<QTextLayout::FormatRange> formatsOf(const Letters& letters, int from, int to);
    void measure(Line& line, const QTextLine& drawn);
    [[nodiscard]] std::pair<double, double> extentOf(const Line& line, const QTextLine& of) const;
    void makeRoom(Line& line, const InlineObject& formula) const;
    void paintFormulas(QPainter& painter, int line, QPointF topLeft) const;
    [[nodiscard]] QTextLine drawn(int line) const;
    void forget(int segment) const;

    std::shared_ptr<Materials> materials_;
    BlockPointer block_;
    double width_ = 0;
    double leading_ = 0;
    bool markerInFront_ = false;
    bool complete_ = false;
    int next_ = 0; // the first letter without a line
    Qt::LayoutDirection direction_ = Qt::LayoutDirectionAuto;
    double naturalWidth_ = 0, leastWidth_ = 0;
    std::size_t lettersShaped_ = 0;
    std::vector<Line> lines_;
    mutable std::vector<InlineObject> objects_; // of the runs that were ever read, like the marks
    mutable std::vector<NoteMark> marks_;
    mutable std::size_t runsRead_ = 0;
    mutable std::vector<Segment> segments_;
    mutable std::unique_ptr<Letters> letters_;
};

// The width of a text without breaks, and of its longest word.
struct Widths {
    double natural = 0, least = 0;
};
// Of its first `letters`, from which those that are read are taken off.
[[nodiscard]] Widths widthsOf(const std::shared_ptr<Materials>& materials,
                              const model::Block& block, std::size_t& letters);

} // namespace layout

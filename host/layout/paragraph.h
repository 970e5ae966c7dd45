// Runs of a block broken into lines of a width, by Qt's text layout.
// A subdocument within a line is a blank of its width; the line grows to its height.
//
// Lines are made as they are asked for. A paragraph is laid out in segments of some thousand
// letters; what a segment's end cuts, its last line, is where the next segment begins. So the first
// page of a text costs what stands on that page, and the whole costs what its length does, however
// long it is and without any blank. LIMIT: marks for the direction of writing that enclose more
// than a segment count in their segment.
#pragma once

#include "document/model.h"

#include <QTextLayout>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace layout {

// What the layout must be told about things that are not letters.
struct Objects {
    std::function<QSizeF(document::SubdocumentId)> subdocumentSize; // in twips
    // In pixels, of 1/96 inch; empty: there is no such picture.
    std::function<QSize(const std::string& source)> imageSize;
};

struct InlineObject {
    std::size_t run = 0;
    int position = 0; // of its blank in the paragraph's text
    QSizeF size;
};

class Paragraph {
public:
    // `prefix` is generated text in front of the runs, set in `prefixStyle`. Model and objects are
    // read until the last line is made.
    Paragraph(const document::Model& model, const document::Block& block, double width,
              const Objects& objects, const QString& prefix = {});

    struct Line {
        double height = 0;   // with its share of the space between lines
        double baseline = 0; // below its top
        std::vector<InlineObject> objects;
        std::vector<std::shared_ptr<const document::Footnote>> footnotes;
        std::size_t segment = 0; // where its letters are
        int index = 0;
    };
    // Makes lines up to this one; false: there are fewer.
    bool makeLine(std::size_t line);
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; } // that are made
    // Letters given to the text layout so far: those of a segment's last line twice.
    [[nodiscard]] std::size_t lettersShaped() const { return lettersShaped_; }
    [[nodiscard]] double naturalWidth() const { return naturalWidth_; } // of the widest line
    [[nodiscard]] double leastWidth() const { return leastWidth_; }     // of the widest word

    void paintLine(QPainter& painter, int line, QPointF topLeft) const;
    // Where an object of a line stands, the line's top left at the origin.
    [[nodiscard]] QRectF objectRect(int line, const InlineObject& object) const;

    [[nodiscard]] const std::vector<document::Run>& runs() const { return runs_; }
    // The run that the letter at `x` belongs to, or nullptr.
    [[nodiscard]] const document::Run* runAt(int line, double x) const;
    [[nodiscard]] QString text() const { return text_; } // of the lines that are made, at least
    [[nodiscard]] QString textOfLine(int line) const;
    // The letters [first, second) of text() that stand on it, and where one begins in it.
    [[nodiscard]] std::pair<int, int> rangeOfLine(int line) const;
    [[nodiscard]] double leftOf(int line, int position) const;

    static constexpr int segmentLength = 8192; // letters
    // Pieces of different looks, since the text layout's effort grows with their square.
    static constexpr int segmentFormats = 2048;

private:
    struct Segment {
        int from = 0; // its first letter in text_
        std::unique_ptr<QTextLayout> layout;
    };
    void readRuns(int to);
    void append(std::size_t index);
    void breakSegment();
    [[nodiscard]] int lengthOfSegment() const;
    [[nodiscard]] QList<QTextLayout::FormatRange> formatsOf(int from, int to) const;
    [[nodiscard]] Line measured(const QTextLine& line, int from) const;
    [[nodiscard]] const QTextCharFormat& format(std::uint32_t style);
    [[nodiscard]] QTextLine drawn(int line) const;

    const document::Model& model_;
    const Objects& objectsOf_;
    document::BlockKind kind_;
    document::BlockStyle style_;
    double width_ = 0;
    QFont font_;
    double leading_ = 0;
    std::vector<document::Run> runs_;
    std::map<std::uint32_t, QTextCharFormat> styles_;
    // Of the runs that are read, in order of place.
    std::vector<int> runStarts_;
    QString text_;
    QList<QTextLayout::FormatRange> formats_;
    std::optional<std::uint32_t> lastStyle_; // of the last of these, unless it is an object
    std::vector<InlineObject> objects_;
    std::vector<std::pair<int, std::shared_ptr<const document::Footnote>>>
        footnotes_; // place of the mark, footnote
    std::vector<Segment> segments_;
    std::vector<Line> lines_;
    int next_ = 0; // the first letter without a line
    bool complete_ = false;
    std::size_t lettersShaped_ = 0;
    double naturalWidth_ = 0, leastWidth_ = 0;
};

// The width of a text without breaks, and of its longest word.
struct Widths {
    double natural = 0, least = 0;
};
// Of its first `letters`, from which those that are read are taken off.
[[nodiscard]] Widths widthsOf(const document::Model& model, const document::Block& block,
                              const Objects& objects, std::size_t& letters);

} // namespace layout

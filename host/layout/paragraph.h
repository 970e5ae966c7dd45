// Runs of a block broken into lines of a width, by Qt's text layout.
// A subdocument or image within a line is a blank of its width; the line grows to its height.
#pragma once

#include "document/model.h"

#include <QTextLayout>
#include <functional>
#include <memory>

namespace layout {

// What the layout must be told about things that are not letters, in twips.
struct Objects {
    std::function<QSizeF(document::SubdocumentId)> subdocumentSize;
    std::function<QImage(const std::string& source)> image;
};

struct InlineObject {
    std::size_t run = 0;
    int position = 0; // of its blank in the paragraph's text
    QSizeF size;
};

class Paragraph {
public:
    // `prefix` is generated text in front of the runs, set in `prefixStyle`.
    Paragraph(const document::Model& model, const document::Block& block, double width,
              const Objects& objects, const QString& prefix = {});

    struct Line {
        double height = 0;   // with its share of the space between lines
        double baseline = 0; // below its top
        std::vector<InlineObject> objects;
        std::vector<std::size_t> footnotes;
    };
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
    [[nodiscard]] double naturalWidth() const { return naturalWidth_; } // of the widest line
    [[nodiscard]] double leastWidth() const {
        return layout_->minimumWidth();
    } // of the widest word

    void paintLine(QPainter& painter, int line, QPointF topLeft) const;
    // Where an object of a line stands, the line's top left at the origin.
    [[nodiscard]] QRectF objectRect(int line, const InlineObject& object) const;

    [[nodiscard]] const std::vector<document::Run>& runs() const { return runs_; }
    // The run that the letter at `x` belongs to, or nullptr.
    [[nodiscard]] const document::Run* runAt(int line, double x) const;
    [[nodiscard]] QString text() const { return text_; }
    [[nodiscard]] QString textOfLine(int line) const;
    // The letters [first, second) of text() that stand on it, and where one begins in it.
    [[nodiscard]] std::pair<int, int> rangeOfLine(int line) const;
    [[nodiscard]] double leftOf(int line, int position) const;

private:
    void append(const document::Model& model, const document::Run& run, const Objects& objects);
    void breakLines(const document::Model& model, const document::Block& block, double width);
    [[nodiscard]] Line measured(const QTextLine& line, double leading) const;

    std::vector<document::Run> runs_;
    std::vector<int> runStarts_;
    QString text_;
    QList<QTextLayout::FormatRange> formats_;
    std::vector<InlineObject> objects_;
    std::unique_ptr<QTextLayout> layout_;
    std::vector<Line> lines_;
    double naturalWidth_ = 0;
};

// The width of a text without breaks, and of its longest word.
struct Widths {
    double natural = 0, least = 0;
};
[[nodiscard]] Widths widthsOf(const document::Model& model, const document::Block& block,
                              const Objects& objects);

} // namespace layout

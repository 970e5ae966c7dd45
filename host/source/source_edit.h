// A text to be typed in, as one reads it: letters of one width, numbers of the lines, colours of
// what is what, and faults underlined, with their sentences in tips.
//
// Colours are those of the lines that are seen, made when they are painted: a letter that makes all
// behind it something else costs no more than another one.
#pragma once

#include "source/line_marks.h"

#include <QPlainTextEdit>

#include <functional>
#include <map>

namespace source {

struct LineFault {
    int line = 0, column = 0; // from 1; columns in characters
    bool isError = false;
    QString sentence;
};

class SourceEdit : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit SourceEdit(QWidget* parent);

    // Asked for the marks of some lines from that one on (from 0), whenever these are painted.
    using Marker = std::function<std::vector<LineMarks>(int line, int count)>;
    void setMarker(Marker marker);
    void setFaults(const std::vector<LineFault>& faults);
    // The first fault of a line; "": none.
    [[nodiscard]] QString faultOf(int line) const;
    // The first error, else the first fault; line 0: there is none.
    [[nodiscard]] LineFault firstFault() const;
    // Why nothing may be typed, as a sentence; "": it may.
    void setWhyNotWritable(const QString& why);
    [[nodiscard]] const QString& whyNotWritable() const { return whyNot_; }
    // Behind the line of that place; -1: behind none.
    void setBand(int position);
    [[nodiscard]] int band() const { return band_; }
    // That line at the top, unless it is seen.
    void scrollToLine(int position);
    [[nodiscard]] bool isDark() const;

    void paintNumbers(QWidget& on, const QRect& area);
    [[nodiscard]] int numbersWidth() const;
    // Lines whose marks were asked for, for tests.
    [[nodiscard]] std::size_t linesMarked() const { return linesMarked_; }

Q_SIGNALS:
    void refused(const QString& why); // a sentence
    void left();                      // by Escape
    void saveWanted();                // by the keys of saving, where somebody listens

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    [[nodiscard]] bool saves(const QKeyEvent& event) const;
    void markSeen();
    void mark(const QTextBlock& block, const LineMarks& marks) const;
    void showBand();
    [[nodiscard]] std::pair<int, int> lettersOf(const QTextBlock& block,
                                                const LineFault& fault) const;

    QWidget* numbers_;
    Marker marker_;
    std::multimap<int, LineFault> faults_; // by line, from 0
    QString whyNot_;
    int band_ = -1;
    std::size_t linesMarked_ = 0;
};

} // namespace source

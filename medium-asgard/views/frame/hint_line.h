// The line about what the buttons do: parts with "  ·  " between them, the most important first.
//
// A narrow line has room for two or three lines of text, by its width alone: whatever is said, the
// picture above keeps its height. A text that is too long for it loses whole parts from its end,
// which a sign tells, and the tip has all of them; a first part that is too long itself loses its
// end.
#pragma once

#include <QWidget>

class QLabel;

namespace views {

class HintLine : public QWidget {
    Q_OBJECT
    Q_PROPERTY(QString text READ text)
public:
    explicit HintLine(QWidget* parent = nullptr);

    // A fault stands out.
    void say(const QString& parts, bool isFault = false);
    [[nodiscard]] const QString& all() const { return all_; }
    [[nodiscard]] QString text() const; // that is shown

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
    QLabel* shown_;
    QString all_;
};

} // namespace views

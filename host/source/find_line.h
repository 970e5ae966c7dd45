// A line below a text: finds words in it. Escape closes it.
#pragma once

#include <QLineEdit>
#include <QPlainTextEdit>

class QLabel;

namespace source {

class FindLine : public QWidget {
    Q_OBJECT

public:
    // The text outlives it.
    FindLine(QPlainTextEdit& text, QWidget* parent);

    // That of the text that a widget belongs to, or null.
    [[nodiscard]] static FindLine* of(const QWidget* widget);

    void open(); // and the keyboard is in it
    void next(int step);
    [[nodiscard]] QLineEdit& field() const { return *field_; }
    [[nodiscard]] QString says() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void look();
    [[nodiscard]] bool find(int from, int step); // around the ends; the words are selected then
    void tell(bool isFound);

    QPlainTextEdit& text_;
    QLineEdit* field_;
    QLabel* says_;
};

} // namespace source

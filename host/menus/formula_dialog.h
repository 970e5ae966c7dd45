// A formula that is written: its source, how it looks, what is wrong with it, and what TeX writes
// for plain words in it, as one types. Tab, and a click in the picture, lead to the parts that are
// empty; Tab leads behind the last of them, and then to the next widget.
#pragma once

#include "formulas/formula.h"
#include "text/edit.h"

#include <QDialog>
#include <functional>

class QHBoxLayout;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QRadioButton;

namespace menus {

class FormulaPreview;

class FormulaDialog : public QDialog {
    Q_OBJECT

public:
    enum class Place { inLine, alone, numbered };
    FormulaDialog(const QString& source, Place place, QWidget* parent);

    // Opens below that place of the screen, or above it, and has no frame of a window. LIMIT: where
    // a desktop places all windows itself (Wayland), it stands where that puts it.
    void standBy(const QRect& place);

    [[nodiscard]] QString source() const;
    [[nodiscard]] Place place() const;
    // A button that asks for a value of a figure: source of a formula, "" when none was chosen. It
    // is grey where none can be had; its tip says why.
    void offerValues(std::function<QString(QWidget* parent)> ask, const QString& refused);

protected:
    bool eventFilter(QObject* watched,
                     QEvent* event) override; // Return ends the dialog, Tab goes on
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget* makeSigns();
    void put(const QString& before, const QString& after);
    [[nodiscard]] int letters(std::size_t bytes) const; // of the source
    void goTo(std::size_t place);                       // the caret
    bool goOn(bool forward);                            // Tab; false: to the next widget
    void look();
    void mark(text::Range bytes, const QColor& color);
    void writeTex();

    QPlainTextEdit* field_;
    FormulaPreview* preview_;
    QLabel* fault_;
    QPushButton* tex_; // writes what TeX writes for plain words
    QRadioButton* alone_;
    QRadioButton* numbered_;
    QHBoxLayout* places_;
};

} // namespace menus

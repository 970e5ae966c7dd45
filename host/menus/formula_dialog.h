// A formula that is written: its source, how it looks, what is wrong with it, and what TeX writes
// for plain words in it, as one types.
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

// How a formula looks, as large as its room allows.
class FormulaPreview : public QWidget {
    Q_OBJECT

public:
    explicit FormulaPreview(QWidget* parent = nullptr);

    void show(formulas::Formula formula, formulas::Style style);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    formulas::Formula formula_;
    formulas::Style style_ = formulas::Style::text;
};

class FormulaDialog : public QDialog {
    Q_OBJECT

public:
    enum class Place { inLine, alone, numbered };
    FormulaDialog(const QString& source, Place place, QWidget* parent);

    [[nodiscard]] QString source() const;
    [[nodiscard]] Place place() const;
    // A button that asks for a value of a figure: source of a formula, "" when none was chosen.
    void offerValues(std::function<QString(QWidget* parent)> ask);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; // Return ends the dialog

private:
    QWidget* makeSigns();
    void put(const QString& before, const QString& after);
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

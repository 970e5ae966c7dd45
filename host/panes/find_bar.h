// Finds words in a document, and replaces them where it is written: a bar below the pages, with how
// many there are.
//
// Typing the words shows the next ones; when the document changes the view stays where it is.
#pragma once

#include "view/document_view.h"

class QCheckBox;
class QBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace panes {

class FindBar : public QWidget {
    Q_OBJECT

public:
    FindBar(view::DocumentView& view, QWidget* parent);

    void open();        // and the keyboard is in it
    void openReplace(); // with the second line, in a writing view
    void next(int step);
    // Replaces the place shown as found; false: there is none, or it cannot be replaced, as it
    // says.
    bool replace();
    void replaceAll(); // one step of undo
    [[nodiscard]] QLineEdit& field() { return *field_; }
    [[nodiscard]] QString says() const;

Q_SIGNALS:
    void replaced(const QString& how); // a sentence

protected:
    void keyPressEvent(QKeyEvent* event) override; // Escape closes it

private:
    void addFindRow(QBoxLayout& column);
    void addReplaceRow(QBoxLayout& column);
    QLineEdit* addField(QBoxLayout& row, const QString& name, const QString& label);
    void putButton(QBoxLayout& row, const QString& name, const QString& text,
                   const std::function<void()>& done);
    void putArrow(QBoxLayout& row, const QString& name, Qt::ArrowType arrow, const QString& says,
                  const std::function<void()>& done);
    void putInTabOrder();
    void look();
    void tell();
    void selectShown();
    [[nodiscard]] bool isSeen() const;
    [[nodiscard]] std::optional<text::Range> placeOfShown() const;
    void offerReplacing();

    view::DocumentView& view_;
    QLineEdit* field_ = nullptr;
    QCheckBox* matchCase_ = nullptr;
    QCheckBox* wholeWords_ = nullptr;
    QLabel* count_ = nullptr;
    QWidget* replacing_; // the second line
    QLineEdit* with_ = nullptr;
};

} // namespace panes

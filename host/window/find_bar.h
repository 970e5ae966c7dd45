// Finds words in a document: a field below the pages, with how many there are.
#pragma once

#include "view/document_view.h"

class QLabel;
class QLineEdit;

namespace window {

class FindBar : public QWidget {
    Q_OBJECT

public:
    FindBar(view::DocumentView& view, QWidget* parent);

    void open(); // and the keyboard is in it
    void next(int step);
    [[nodiscard]] QLineEdit& field() { return *field_; }
    [[nodiscard]] QString says() const;

protected:
    void keyPressEvent(QKeyEvent* event) override; // Escape closes it

private:
    void look();
    void tell();

    view::DocumentView& view_;
    QLineEdit* field_;
    QLabel* count_;
};

} // namespace window

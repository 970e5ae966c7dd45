// A document that is shown to an audience: one page at a time, as large as the screen. It has the
// first presentation of its class whose pages are wide, as screens are, unless those of the view
// are; the view keeps its own.
//
// Arrows, Space, Page Up and Page Down, the wheel and a click go from page to page; Escape leaves.
// Figures play and take keys as in other views.
#pragma once

#include "view/document_view.h"

namespace navigation {

class SlideShow : public view::DocumentView {
    Q_OBJECT

public:
    // Deletes itself when it is closed.
    SlideShow(const view::DocumentView& of, QWidget* parent);

    [[nodiscard]] std::size_t page() const { return page_; }

Q_SIGNALS:
    // Elsewhere in the document than it began, where this place is.
    void left(std::size_t place);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    bool useKey(int key, Qt::KeyboardModifiers modifiers);
    void goBy(int pages);
    void fit();
    void begin();

    std::size_t page_ = 0, firstPage_ = 0;
    std::optional<std::size_t> beginsAt_; // of the document: its page is not there yet
    bool turns_ = false;                  // the button that is down turns the page
    int turned_ = 0;                      // of the wheel, in eighths of a degree
    QTimer pointer_;                      // it is hidden where it rests
};

} // namespace navigation

// The manual: its chapters at the left, its text, and a field that finds words in it.
#pragma once

#include <QMainWindow>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace views {

class ManualWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit ManualWindow(const QString& markdown);

    void goTo(const QString& chapter);
    // The next place, or with `back` the one before; around the ends. False: there is none.
    bool find(const QString& words, bool back = false);

    [[nodiscard]] QTextBrowser& text() { return *text_; }
    [[nodiscard]] QListWidget& chapters() { return *chapters_; }
    [[nodiscard]] QLineEdit& search() { return *search_; }

protected:
    void keyPressEvent(QKeyEvent* event) override; // Escape: out of the search, then out
    void changeEvent(QEvent* event) override;

private:
    void colourLinks();
    void fillChapters();
    void buildMenus();
    void findAgain(bool back);
    void followScrolling();

    QTextBrowser* text_;
    QListWidget* chapters_;
    QLineEdit* search_;
    QLabel* none_;
};

} // namespace views

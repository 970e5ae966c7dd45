// The notice of a window above its text or picture: about a draft, with the possible actions; or
// about the time before the window was opened.
#pragma once

#include "language/draft.h"

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace views {

class Notice : public QFrame {
    Q_OBJECT
public:
    explicit Notice(const QString& name); // for who hears it

protected:
    QLabel* words_;
    QHBoxLayout* row_; // the words, and what buttons stand beside them
};

// A sentence that stays until it was read.
class ToldBar : public Notice {
    Q_OBJECT
public:
    ToldBar();
    void tell(const QString& sentence); // "": nothing
};

class NoticeBar : public Notice {
    Q_OBJECT
public:
    NoticeBar(SceneEditor& editor, Draft& draft);

    void nextConflict();
    void keepMine(); // of the conflict at the caret, else of the first
    void takeTheirs();
    void insist(); // nothing is updated before each conflict is settled

Q_SIGNALS:
    void wanted(scene::Range range);

private:
    void showState();
    [[nodiscard]] std::optional<scene::Range> current() const;
    [[nodiscard]] QString words(const std::vector<scene::Range>& conflicts) const;

    SceneEditor& editor_;
    Draft& draft_;
    QPushButton *mine_, *theirs_, *next_, *drop_;
    std::size_t conflicts_ = 0;
    bool insists_ = false;
};

} // namespace views

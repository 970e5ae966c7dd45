// What a language viewer says of its draft, above the text, and what can be done about it.
#pragma once

#include "views/draft.h"

#include <QFrame>

class QLabel;
class QPushButton;

namespace views {

class NoticeBar : public QFrame {
    Q_OBJECT
public:
    NoticeBar(SceneEditor& editor, Draft& draft);

    void nextConflict();
    void keepMine(); // of the conflict at the caret, else of the first
    void takeTheirs();
    void insist(); // nothing is updated before each conflict is settled

Q_SIGNALS:
    void wanted(scene::Range range);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void showState();
    [[nodiscard]] std::optional<scene::Range> current() const;
    [[nodiscard]] QString words(const std::vector<scene::Range>& conflicts) const;

    SceneEditor& editor_;
    Draft& draft_;
    QLabel* words_;
    QPushButton *mine_, *theirs_, *next_, *drop_;
    std::size_t conflicts_ = 0;
    bool insists_ = false;
};

} // namespace views

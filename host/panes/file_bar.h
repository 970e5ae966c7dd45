// A bar in a document's window: what another program did to the file, and the answers.
#pragma once

#include "session/file_follower.h"

#include <QFrame>

class QLabel;
class QPushButton;
class QScrollArea;

namespace panes {

class FileBar : public QFrame {
    Q_OBJECT

public:
    FileBar(session::FileFollower& file, QWidget* parent);

private:
    void update();
    void showChoices();

    session::FileFollower& file_;
    QLabel* sentence_;
    QPushButton* keep_;
    QPushButton* take_;
    QScrollArea* choices_; // what each button leads to, place by place
};

} // namespace panes

// The commands that one uses most, as pictures: they are the commands of the menus.
#pragma once

#include "frame/icons.h"

#include <QToolBar>

#include <utility>
#include <vector>

class QMainWindow;

namespace views {

class ToolBar : public QToolBar {
    Q_OBJECT
public:
    explicit ToolBar(QMainWindow& window);

    // The command of the window's menus with that object name; nothing where there is none.
    void add(const char* name, Icon which);
    void separate();

protected:
    void changeEvent(QEvent* event) override;

private:
    QMainWindow& window_;
    std::vector<std::pair<QAction*, Icon>> commands_;
};

} // namespace views

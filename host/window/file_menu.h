// The menu File of a window.
#pragma once

#include <QMenu>

namespace window {

class Application;
class DocumentWindow;

class FileMenu : public QMenu {
    Q_OBJECT

public:
    // Both outlive it.
    FileMenu(Application& application, DocumentWindow& window);

private:
    void save();
    void nameSave();
    void fillNew(QMenu& menu);
    void fillRecent();

    Application& application_;
    DocumentWindow& window_;
    QMenu* recent_;
    QAction* save_;
};

} // namespace window

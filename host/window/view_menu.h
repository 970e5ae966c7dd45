// The menu View of a window: how its document is shown, and what stands beside the pages.
#pragma once

#include <QMenu>

namespace window {

class Application;
class DocumentWindow;

class ViewMenu : public QMenu {
    Q_OBJECT

public:
    // Both outlive it. `parts`: the window's own, shown and hidden.
    ViewMenu(Application& application, DocumentWindow& window, const QList<QAction*>& parts);

Q_SIGNALS:
    void editPresentationWanted(); // the one that the view has
    void suppliedPresentationWanted(const QString& file);

private:
    void fillPresentations();
    [[nodiscard]] QString presentationFile() const; // its name

    DocumentWindow& window_;
    QMenu* presentations_;
    QAction* edit_; // the one that the view has
    QAction* supplied_;
};

} // namespace window

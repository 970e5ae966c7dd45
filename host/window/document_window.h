// One top-level window on a document: its view, menus, tool area, list of faults.
#pragma once

#include "view/document_view.h"

#include <QMainWindow>

class QLabel;

namespace source {
class PresentationPane;
class SourcePane;
} // namespace source

namespace filing {
class Printing;
class Saving;
} // namespace filing

namespace panes {
class FaultsPane;
class FindBar;
class OutlinePane;
} // namespace panes

namespace window {

class Application;
class MediumCommands;
class StatusLine;
class ViewMenu;

class DocumentWindow : public QMainWindow {
    Q_OBJECT

public:
    DocumentWindow(Application& application, std::shared_ptr<session::OpenDocument> document);
    ~DocumentWindow() override;

    [[nodiscard]] session::OpenDocument& document() const { return *document_; }
    [[nodiscard]] const std::shared_ptr<session::OpenDocument>& shared() const { return document_; }
    [[nodiscard]] view::DocumentView& view() const { return *view_; }
    [[nodiscard]] MediumCommands& commands() const { return *commands_; }

    [[nodiscard]] filing::Saving& saving() const { return *saving_; }
    [[nodiscard]] filing::Printing& printing() const { return *printing_; }
    [[nodiscard]] source::PresentationPane& presentation() const { return *presentation_; }
    // Its own, as the presentation says which element that is, else its file's name.
    [[nodiscard]] QString documentTitle() const;

    bool save(); // false: not, or not yet: what was typed elsewhere is being taken in
    bool saveAs();

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildTools(QAction& write);
    void connectPresentation(ViewMenu& menu);
    void say(const QString& sentence); // in the status line
    void updateTitle();
    void updateFaults(int errors, int warnings);
    [[nodiscard]] QString damage() const; // in words
    void updateBanner();
    void goTo(const session::ListedFault& fault);
    void openLink(const QString& target);
    void useShortcut(int key, Qt::KeyboardModifiers modifiers);

    Application& application_;
    std::shared_ptr<session::OpenDocument> document_;
    QLabel* banner_;
    view::DocumentView* view_;
    panes::FindBar* find_;
    panes::FaultsPane* faults_;
    panes::OutlinePane* outline_;
    source::SourcePane* source_;
    source::PresentationPane* presentation_;
    QToolBar* tools_;
    filing::Saving* saving_;
    filing::Printing* printing_;
    MediumCommands* commands_ = nullptr;
    StatusLine* status_;
};

} // namespace window

// One top-level window on a document: its view, menus, tool area, list of faults.
#pragma once

#include "view/document_view.h"

#include <QMainWindow>

class QLabel;

namespace window {

class Application;
class FaultsPane;
class FindBar;
class MediumCommands;

class DocumentWindow : public QMainWindow {
    Q_OBJECT

public:
    DocumentWindow(Application& application, std::shared_ptr<session::OpenDocument> document);
    ~DocumentWindow() override;

    [[nodiscard]] session::OpenDocument& document() const { return *document_; }
    [[nodiscard]] const std::shared_ptr<session::OpenDocument>& shared() const { return document_; }
    [[nodiscard]] view::DocumentView& view() const { return *view_; }
    [[nodiscard]] MediumCommands& commands() const { return *commands_; }

    bool save(); // false: not, or not yet: what was typed elsewhere is being taken in
    bool saveAs();
    void exportPdfTo(const QString& fileName);

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildHelpMenu();
    void buildTools();
    void fillRecent();
    void fillPresentations();
    [[nodiscard]] QString documentTitle() const;
    void updateTitle();
    void updateUndo();
    void updateFaults(int errors, int warnings);
    void print();
    void exportPdf();
    void openLink(const QString& target);
    bool saveBy(const std::function<files::SaveResult(files::SaveOptions)>& saving);
    [[nodiscard]] bool isLastOfDocument() const;
    // What was typed in windows of media and is no change of the document yet: asks when there is
    // any. `update`: it becomes the document's, and then `then` is done.
    enum class Drafts { none, update, leave, stay };
    [[nodiscard]] Drafts askAboutDrafts(const QString& title, const QString& update,
                                        const QString& leave);
    void updateDrafts(std::function<void()> then);
    bool saveNow();
    void updateSelection();
    void showTextMenu(const QPoint& at);
    void useShortcut(int key, Qt::KeyboardModifiers modifiers);
    QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys,
                 const std::function<void()>& done, const QString& icon = {});

    Application& application_;
    std::shared_ptr<session::OpenDocument> document_;
    QLabel* banner_;
    view::DocumentView* view_;
    FindBar* find_;
    FaultsPane* faults_;
    QToolBar* tools_;
    MediumCommands* commands_;
    QMenu* recent_ = nullptr;
    QMenu* presentations_ = nullptr;
    QAction* save_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QAction* cut_ = nullptr;
    QAction* copy_ = nullptr;
    QAction* paste_ = nullptr;
    QAction* selectAll_ = nullptr;
    QAction* write_ = nullptr;
    QLabel* pageLabel_;
    QLabel* zoomLabel_;
};

} // namespace window

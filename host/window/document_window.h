// One top-level window on a document: its view, menus, tool area, list of faults.
#pragma once

#include "window/document_view.h"

#include <QMainWindow>

class QLabel;

namespace window {

class Application;
class FaultsPane;
class MediumCommands;

class DocumentWindow : public QMainWindow {
    Q_OBJECT

public:
    DocumentWindow(Application& application, std::shared_ptr<session::OpenDocument> document);
    ~DocumentWindow() override;

    [[nodiscard]] session::OpenDocument& document() const { return *document_; }
    [[nodiscard]] const std::shared_ptr<session::OpenDocument>& shared() const { return document_; }
    [[nodiscard]] DocumentView& view() const { return *view_; }
    [[nodiscard]] MediumCommands& commands() const { return *commands_; }

    bool save();
    bool saveAs();
    void exportPdfTo(const QString& fileName);

protected:
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
    void updateTitle();
    void updateUndo();
    void updateFaults(int errors, int warnings);
    void print();
    void exportPdf();
    bool saveBy(const std::function<document::SaveResult(document::SaveOptions)>& saving);
    [[nodiscard]] bool isLastOfDocument() const;
    [[nodiscard]] bool mayLoseDrafts(); // asks when there are any
    void useShortcut(int key, Qt::KeyboardModifiers modifiers);
    QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys,
                 const std::function<void()>& done, const QString& icon = {});

    Application& application_;
    std::shared_ptr<session::OpenDocument> document_;
    QLabel* banner_;
    DocumentView* view_;
    FaultsPane* faults_;
    QToolBar* tools_;
    MediumCommands* commands_;
    QMenu* recent_ = nullptr;
    QMenu* presentations_ = nullptr;
    QAction* save_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QLabel* pageLabel_;
    QLabel* zoomLabel_;
};

} // namespace window

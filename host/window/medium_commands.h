// The menus of the media in a document, and the tool area that they share.
//
// Each medium that the document has gets a menu of its name, built from what it declares. Commands
// act on the chosen rendition, else on all visible ones of that medium (dissertation 6.2.4). The
// tool area belongs to the medium of the chosen rendition, else to that of the first visible one,
// and carries those of its commands that have an icon. The play bar beside them plays the chosen
// rendition, else all visible ones that have time, of every medium.
#pragma once

#include "view/document_view.h"

#include <QActionGroup>
#include <QMenuBar>
#include <QToolBar>

class QLabel;

namespace controls {
class PlayBar;
}

namespace window {

class MediumCommands : public QObject {
    Q_OBJECT

public:
    // Of one medium; what is beyond stands in its menu alone.
    static constexpr int mostTools = 40, mostGroups = 100;

    // Menus are put before `before`.
    MediumCommands(session::OpenDocument& document, view::DocumentView& view, QMenuBar& bar,
                   QAction* before, QToolBar& toolArea);
    ~MediumCommands() override;

    [[nodiscard]] QMenu* menuOf(document::SubdocumentId id) const; // nullptr without a medium
    // The subdocuments that a command of that medium would act on now.
    [[nodiscard]] std::vector<document::SubdocumentId> targets(const QString& documentClass) const;
    // The class whose medium owns the tool area; empty: none.
    [[nodiscard]] QString toolOwner() const;
    void refresh(); // now; otherwise it follows by itself

private:
    struct Medium {
        QMenu* menu = nullptr;
        std::vector<ipc::MenuEntry> entries; // that it was built from
        std::map<std::string, QAction*> actions;
        std::vector<QAction*> tools;
    };

    void watch();
    void schedule();
    void refreshMenu(const QString& documentClass, Medium& medium);
    void build(const QString& documentClass, Medium& medium,
               const std::vector<ipc::MenuEntry>& entries);
    void giveKeys(const Medium& medium, bool hasKeys) const;
    void clearTools(); // before their actions go
    void refreshTools();
    void refreshTime();
    void invoke(const QString& documentClass, const QString& id);
    // A command that wants to know more first.
    void ask(media::LiveSubdocument& live, document::SubdocumentId target, const QString& id,
             const ipc::Question& question);
    static void showState(QAction& action, const std::string& id,
                          const std::vector<media::LiveSubdocument*>& all);
    [[nodiscard]] std::vector<media::LiveSubdocument*>
    livesOf(const QString& documentClass) const; // of targets()
    [[nodiscard]] std::vector<media::LiveSubdocument*> timed() const;

    session::OpenDocument& document_;
    view::DocumentView& view_;
    QMenuBar& bar_;
    QAction* before_;
    QToolBar& tools_;
    QLabel* owner_;
    controls::PlayBar* time_;
    QAction* timeAction_;
    std::map<QString, Medium> media_;
    QTimer timer_;
    std::vector<QAction*> shown_; // in the tool area
    std::vector<QMetaObject::Connection> watched_;
};

} // namespace window

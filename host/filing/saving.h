// Saving the document of a window, and what is asked before it is saved or closed.
#pragma once

#include "session/open_document.h"

#include <QCoreApplication>
#include <QWidget>

namespace filing {

class Saving : public QObject {
    Q_OBJECT

public:
    // All outlive it. Questions stand over the window.
    Saving(session::OpenDocument& document, QWidget& window);

    bool save(); // false: not, or not yet: text typed elsewhere is being taken in
    bool saveAs();
    // The document gets the text that its file had before the last save, as one change of it.
    void bringBackup();
    // A copy among the templates; asks for its name. `proposed`: this one.
    void saveAsTemplate(const QString& proposed);
    // False: the window stays. To be called where the window is the document's last one. `title`
    // names the document.
    bool mayClose(const QString& title);

Q_SIGNALS:
    void said(const QString& sentence); // for the status line
    void savedAs(const QString& file);
    void mayCloseNow(); // the wait is over: mayClose() again

private:
    bool saveBy(const std::function<files::SaveResult(files::SaveOptions)>& saving);
    bool saveNow();
    // Asks about text typed in windows of media that is no change of the document yet, when there
    // is any. `update`: it becomes the document's, and then `then` is done.
    enum class Drafts { none, update, leave, stay };
    [[nodiscard]] Drafts askAboutDrafts(const QString& title, const QString& update,
                                        const QString& leave);
    void updateDrafts(std::function<void()> then);

    session::OpenDocument& document_;
    QWidget& window_;
};

} // namespace filing

// The windows that are open, the documents they show, and what is remembered between runs.
#pragma once

#include "dialogs/windows_stay.h"
#include "files/journal.h"
#include "filing/templates.h"
#include "media/live_media.h"
#include "window/document_window.h"

#include <QPointer>

namespace window {

// Fonts and colours of the program: its own where the desktop has no say.
void dress();

class Application : public QObject {
    Q_OBJECT

public:
    // `journal`: the folder of what is not saved.
    explicit Application(media::TimeLimits limits = {},
                         std::string journal = files::journalFolder("ensemble"));
    ~Application() override;

    // Opens a file in a window, or raises the one that has it. It takes the place of an empty memo
    // in which nobody has written. Null, after a message, when it cannot be read.
    DocumentWindow* open(const QString& fileName, QWidget* parent = nullptr);
    // A document that begins as the template, to be written. It takes the place of one that begins
    // otherwise and in which nobody has written. Null, after a message, when it cannot be read.
    DocumentWindow* openNew(const filing::Template& from, QWidget* parent);
    DocumentWindow* openNew(); // from the first one
    DocumentWindow* addWindow(std::shared_ptr<session::OpenDocument> document);
    // Asks about each text that a program which ended had not saved, and opens what is wanted.
    void offerRecovered();
    // Its file opens, with that text as one change of it; what is not saved stays in the journal.
    DocumentWindow* recover(files::LeftBehind left);
    // The presentation of that file says something else: the documents that are open follow.
    void setPresentation(const QString& name, const QString& path, const std::string& text);
    void playWhenLoaded(session::OpenDocument& document);
    void quit(); // after asking every window

    [[nodiscard]] std::vector<DocumentWindow*> windowsOf(const session::OpenDocument& of) const;
    [[nodiscard]] QStringList recentFiles() const;
    void remember(const QString& fileName);
    [[nodiscard]] media::LiveMedia& media() { return media_; }
    [[nodiscard]] const media::PipeThread& pipes() const { return pipes_; }

private:
    void closeUntouched(DocumentWindow& instead);

    std::string journal_;
    schemas::Schemas schemas_;
    media::PipeThread pipes_;
    media::LiveMedia media_;
    std::vector<QPointer<DocumentWindow>> windows_;
    dialogs::WindowsStay stay_;
};

} // namespace window

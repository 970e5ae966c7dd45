// What was not saved outlives this program: while a stand-alone document differs from its file, its
// text lies in a folder of the user's, and whoever starts the program after it was killed gets it.
//
// The folder has three files for each document: NAME.al is the text, byte for byte, NAME.json says
// whose text it is, and NAME.lock is held by the process that writes them (QLockFile: what a dead
// process held is free).
//
// LIMIT: drafts of language viewers are not kept; only what was made the document's text is.
#pragma once

#include "views/scene_document.h"

#include <QDateTime>
#include <QList>
#include <QLockFile>
#include <QTimer>

class QWidget;

namespace views {

// Where a program that was installed for a user keeps such texts.
[[nodiscard]] QString autosaveFolder();

// A text that a process which is no more has left behind. Nobody else is offered it while this one
// lives.
struct LeftBehind {
    QString file;  // of the text
    QString scene; // the path that it was opened from, "" for one that was never saved
    QDateTime at;
    std::shared_ptr<QLockFile> lock;
};

class Autosave : public QObject {
    Q_OBJECT
public:
    // `document` outlives it. The text is kept `quiet` milliseconds after the last change, and
    // during changes at least every `longest`.
    Autosave(SceneDocument& document, const QString& folder, int quiet = 1000,
             int longest = 10'000);
    // The program ends as it should: what was to be saved is, and the rest was given up.
    ~Autosave() override;

    // Of the text; "" while none is kept.
    [[nodiscard]] const QString& file() const { return file_; }

    // The document becomes what was left: its file, with the text as one change that can be undone.
    // What was left is what is kept of the document from then on: should the text end this program
    // too, it is still there. "" or the sentence that says why not.
    [[nodiscard]] QString recover(const LeftBehind& left);

Q_SIGNALS:
    void failed(const QString& sentence); // once, until it works again

private:
    void documentChanged();
    void keep();
    void forget();
    [[nodiscard]] bool claim(); // a name that nobody else has

    SceneDocument& document_;
    QString folder_, file_;
    std::shared_ptr<QLockFile> lock_;
    QTimer quiet_, longest_;
    bool hasFailed_ = false;
};

// The newest first. What belongs to a living process is not among them.
[[nodiscard]] QList<LeftBehind> leftBehind(const QString& folder);
void discard(const LeftBehind& left);

// Asks about all that was left of `scene`, or of any scene for "". True: one was recovered.
bool offerRecovery(QWidget* over, Autosave& autosave, const QString& folder, const QString& scene);

} // namespace views

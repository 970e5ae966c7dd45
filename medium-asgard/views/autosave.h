// What was not saved outlives this program: while a stand-alone document differs from its file, its
// text lies in a folder of the user's, and whoever starts the program after it was killed gets it.
//
// The folder has three files for each document: NAME.al is the text, byte for byte, NAME.json says
// whose text it is, and NAME.lock is held by the process that writes them (QLockFile: what a dead
// process held is free).
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

class Autosave : public QObject {
    Q_OBJECT
public:
    // `document` outlives it. The text is kept `quiet` milliseconds after the last change, and
    // during changes at least every `longest`.
    Autosave(SceneDocument& document, const QString& folder, int quiet = 1000,
             int longest = 10'000);
    // The program ends as it should: what was to be saved is, and the rest was given up.
    ~Autosave() override;

    [[nodiscard]] const QString& file() const {
        return file_;
    } // of the text; "" while none is kept

Q_SIGNALS:
    void failed(const QString& sentence); // once, until it works again

private:
    void documentChanged();
    void keep();
    void forget();
    [[nodiscard]] bool claim(); // a name that nobody else has

    SceneDocument& document_;
    QString folder_, file_;
    std::unique_ptr<QLockFile> lock_;
    QTimer quiet_, longest_;
    bool hasFailed_ = false;
};

// A text that a process which is no more has left behind.
struct LeftBehind {
    QString file;  // of the text
    QString scene; // the path that it was opened from, "" for one that was never saved
    QDateTime at;
};

// The newest first. What belongs to a living process is not among them.
[[nodiscard]] QList<LeftBehind> leftBehind(const QString& folder);
// The document becomes what was left: its file, with the text as one change that can be undone.
// "" or the sentence that says why not; then what was left is still there.
[[nodiscard]] QString recover(SceneDocument& document, const LeftBehind& left);
void discard(const LeftBehind& left);

// Asks about all that was left of `scene`, or of any scene for "". True: one was recovered.
bool offerRecovery(QWidget* over, SceneDocument& document, const QString& folder,
                   const QString& scene);

} // namespace views

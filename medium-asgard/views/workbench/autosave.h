// Unsaved work outlives this program: while a stand-alone scene differs from its file, or a
// language viewer holds a draft, both lie in the user's journal (files/journal.h), and the next
// start after the program was killed offers them.
#pragma once

#include "files/journal_writer.h"
#include "workbench/scene_document.h"

#include <QTimer>

class QWidget;

namespace views {

// Text that is typed in windows and no change of the scene's text yet.
struct KeptDrafts {
    std::function<std::string()> state = [] { return std::string(); }; // "": nothing is
    std::function<void(const std::string& state)> restore = [](const std::string&) {};
};

class Autosave : public QObject {
    Q_OBJECT
public:
    // `document` outlives it.
    Autosave(SceneDocument& document, const std::string& folder, KeptDrafts drafts = {});
    // The program ends as it should: work to be saved is, and the rest was given up.
    ~Autosave() override;

    // Of what is kept, which is on the disk then; "" while nothing is.
    [[nodiscard]] std::string file() { return writer_.path(); }

    // The document becomes what was left: its file, with the text as one change that can be undone,
    // and the drafts. All of that stays kept from the first moment on: should the text end this
    // program too, it is still there.
    void recover(files::LeftBehind left);

    // Drafts may be other ones now. While there are some, they are looked at each second.
    void lookAtDrafts();

Q_SIGNALS:
    void failed(const QString& sentence); // once, until it works again

private:
    void changed();

    SceneDocument& document_;
    KeptDrafts drafts_;
    std::string kept_; // the drafts' state
    bool recovering_ = false;
    QTimer look_;
    files::JournalWriter writer_;
};

// Asks about all that was left of `scene`, or of any scene for "". True: one was recovered.
bool offerRecovery(QWidget* over, Autosave& autosave, const std::string& folder,
                   const QString& scene);

} // namespace views

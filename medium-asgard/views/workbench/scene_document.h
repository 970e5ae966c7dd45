// The scene that all views of a process show and change: its text, and the scene and motion of it.
//
// The text is the truth. setText() is the only way to change it from a view; computing/ then reads
// the text and computes its motion on threads, and every view follows by signals. While a text has
// errors the last good scene and its motion stay (scene language, "Errors").
//
// Stand-alone the document is a file with an undo stack of its own. Under a host the text belongs
// to the host: a view's change is shown at once and reported through `HostLink`, which ends in
// didAccept() or didRefuse(). The host does undo and redo, and its changes arrive by
// setTextFromHost(). The session passes its scene and motion by setComputed(); this document then
// has no workshop and computes nothing.
#pragma once

#include "computing/follower.h"
#include "editing/changes.h"
#include "editing/value_edit.h"
#include "files/save.h"
#include "gestures/ground.h"
#include "scene/diagnostic.h"
#include "text/edit.h"
#include "workbench/history.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace views {

using computing::Live;
using computing::Work;
// How texts become scenes and scenes motion. An empty one computes nothing: setComputed() is called
// instead.
using Workshop = computing::Tools;

struct HostLink {
    std::function<void(const text::Edit& edit, const QString& label)> changed;
    std::function<void()> undo, redo;
    std::function<void()> recompute = nullptr; // where the motion is computed by another
    std::function<void()> stopComputing = nullptr;
    // The text as a gesture has it, to be read and shown; it is no change. None: it waits for the
    // gesture's end.
    std::function<void(const std::string& text)> preview = nullptr;
    std::function<void(Live live)> setLive = nullptr; // where another computes
};

// A good scene and the motion that belongs to it; no motion while the first bit is computed, or
// when the scene cannot be simulated.
struct Shown {
    std::shared_ptr<const scene::Scene> scene = std::make_shared<scene::Scene>();
    simulation::MotionPointer motion;
};

// The scene and motion that another has made of the text.
struct Computed {
    Shown shown;
    std::string text; // that the scene was read from
    std::vector<scene::Diagnostic> diagnostics;
    std::optional<simulation::Statistics> statistics;
    Work work = Work::none;
    bool current = false; // the scene was read from the text as it is now
    bool stale = false;   // the motion is an older scene's
    bool stopped = false; // the motion ends where stopComputing() found it
};

// The answer to a gesture that goes on, for the text as it was at the revision that it began at.
struct Asked {
    int since;
    editing::Answer answer;
};

// The step of undo that a change from elsewhere makes of a gesture's text.
enum class Unfinished { step, none };

class SceneDocument : public QObject {
    Q_OBJECT
public:
    explicit SceneDocument(Workshop workshop, QObject* parent = nullptr);
    ~SceneDocument() override; // cancels what is being computed

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] int revision() const { return revision_; }
    [[nodiscard]] const Shown& shown() const { return computed_.shown; }
    // That the shown scene was read from.
    [[nodiscard]] const std::string& shownText() const { return computed_.text; }
    // Of the current text, by place; faults of the motion without a place at the end.
    [[nodiscard]] const std::vector<scene::Diagnostic>& diagnostics() const {
        return computed_.diagnostics;
    }
    [[nodiscard]] bool hasErrors() const;
    [[nodiscard]] Work work() const { return computed_.work; }
    // The scene that was read from this very text is the one shown: places in it are right.
    [[nodiscard]] bool sceneIsCurrent() const { return sceneRevision_ == revision_; }
    // It is not, and will be soon, if the text has no errors.
    [[nodiscard]] bool isAwaited() const { return !sceneIsCurrent() && work() != Work::none; }
    // Why no gesture can change the text now; "": they can.
    [[nodiscard]] QString whyNotCurrent() const;
    [[nodiscard]] const std::optional<simulation::Statistics>& statistics() const {
        return computed_.statistics;
    }

    // The selection, in every view: elements of the shown scene, in order. They stay selected while
    // they exist, whatever else an edit changes.
    [[nodiscard]] const std::vector<editing::Element>& selected() const { return selected_; }
    void select(std::vector<editing::Element> elements);

    // A view's change: one step of undo.
    void setText(const std::string& text, const QString& label);
    // While a gesture lasts, texts are shown and read that are no steps of undo; the text that it
    // ends with is one. A change from elsewhere meanwhile ends the gesture: its change so far is a
    // step then, or is taken back, and nothing more of it is taken. `since`: the revision that the
    // gesture began at; `hand`: whoever it is, which tells it from others that began there too.
    void preview(const std::string& text, int since, const void* hand = nullptr,
                 Unfinished unfinished = Unfinished::step);
    void finishPreview(const std::string& text, const QString& label, int since,
                       const void* hand = nullptr);
    // The changes of a gesture that began at that revision are taken still: nothing else has
    // changed the text since.
    [[nodiscard]] bool mayGoOn(int since) const {
        return since == revision_ || (gesture_ && gesture_->since == since);
    }
    [[nodiscard]] static QString overtaken(); // the sentence of a gesture that may not
    // The text is a gesture's, which has not ended.
    [[nodiscard]] bool isPreview() const { return gesture_.has_value(); }
    // The base of a gesture in one of the windows.
    [[nodiscard]] gestures::Ground ground();
    // Computes the motion again from the current text, however long that takes.
    void recompute();
    // Keeps the motion that there is.
    void stopComputing();
    [[nodiscard]] bool computingWasStopped() const { return computed_.stopped; }

    // The scene is shown as soon as it is read; until its own motion is there the motion shown is
    // an older scene's, which is said wherever it is seen.
    [[nodiscard]] bool motionIsStale() const { return computed_.stale; }
    // It stays so until one asks for the motion.
    [[nodiscard]] bool waitsToBeAsked() const { return motionIsStale() && work() == Work::none; }
    [[nodiscard]] Live live() const { return live_; }
    void setLive(Live live);
    void setOverlap(std::chrono::milliseconds overlap); // of motions while a gesture lasts

    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool canRedo() const;
    // The changes of the next undo and the next redo; "" under a host, who knows.
    [[nodiscard]] QString undoLabel() const;
    [[nodiscard]] QString redoLabel() const;
    void undo();
    void redo();

    // --- under a host
    void setHostLink(HostLink link) { host_ = std::move(link); }
    [[nodiscard]] bool hasHost() const { return static_cast<bool>(host_.changed); }
    void setTextFromHost(const std::string& text);
    // The results of changes by views: the host's text is the document's, or is so again.
    void didAccept();
    void didRefuse(const std::string& hostText, const QString& why);
    void setComputed(Computed computed);

    // --- stand-alone
    [[nodiscard]] QString open(const QString& path); // "" or why not
    [[nodiscard]] files::SaveResult save(const QString& path, files::SaveOptions options = {});
    // A scene that was never saved, with a text to begin with.
    void reset(const std::string& text = {}, const QString& name = {});
    // Takes the text that a program, which knew its file as `file`, had not saved when it ended:
    // one change of the file's content. Without the file it is a scene that was never saved.
    void recover(const files::KnownFile& file, const std::string& text);
    [[nodiscard]] const files::KnownFile& knownFile() const { return file_.known; }
    [[nodiscard]] const QString& path() const { return file_.path; }
    [[nodiscard]] const std::string& savedText() const { return file_.text; }
    [[nodiscard]] bool isModified() const { return text_ != file_.text; }
    // For titles: the file's name, or what the host calls it.
    [[nodiscard]] QString name() const;
    void setName(const QString& name);

Q_SIGNALS:
    void opened(); // another scene, or file: drafts and gestures of the one before are no more
    void textChanged();
    void diagnosticsChanged();
    // Just before sceneChanged(): of the scene that is shown then.
    void elementsRenamed(const std::vector<editing::Renamed>& renamed);
    void sceneChanged(); // another scene is shown
    void selectionChanged();
    void motionChanged(); // more or other motion of it
    void workChanged();   // or whether the motion is stale
    // Last of all, once everyone has followed: the scene of the text is shown, or none will come.
    void wasRead();
    void nameChanged(); // or whether it is modified
    void changeAccepted();
    void changeRefused(const QString& why); // the text is the host's again

private:
    // `wanted`: is selected once the text is read, if nothing else is then.
    void replaceText(const std::string& text, History::Selected wanted = {});
    void take(const History::Step& step);
    void endGesture();
    void begin(const QString& path, const files::KnownFile& file, const std::string& text);
    void start(bool asked);
    // After another scene came; the one before was read from that text.
    void followSelection(const scene::Scene& before, const std::string& textBefore,
                         const std::vector<editing::Renamed>& renamed);
    void setWork(Work work);
    void update(); // what the follower has come to is shown

    std::string text_;
    int revision_ = 0;
    int sceneRevision_ = 0;  // of the shown scene; no text is the empty scene
    Computed computed_;      // what is shown
    bool isAnother_ = false; // a scene was opened that is not shown yet
    std::vector<editing::Element> selected_;
    struct Wanted {
        int revision = -1; // of the text
        std::vector<editing::Element> selected;
    };
    Wanted wanted_;
    QTimer due_; // the follower has something to do then
    Live live_ = Live::always;
    HostLink host_;
    History history_;
    struct File { // stand-alone
        QString path, name;
        files::KnownFile known;
        std::string text; // as it was saved
    };
    File file_;
    struct Gesture {
        std::string before;
        int since; // the revision that it began at
        const void* hand;
        Unfinished unfinished;
    };
    std::optional<Gesture> gesture_;
    std::unique_ptr<computing::Follower> follower_; // last: its threads call this
};

} // namespace views

// One subdocument as its medium sees it: its text, what was read of it, and the motion of that.
//
// The text is the host's; here it is followed (computing/). A new scene takes over once its motion
// reaches the time that is shown (or has ended, or makes one wait too long), so that an edit does
// not throw a viewer back to the start; while a handle is dragged it takes over at once.
//
// Serves any event loop: descriptor() is readable when there are news, deadline() says when
// something is due without news; then update() does what is to be done and says what changed.
#pragma once

#include "computing/bell.h"
#include "computing/follower.h"
#include "ipc/messages.h"
#include "playing/playback.h"

namespace service {

using computing::Changes;
using computing::ParameterValues;
using computing::ScenePointer;
using computing::Tools;
using playing::Clock;
using playing::Instant;
using playing::Playback;
using playing::Span;

class Subdocument {
public:
    explicit Subdocument(Tools tools) : follower_(std::move(tools), [this] { bell_.ring(); }) {}

    void load(std::string text, ipc::Integer revision, Instant now);
    // All or none of the edits; the sentence says why not. Where they make the text that a gesture
    // shows, nothing is read or computed again.
    [[nodiscard]] std::optional<std::string> edit(const text::Edits& edits, ipc::Integer revision,
                                                  Instant now);
    // While a gesture lasts: this text is read and shown, and is that of no revision. A text that
    // the host sends ends it, as endPreview() does: then the text is shown as it is.
    void preview(std::string text, Instant now);
    void endPreview(Instant now);
    [[nodiscard]] bool previewing() const { return preview_.has_value(); }
    // The text that is being shown: its own, or a gesture's.
    [[nodiscard]] const std::string& shownText() const { return preview_ ? *preview_ : text_; }
    // Overrides a parameter of the scene, within its bounds. False: there is none of that name.
    bool setParameter(const std::string& name, double value, Instant now);
    void recompute(Instant now);
    void cancel() { follower_.cancel(); }

    [[nodiscard]] int descriptor() const { return bell_.descriptor(); }
    // Any thread: the descriptor becomes readable, for what is done beside.
    void wake() const { bell_.ring(); }
    [[nodiscard]] std::optional<Instant> deadline() const { return follower_.deadline(); }
    Changes update(Instant now);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] ipc::Integer revision() const { return revision_; }
    [[nodiscard]] const ParameterValues& parameters() const { return parameters_; }

    // The scene that is shown, and its motion. Null before the first good text.
    [[nodiscard]] const ScenePointer& scene() const { return follower_.shown().scene; }
    [[nodiscard]] const simulation::MotionPointer& motion() const {
        return follower_.shown().motion;
    }
    // That the scene was read from.
    [[nodiscard]] const std::string& sceneText() const { return follower_.shownText(); }
    // Of the newest text that makes a scene, shown or not yet.
    [[nodiscard]] const ScenePointer& newestScene() const { return follower_.newestScene(); }
    // A number that grows whenever pictures of the same time may differ.
    [[nodiscard]] unsigned generation() const { return generation_; }
    // One that grows whenever the shown text or its faults may be others.
    [[nodiscard]] unsigned textGeneration() const { return textGeneration_; }
    // One that grows whenever the scene should be framed anew: for a new scene and a whole motion.
    [[nodiscard]] unsigned viewGeneration() const { return viewGeneration_; }

    // Whether an edit's motion is computed without being asked for.
    void setLive(computing::Live live) { follower_.setLive(live); }
    [[nodiscard]] computing::Live live() const { return follower_.live(); }
    [[nodiscard]] computing::Work work() const { return follower_.work(); }
    [[nodiscard]] bool computing() const { return work() != computing::Work::none; }
    // The scene that is shown is that of shownText().
    [[nodiscard]] bool upToDate() const { return scene() && follower_.isCurrent(); }
    // The motion that is shown is an older scene's, for a moment or until one asks for its own.
    [[nodiscard]] bool motionIsStale() const { return follower_.motionIsStale(); }
    [[nodiscard]] bool waitsToBeAsked() const { return follower_.waitsToBeAsked(); }
    [[nodiscard]] bool isCancelled() const { return follower_.isCancelled(); } // by cancel()
    // The motion of the text as it is now is known up to here; none: not yet, or it has none.
    [[nodiscard]] std::optional<double> knownUntil() const;
    // When reading the text had ended; none: it goes on.
    [[nodiscard]] std::optional<Instant> readAt() const { return follower_.readAt(); }
    [[nodiscard]] Instant startedAt() const { return follower_.startedAt(); }
    [[nodiscard]] ipc::MotionState state() const;
    // Faults of the text and of its motion, for windows of this process and for the host.
    [[nodiscard]] const std::vector<scene::Diagnostic>& faults() const {
        return follower_.diagnostics();
    }
    [[nodiscard]] std::vector<ipc::DiagnosticItem> diagnostics() const;
    [[nodiscard]] const std::optional<simulation::Statistics>& statistics() const {
        return follower_.statistics();
    }

    Playback playback;

private:
    void accept(ipc::Integer revision);
    void start(bool asked, Instant now);

    computing::Bell bell_;
    computing::Follower follower_;
    std::string text_;
    std::optional<std::string> preview_;
    ipc::Integer revision_ = 0;
    ParameterValues parameters_;
    bool accepted_ = false; // the text that is shown has become the host's
    unsigned generation_ = 0, viewGeneration_ = 0, textGeneration_ = 0;
};

} // namespace service

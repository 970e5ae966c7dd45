// One subdocument as its medium sees it: its text, what was read of it, and the motion of that.
//
// The text is the host's; here it is followed. A text that is faulty leaves the last good scene in
// force. A new scene takes over once its motion reaches the time that is shown (or has ended, or
// makes one wait too long), so that an edit does not throw a viewer back to the start.
//
// Serves any event loop: descriptor() is readable when there are news, deadline() says when
// something is due without news; then update() does what is to be done and says what changed.
#pragma once

#include "ipc/messages.h"
#include "playing/playback.h"
#include "service/worker.h"

namespace service {

using playing::Clock;
using playing::Instant;
using playing::Playback;
using playing::Span;

struct Changes {
    bool scene = false;       // another scene is shown
    bool motion = false;      // another motion, or more of it
    bool diagnostics = false; // the set is complete for the text's revision
    bool ended = false;       // nothing is being read or computed any more
};

class Subdocument {
public:
    explicit Subdocument(Tools tools) : worker_(std::move(tools)) {}

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
    void cancel() { worker_.cancel(); }

    [[nodiscard]] int descriptor() const { return worker_.descriptor(); }
    // Any thread: the descriptor becomes readable, for what is done beside.
    void wake() const { worker_.wake(); }
    [[nodiscard]] std::optional<Instant> deadline() const;
    Changes update(Instant now);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] ipc::Integer revision() const { return revision_; }
    [[nodiscard]] const ParameterValues& parameters() const { return parameters_; }

    // The scene that is shown, and its motion. Null before the first good text.
    [[nodiscard]] const ScenePointer& scene() const { return shown_.scene; }
    [[nodiscard]] const simulation::MotionPointer& motion() const { return shown_.motion; }
    // That the scene was read from.
    [[nodiscard]] const std::string& sceneText() const { return shown_.text; }
    // Of the newest text that makes a scene, shown or not yet.
    [[nodiscard]] const ScenePointer& newestScene() const {
        return awaited_.scene ? awaited_.scene : shown_.scene;
    }
    // A number that grows whenever pictures of the same time may differ.
    [[nodiscard]] unsigned generation() const { return generation_; }
    // One that grows whenever the shown text or its faults may be others.
    [[nodiscard]] unsigned textGeneration() const { return textGeneration_; }
    // One that grows whenever the scene should be framed anew: for a new scene and a whole motion.
    [[nodiscard]] unsigned viewGeneration() const { return viewGeneration_; }

    [[nodiscard]] bool computing() const { return worker_.busy(); }
    // The scene that is shown is that of shownText().
    [[nodiscard]] bool upToDate() const { return !awaited_.scene && read_ && !faulty_; }
    // The motion of the text as it is now is known up to here; none: not yet, or it has none.
    [[nodiscard]] std::optional<double> knownUntil() const;
    // When reading the text had ended; none: it goes on.
    [[nodiscard]] std::optional<Instant> readAt() const { return read_; }
    [[nodiscard]] Instant startedAt() const { return started_; }
    [[nodiscard]] ipc::MotionState state() const;
    // Faults of the text and of its motion, for windows of this process and for the host.
    [[nodiscard]] std::vector<scene::Diagnostic> faults() const;
    [[nodiscard]] std::vector<ipc::DiagnosticItem> diagnostics() const;
    [[nodiscard]] const std::optional<simulation::Statistics>& statistics() const {
        return statistics_;
    }

    Playback playback;

private:
    struct Version {
        ScenePointer scene;
        simulation::MotionPointer motion;
        std::string text; // that the scene was read from
    };
    void accept(ipc::Integer revision);
    void start(Instant now);
    [[nodiscard]] bool takeOverNow(Instant now) const;
    void takeOver(Instant now);

    Worker worker_;
    std::string text_;
    std::optional<std::string> preview_;
    ipc::Integer revision_ = 0;
    ParameterValues parameters_;
    Version shown_, awaited_; // awaited: of the newest text, not shown yet
    std::vector<scene::Diagnostic> faults_;
    std::vector<std::string> refusal_;
    std::optional<simulation::Statistics> statistics_; // of the last motion that ended
    bool faulty_ = false;                              // the newest text makes no scene
    bool accepted_ = false;  // the text that is shown has become the host's
    bool cancelled_ = false; // its motion was not finished because someone said so
    Instant started_{};
    std::optional<Instant> read_;
    unsigned generation_ = 0, viewGeneration_ = 0, textGeneration_ = 0;
};

} // namespace service

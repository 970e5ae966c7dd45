#include "service/subdocument.h"

#include "motion/known_span.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace service {
namespace {

// How long the old scene may stay while the motion of the new one is behind the time shown.
constexpr std::chrono::milliseconds longestWait{250};

ipc::DiagnosticItem itemOf(const scene::Diagnostic& diagnostic) {
    ipc::DiagnosticItem item;
    item.severity = diagnostic.severity == scene::Severity::error ? ipc::Severity::error
                                                                  : ipc::Severity::warning;
    item.line = diagnostic.line;
    item.column = diagnostic.column;
    item.endLine = diagnostic.endLine;
    item.endColumn = diagnostic.endColumn;
    item.message = diagnostic.message;
    if (!diagnostic.suggestion.empty())
        item.message += " - " + diagnostic.suggestion;
    return item;
}

bool anyStop(const simulation::Motion& motion) {
    for (std::size_t body = 0; body < motion.bodies(); ++body)
        if (motion.stop(body))
            return true;
    return false;
}

} // namespace

void Subdocument::load(std::string text, ipc::Integer revision, Instant now) {
    text_ = std::move(text);
    revision_ = revision;
    preview_.reset();
    start(true, now);
}

void Subdocument::preview(std::string text, Instant now) {
    if (text == shownText())
        return;
    preview_ = std::move(text);
    start(false, now);
}

void Subdocument::endPreview(Instant now) {
    const auto preview = std::exchange(preview_, std::nullopt);
    if (preview && *preview != text_)
        start(false, now);
}

std::optional<std::string> Subdocument::edit(const text::Edits& edits, ipc::Integer revision,
                                             Instant now) {
    if (revision <= revision_)
        return "the edit makes revision " + std::to_string(revision) + ", this is " +
               std::to_string(revision_) + " already";
    if (!text::areOrdered(edits, text_.size()))
        return "an edit lies outside the text or over another";
    std::string text = text::applied(text_, edits);
    if (preview_ == text) {
        accept(revision);
        return std::nullopt;
    }
    text_ = std::move(text);
    revision_ = revision;
    preview_.reset();
    start(false, now);
    return std::nullopt;
}

void Subdocument::accept(ipc::Integer revision) {
    text_ = *std::exchange(preview_, std::nullopt);
    revision_ = revision;
    ++textGeneration_;
    accepted_ = true;
}

bool Subdocument::setParameter(const std::string& name, double value, Instant now) {
    const ScenePointer& scene = newestScene();
    if (!scene)
        return false;
    const auto found = std::ranges::find(scene->parameters, name, &scene::Parameter::name);
    if (found == scene->parameters.end())
        return false;
    parameters_[name] =
        std::clamp(value, found->minimum.value_or(value),
                   std::max(found->maximum.value_or(value), found->minimum.value_or(value)));
    start(true, now);
    return true;
}

void Subdocument::recompute(Instant now) { start(true, now); }

void Subdocument::start(bool asked, Instant now) {
    const bool gesture = preview_.has_value();
    follower_.follow(shownText(),
                     {parameters_, asked, gesture, gesture ? computing::quick : longestWait}, now);
    ++textGeneration_;
}

Changes Subdocument::update(Instant now) {
    bell_.hear();
    // A hand that drags sees whole motions, as in viewers: pictures of parts would only delay them.
    constexpr double never = std::numeric_limits<double>::infinity();
    follower_.setSeen(previewing() ? never : playback.time(now));
    Changes changes = follower_.update(now);
    if (std::exchange(accepted_, false) && readAt()) // of another revision
        changes.diagnostics = true;
    textGeneration_ += changes.diagnostics ? 1 : 0;
    const bool isWhole = changes.ended && changes.motion; // the picture frames all of it
    viewGeneration_ += changes.scene || isWhole ? 1 : 0;
    generation_ += changes.scene || changes.otherMotion || isWhole ? 1 : 0;
    if (const auto& moves = motion(); (changes.motion || changes.ended) && moves) {
        const simulation::KnownSpan known = simulation::knownSpan(*moves);
        playback.setSpan({moves->start(), known.playsTo(*moves, computing()), known.computed}, now);
    } else if (changes.scene)
        playback.setSpan({scene()->simulator.start,
                          std::max(scene()->simulator.start, scene()->simulator.finish),
                          scene()->simulator.start},
                         now);
    return changes;
}

std::optional<double> Subdocument::knownUntil() const {
    if (!upToDate() || motionIsStale() || !motion())
        return std::nullopt;
    return motion()->computed();
}

ipc::MotionState Subdocument::state() const {
    if (computing())
        return ipc::MotionState::computing;
    if (scene() && (follower_.isFaulty() || waitsToBeAsked()))
        return ipc::MotionState::stale;
    if (!motion() || follower_.isCancelled() || anyStop(*motion()))
        return ipc::MotionState::failed;
    return motion()->draft() ? ipc::MotionState::draft : ipc::MotionState::current;
}

std::vector<ipc::DiagnosticItem> Subdocument::diagnostics() const {
    std::vector<ipc::DiagnosticItem> items;
    std::ranges::transform(faults(), std::back_inserter(items), itemOf);
    return items;
}

} // namespace service

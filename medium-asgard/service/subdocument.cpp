#include "service/subdocument.h"

#include "reports/report.h"
#include "script/locate.h"
#include "text/places.h"

#include <algorithm>
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
    start(now);
}

void Subdocument::preview(std::string text, Instant now) {
    if (text == shownText())
        return;
    if (awaited_.motion) // one that moves on without a rest sees each that got so far
        takeOver(now);
    preview_ = std::move(text);
    start(now);
}

void Subdocument::endPreview(Instant now) {
    const auto preview = std::exchange(preview_, std::nullopt);
    if (preview && *preview != text_)
        start(now);
}

std::optional<std::string> Subdocument::edit(const text::Edits& edits, ipc::Integer revision,
                                             Instant now) {
    if (revision <= revision_)
        return "the edit makes revision " + std::to_string(revision) + ", this is " +
               std::to_string(revision_) + " already";
    if (!text::areOrdered(edits, text_.size()))
        return "an edit lies outside the text or over another";
    std::string text = text::applied(text_, edits);
    if (preview_ == text)
        accept(revision);
    else
        load(std::move(text), revision, now);
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
    start(now);
    return true;
}

void Subdocument::recompute(Instant now) { start(now); }

void Subdocument::start(Instant now) {
    worker_.start(shownText(), parameters_);
    ++textGeneration_;
    started_ = now;
    read_.reset();
    awaited_ = {};
    refusal_.clear();
    cancelled_ = false;
}

std::optional<Instant> Subdocument::deadline() const {
    if (awaited_.scene && read_)
        return *read_ + longestWait;
    return std::nullopt;
}

Changes Subdocument::update(Instant now) {
    Changes changes;
    changes.diagnostics = std::exchange(accepted_, false) && read_; // of another revision
    News news = worker_.collect();
    if (news.diagnostics) {
        read_ = now;
        faults_ = std::move(*news.diagnostics);
        faulty_ = !news.scene;
        awaited_.scene = std::move(news.scene);
        awaited_.text = shownText(); // news of older texts do not come
        changes.diagnostics = true;
    }
    if (news.motion) {
        generation_ += !awaited_.scene && !shown_.motion ? 1 : 0;
        (awaited_.scene ? awaited_ : shown_).motion = std::move(news.motion);
        changes.motion = true;
    }
    if (news.statistics)
        statistics_ = news.statistics;
    if (news.refusal) {
        refusal_ = std::move(*news.refusal);
        cancelled_ = news.cancelled;
        faulty_ = faulty_ || !refusal_.empty();
        changes.ended = changes.diagnostics = true;
        if (!refusal_.empty())
            awaited_ = {};
    }
    textGeneration_ += changes.diagnostics ? 1 : 0;
    if (awaited_.scene && takeOverNow(now)) {
        takeOver(now);
        changes.scene = changes.motion = true;
    }
    if (changes.ended && changes.motion) { // whole, and no draft: the picture frames all of it
        ++viewGeneration_;
        ++generation_;
    }
    if (changes.motion && !shown_.motion)
        changes.motion = false;
    if (changes.motion)
        playback.setSpan(
            {shown_.motion->start(), shown_.motion->finish(), shown_.motion->computed()}, now);
    return changes;
}

bool Subdocument::takeOverNow(Instant now) const {
    if (!worker_.busy() || !read_ || now >= *read_ + longestWait)
        return true;
    return awaited_.motion && (!shown_.scene || awaited_.motion->computed() >= playback.time(now));
}

void Subdocument::takeOver(Instant now) {
    shown_ = std::exchange(awaited_, {});
    ++generation_;
    ++viewGeneration_;
    if (!shown_.motion) {
        const scene::Simulator& simulator = shown_.scene->simulator;
        playback.setSpan(
            {simulator.start, std::max(simulator.start, simulator.finish), simulator.start}, now);
    }
}

std::optional<double> Subdocument::knownUntil() const {
    if (awaited_.scene || !read_ || faulty_ || !shown_.motion)
        return std::nullopt;
    return shown_.motion->computed();
}

ipc::MotionState Subdocument::state() const {
    if (worker_.busy())
        return ipc::MotionState::computing;
    if (faulty_)
        return shown_.scene ? ipc::MotionState::stale : ipc::MotionState::failed;
    if (!shown_.motion || cancelled_ || anyStop(*shown_.motion))
        return ipc::MotionState::failed;
    return shown_.motion->draft() ? ipc::MotionState::draft : ipc::MotionState::current;
}

std::vector<scene::Diagnostic> Subdocument::faults() const {
    std::vector<scene::Diagnostic> faults = faults_;
    for (const std::string& sentence : refusal_)
        faults.emplace_back().message = sentence;
    if (faulty_ || !shown_.motion || worker_.busy())
        return faults;
    const text::Places places(text_);
    for (scene::Diagnostic& said : simulation::reportOf(*shown_.scene, *shown_.motion)) {
        script::locate(places, said);
        faults.push_back(std::move(said));
    }
    return faults;
}

std::vector<ipc::DiagnosticItem> Subdocument::diagnostics() const {
    std::vector<ipc::DiagnosticItem> items;
    std::ranges::transform(faults(), std::back_inserter(items), itemOf);
    return items;
}

} // namespace service

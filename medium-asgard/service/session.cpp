#include "service/session.h"

#include <algorithm>

namespace service {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds betweenTimes{33};        // told to a host that shows a rendition
constexpr milliseconds betweenHiddenTimes{500}; // to one that shows none
constexpr milliseconds betweenValues{33};
constexpr milliseconds beforeProgress{400};
constexpr milliseconds betweenProgress{250};
constexpr milliseconds whileReadingSettles{250};
constexpr std::chrono::seconds longEnoughComputed{1};

bool sameButTime(const ipc::TimeChanged& a, const ipc::TimeChanged& b) {
    return a.playing == b.playing && a.rate == b.rate && a.loop == b.loop && a.start == b.start &&
           a.finish == b.finish && a.predictable == b.predictable && a.state == b.state &&
           a.motion == b.motion;
}

// Not-a-number differs from itself: what is told is compared.
bool sameValues(const ipc::Values& a, const ipc::Values& b) {
    const auto same = [](double x, double y) { return x == y || (x != x && y != y); };
    return std::ranges::equal(a.values, b.values, same) && a.faults == b.faults;
}

} // namespace

Session::Session(Platform platform, ipc::MediumChannel& channel)
    : platform_(std::move(platform)), channel_(channel), subdocument_(platform_.tools) {}

void Session::receive(const ipc::MediumChannel::Call& call, Instant now) {
    at_.now = now;
    if (const auto* told = std::get_if<ipc::Told<ipc::ToMedium>>(&call)) {
        std::visit(
            [this](const auto& message) {
                if constexpr (requires { this->hear(message); })
                    hear(message);
            },
            told->call);
        return;
    }
    const auto& asked = std::get<ipc::Asked<ipc::ToMedium>>(call);
    if (!host_.mode && !std::holds_alternative<ipc::Initialize>(asked.call) &&
        !std::holds_alternative<ipc::Ping>(asked.call))
        return channel_.refuse(asked.id,
                               {ipc::ErrorCode::invalidRequest, "initialize comes first"});
    std::visit(
        [&](const auto& message) {
            if constexpr (requires { this->serve(message); })
                reply(asked.id, serve(message));
            else if constexpr (requires { this->serve(asked.id, message); })
                serve(asked.id, message);
        },
        asked.call);
}

void Session::attend(Instant now) {
    at_.now = now;
    at_.due.reset();
    const Changes changes = subdocument_.update(now);
    pictures_.collect();
    if (changes.motion || changes.scene)
        for (auto& [id, subscription] : subscriptions_)
            subscription.reader.reset();
    gesture_.selection.follow(subdocument_.scene(), subdocument_.sceneText());
    if (changes.diagnostics && !subdocument_.previewing())
        tellDiagnostics();
    takeClosed();
    goOn();
    subdocument_.playback.advance(now);
    shown_.time = subdocument_.playback.time(now);
    tellProgress();
    tellGesture();
    answerWaiting();
    tellTime();
    tellValues();
    tellMenu();
    tellStates();
    drawOwed();
    useSpareTime();
    if (const auto deadline = subdocument_.deadline())
        dueAt(*deadline);
    if (subdocument_.playback.playing())
        dueAt(anyVisible() ? std::max(pace_.nextFrame, now + shortestFrame)
                           : now + betweenHiddenTimes);
}

std::optional<Instant> Session::deadline() const { return at_.due; }

void Session::dueAt(Instant instant) { at_.due = at_.due ? std::min(*at_.due, instant) : instant; }

// --- requests that wait -----------------------------------------------------------------------

// Nothing that is being read or computed will change a picture soon.
bool Session::settled(Instant now) const {
    if (!subdocument_.computing())
        return true;
    return host_.mode != ipc::Mode::batch && subdocument_.readAt() &&
           now >= *subdocument_.readAt() + whileReadingSettles;
}

// In a batch a picture must not depend on how far the motion happened to be.
bool Session::knownAt(double time, Instant now) const {
    if (!subdocument_.computing())
        return true;
    const auto known = subdocument_.knownUntil();
    return host_.mode != ipc::Mode::batch && known && *known >= time &&
           now >= subdocument_.startedAt() + longEnoughComputed;
}

void Session::answerWaiting() {
    for (std::size_t i = 0; i < waiting_.size();) {
        if (!waiting_[i].ready(at_.now)) {
            ++i;
            continue;
        }
        const auto answer = std::move(waiting_[i].answer);
        waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
        answer();
    }
    if (!waiting_.empty())
        dueAt(at_.now + whileReadingSettles);
}

// --- what is told -----------------------------------------------------------------------------

void Session::tellDiagnostics() {
    ipc::Diagnostics diagnostics{subdocument_.revision(), subdocument_.diagnostics()};
    if (told_.diagnostics == diagnostics)
        return;
    channel_.notify(diagnostics);
    told_.diagnostics = std::move(diagnostics);
}

void Session::tellProgress() {
    if (!subdocument_.computing()) {
        if (progress_.token)
            channel_.notify(ipc::ProgressEnd{*progress_.token, ""});
        progress_.token.reset();
        return;
    }
    if (!progress_.token) {
        const Instant begin = subdocument_.startedAt() + beforeProgress;
        if (at_.now < begin)
            return dueAt(begin);
        progress_.token = ++progress_.lastToken;
        channel_.notify(ipc::ProgressBegin{*progress_.token, "Computing the motion", true});
        progress_.next = at_.now;
    }
    if (at_.now >= progress_.next) {
        const Span& span = subdocument_.playback.span();
        ipc::ProgressReport report{*progress_.token, std::nullopt, ""};
        if (subdocument_.knownUntil() && span.finish > span.start)
            report.fraction = (span.computed - span.start) / (span.finish - span.start);
        channel_.notify(report);
        progress_.next = at_.now + betweenProgress;
    }
    dueAt(progress_.next);
}

ipc::TimeChanged Session::timeNow() const {
    const Playback& playback = subdocument_.playback;
    ipc::TimeChanged time;
    time.time = shown_.time;
    time.playing = playback.playing();
    time.rate = playback.rate();
    time.loop = playback.loops();
    time.start = playback.span().start;
    time.finish = playback.span().finish;
    time.computed = playback.span().computed;
    if (const auto& motion = subdocument_.motion())
        time.predictable = motion->predictableUntil();
    time.state = subdocument_.state();
    time.motion = subdocument_.viewGeneration(); // another scene, or a whole motion
    return time;
}

void Session::tellTime() {
    if (subdocument_.revision() == 0 && !subdocument_.scene() && !subdocument_.readAt())
        return; // nothing was loaded
    const ipc::TimeChanged time = timeNow();
    const bool urgent = !told_.time || !sameButTime(*told_.time, time);
    if (!urgent && told_.time->time == time.time && told_.time->computed == time.computed)
        return;
    if (!urgent && (at_.now < told_.nextTime || channel_.congested()))
        return dueAt(std::max(told_.nextTime, at_.now + shortestFrame));
    channel_.notify(time);
    told_.time = time;
    told_.nextTime = at_.now + (anyVisible() ? betweenTimes : betweenHiddenTimes);
}

void Session::tellValues() {
    if (!subdocument_.motion() || subscriptions_.empty() || channel_.congested() ||
        subdocument_.motionIsStale()) // values of the scene and of its motion belong together
        return;
    if (at_.now < told_.nextValues)
        return dueAt(told_.nextValues);
    for (auto& [id, subscription] : subscriptions_) {
        if (!subscription.reader)
            subscription.reader.emplace(valuesOf(subscription.expressions));
        ipc::Values now = subscription.reader->at(shown_.time);
        if (subscription.told && sameValues(*subscription.told, now))
            continue;
        channel_.notify(ipc::ValueChanged{id, shown_.time, now.values, now.faults});
        subscription.told = std::move(now);
        told_.nextValues = at_.now + betweenValues;
    }
}

MenuState Session::menuNow() {
    MenuState state;
    const Playback& playback = subdocument_.playback;
    state.hasMotion = subdocument_.motion() && playback.span().finish > playback.span().start;
    state.playing = playback.playing();
    state.loops = playback.loops();
    state.rate = playback.rate();
    state.drafts = host_.drafts;
    state.selected = gesture_.selection.name();
    state.closing = offerToClose();
    if (gesture_.ways && gesture_.ways->inMenu &&
        gesture_.ways->revision == subdocument_.revision())
        for (const editing::Offer& one : gesture_.ways->all)
            state.ways.push_back(one.label);
    if (!subdocument_.previewing())
        state.commands = gesture_.selection.commands(subdocument_.motion());
    else if (told_.menu && told_.menu->selected == state.selected)
        state.commands = told_.menu->commands; // a drag changes no entry
    state.display = shown_.display;
    for (const auto& [id, rendition] : shown_.all)
        if (rendition.visible) {
            state.display = rendition.display;
            break;
        }
    return state;
}

void Session::tellMenu() {
    const MenuState state = menuNow();
    if (!host_.mode || told_.menu == state)
        return;
    if (told_.menu)
        channel_.notify(ipc::MenuChanged{menuOf(state)});
    told_.menu = state;
}

// How each rendition is seen, once its user lets go.
void Session::tellStates() {
    for (auto& [id, rendition] : shown_.all) {
        if (rendition.beingTurned())
            continue;
        if (at_.now < rendition.calmAt) {
            dueAt(rendition.calmAt);
            continue;
        }
        std::string state = rendition.state();
        if (state == rendition.toldState)
            continue;
        channel_.notify(ipc::RenditionState{id, state});
        rendition.toldState = std::move(state);
    }
}

bool Session::anyVisible() const {
    return std::ranges::any_of(shown_.all, [](const auto& entry) { return entry.second.visible; });
}

} // namespace service

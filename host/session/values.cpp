#include "session/values.h"

#include "session/open_document.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace session {

using document::SubdocumentId;
using media::LiveSubdocument;

namespace {

const std::string tooMany =
    "a figure tells at most 1000 values for one time, each of at most 4096 bytes, and 100 times";

bool isKnowingMotion(const ipc::TimeChanged& time) {
    return time.state != ipc::MotionState::computing && time.state != ipc::MotionState::stale;
}

bool isReady(const LiveSubdocument& live) {
    return live.condition() == media::Condition::live && live.hasLoaded();
}

Values::Known knownOf(const ipc::Values& told, std::size_t at) {
    Values::Known known;
    if (std::isfinite(told.values[at]))
        known.number = told.values[at];
    else
        known.fault = told.faults.empty() || told.faults[at].empty() ? "it has no value now"
                                                                     : told.faults[at];
    return known;
}

} // namespace

Values::Values(OpenDocument& document, std::function<std::vector<PlacedValue>()> placed)
    : document_(document), placed_(std::move(placed)) {
    for (QTimer* timer : {&gather_, &tell_, &late_, &settleBy_})
        timer->setSingleShot(true);
    connect(&gather_, &QTimer::timeout, this, &Values::gather);
    connect(&tell_, &QTimer::timeout, this, &Values::tell);
    connect(&late_, &QTimer::timeout, this, &Values::markLate);
    connect(&settleBy_, &QTimer::timeout, this, &Values::giveUpSettling);
    const document::Document* of = &document_.document();
    connect(of, &document::Document::textChanged, this, &Values::textChanged);
    connect(of, &document::Document::changed, this, [this] { gather_.start(soonMs); });
    gather_.start(0);
}

Values::~Values() {
    for (const auto& [id, timer] : held_)
        if (const auto figure = figures_.find(id); figure != figures_.end() && figure->second.live)
            document_.media().setDistance(*figure->second.live, this, media::LiveMedia::notNeeded);
}

// --- what is known -----------------------------------------------------------------------------

model::ValueNow Values::valueNow(const document::ValueUse& use) const {
    const auto named = names_.find(use.of);
    const auto figure = named == names_.end() ? figures_.end() : figures_.find(named->second);
    if (named == names_.end() && !gather_.isActive())
        return {.fault = "no subdocument has the ID " + use.of};
    if (figure == figures_.end())
        return {};
    const Figure& of = figure->second;
    if (!of.live)
        return {.fault = document_.whyNotLive(named->second).toStdString()};
    const auto known = of.known.find({use.expression, use.time});
    if (known == of.known.end() && of.refusal.empty() && isDone(of))
        return {.fault = tooMany};
    if (known == of.known.end())
        return {.fault = of.refusal};
    const auto place = std::ranges::find(of.moving, use.expression) - of.moving.begin();
    const bool isUnwatched = !use.time && std::cmp_greater_equal(place, media::ValueWatch::most);
    return {.number = known->second.number,
            .fault = known->second.fault,
            .isOutdated = (of.isLate && of.answered != of.text) || (isUnwatched && of.isPlaying),
            .moves = of.isPlaying && !use.time};
}

bool Values::isDone(const Figure& figure) {
    return figure.awaited == 0 &&
           (!figure.live || figure.answered == figure.text || !figure.refusal.empty());
}

bool Values::isSettled() const {
    return !gather_.isActive() &&
           std::ranges::all_of(figures_, [](const auto& one) { return isDone(one.second); });
}

void Values::settle() {
    if (gather_.isActive())
        gather();
    for (auto& [id, figure] : figures_)
        if (!isDone(figure))
            ask(id);
    isSettling_ = true; // from here on: not inside this call
    settleBy_.start(mostMs);
    QMetaObject::invokeMethod(this, &Values::tellSettled, Qt::QueuedConnection);
}

// A medium that has not answered by now is not waited for.
void Values::giveUpSettling() {
    std::vector<SubdocumentId> silent;
    if (isSettling_)
        for (const auto& [id, figure] : figures_)
            if (!isDone(figure))
                silent.push_back(id);
    for (const SubdocumentId id : silent)
        giveUp(id);
}

void Values::tellSettled() {
    if (isSettled() && std::exchange(isSettling_, false)) {
        tell_.stop();
        tell();
        Q_EMIT settled();
    }
}

std::vector<sgml::Fault> Values::faults() const {
    std::vector<sgml::Fault> result;
    for (const PlacedValue& placed : placed_()) {
        std::string why = placed.use.fault;
        const bool isNamed = names_.contains(placed.use.of);
        if (why.empty() && (isNamed || !placed.isElement)) // else: the document's faults say so
            why = valueNow(placed.use).fault;
        if (why.empty())
            continue;
        sgml::Fault& fault = result.emplace_back();
        fault.severity = sgml::Severity::error;
        fault.range = placed.range;
        fault.message = placed.use.fault.empty() ? "there is no number here: " + why : why;
    }
    return result;
}

// --- what is asked -----------------------------------------------------------------------------

void Values::gather() {
    gather_.stop();
    names_.clear();
    for (const SubdocumentId id : document_.document().subdocuments())
        if (const std::string& name = document_.document().subdocument(id)->name; !name.empty())
            names_.try_emplace(name, id);
    std::map<SubdocumentId, Figure> wanted;
    const std::vector<PlacedValue> all = placed_();
    const bool hasAny = !all.empty();
    for (const PlacedValue& placed : all) {
        const document::ValueUse& use = placed.use;
        const auto named = names_.find(use.of);
        if (named == names_.end() || !use.fault.empty())
            continue;
        Figure& figure = wanted[named->second];
        if (use.time && !figure.fixed.contains(*use.time) && figure.fixed.size() >= mostTimes)
            continue;
        std::vector<std::string>& asked = use.time ? figure.fixed[*use.time] : figure.moving;
        if (use.expression.size() <= ipc::longestExpression.most &&
            asked.size() < ipc::mostExpressions.most &&
            std::ranges::count(asked, use.expression) == 0)
            asked.push_back(use.expression);
    }
    std::erase_if(figures_, [&](auto& one) {
        if (wanted.contains(one.first))
            return false;
        if (one.second.live) {
            one.second.live->watch({});
            one.second.live->disconnect(this);
        }
        release(one.first);
        return true;
    });
    for (auto& [id, now] : wanted) {
        Figure& figure = figures_[id];
        const bool isSame = figure.moving == now.moving && figure.fixed == now.fixed &&
                            figure.live == document_.live(id) && figure.live;
        if (isSame)
            continue;
        figure.moving = std::move(now.moving);
        figure.fixed = std::move(now.fixed);
        expectOthers(figure); // there may be one more
        follow(id, figure);
        ask(id);
    }
    hasChanged_ = haveFaultsChanged_ = std::exchange(hasAny_, hasAny) || hasAny;
    tell();
    tellSettled();
}

void Values::follow(SubdocumentId id, Figure& figure) {
    LiveSubdocument* live = document_.live(id);
    if (figure.live == live)
        return;
    figure.live = live;
    figure.awaited = 0; // what the one before was asked is not answered any more
    ++figure.question;
    release(id);
    if (!live)
        return;
    connect(live, &LiveSubdocument::loaded, this, [this, id] { ask(id); });
    connect(live, &LiveSubdocument::valuesChanged, this, [this, id] { takeTold(id); });
    connect(live, &LiveSubdocument::timeChanged, this, [this, id] { takeTime(id); });
    connect(live, &LiveSubdocument::conditionChanged, this, [this, id] {
        const auto found = figures_.find(id);
        if (found == figures_.end() || !found->second.live || isDone(found->second))
            return;
        const LiveSubdocument& of = *found->second.live;
        if (of.condition() == media::Condition::failed || isReady(of))
            ask(id);
    });
}

// Of the text as it is. A process that is not there starts.
void Values::ask(SubdocumentId id) {
    const auto found = figures_.find(id);
    if (found == figures_.end() || !found->second.live)
        return;
    Figure& figure = found->second;
    LiveSubdocument& live = *figure.live;
    live.watch(figure.moving);
    if (live.condition() == media::Condition::failed) {
        figure.awaited = 0;
        ++figure.question;
        figure.asked = figure.text;
        refuse(figure, {static_cast<ipc::Integer>(ipc::ErrorCode::notPossible),
                        live.reason().toStdString()});
        return answered(id);
    }
    if (figure.awaited > 0)
        return; // answered() asks again
    if (!isReady(live))
        return want(id);
    figure.asked = figure.text;
    ++figure.question;
    figure.refusal.clear();
    figure.awaited = (figure.moving.empty() ? 0 : 1) + static_cast<int>(figure.fixed.size());
    if (!figure.moving.empty())
        read(id, figure.moving, std::nullopt);
    for (const auto& [time, expressions] : figure.fixed)
        read(id, expressions, time);
    if (figure.awaited == 0)
        answered(id);
}

void Values::read(SubdocumentId id, const std::vector<std::string>& expressions,
                  std::optional<double> time) {
    const QPointer<Values> guard(this);
    const auto take = [guard, id, expressions, time, question = figures_[id].question](
                          const media::Outcome<ipc::Values>& outcome) {
        const auto found = guard ? guard->figures_.find(id) : decltype(figures_)::iterator();
        if (!guard || found == guard->figures_.end() || found->second.question != question)
            return;
        Figure& figure = found->second;
        if (const auto* error = std::get_if<ipc::Error>(&outcome)) {
            guard->refuse(figure, *error);
        } else {
            const auto& told = std::get<ipc::Values>(outcome);
            for (std::size_t i = 0; i < expressions.size(); ++i)
                guard->take(figure, expressions[i], time, knownOf(told, i));
        }
        if (--figure.awaited == 0)
            guard->answered(id);
    };
    figures_[id].live->readValues(expressions, time, take);
}

void Values::refuse(Figure& figure, const ipc::Error& error) {
    if (error.code == static_cast<ipc::Integer>(ipc::ErrorCode::methodNotFound))
        figure.refusal = "its medium tells no values";
    else
        figure.refusal = error.message.empty() ? "its medium says nothing" : error.message;
    hasChanged_ = haveFaultsChanged_ = true;
}

void Values::take(Figure& figure, const std::string& expression, std::optional<double> time,
                  Known known) {
    Known& was = figure.known[{expression, time}];
    if (was == known)
        return;
    haveFaultsChanged_ = haveFaultsChanged_ || was.fault != known.fault;
    was = std::move(known);
    hasChanged_ = true;
}

// All of them; or it has refused.
void Values::answered(SubdocumentId id) {
    Figure& figure = figures_[id];
    if (figure.refusal.empty()) {
        hasChanged_ = hasChanged_ || figure.isLate;
        figure.answered = figure.asked;
    }
    const bool isGone = figure.live && !isReady(*figure.live) &&
                        figure.live->condition() != media::Condition::failed;
    if (figure.answered == figure.text) {
        figure.isLate = false;
    } else if (isGone || figure.asked != figure.text) {
        figure.refusal.clear();
        ask(id); // its process ended, or the text has changed meanwhile
        return tell();
    } else {
        figure.isLate = true; // nothing more will come of this text
    }
    release(id);
    tell();
    tellSettled();
}

// --- what is told ------------------------------------------------------------------------------

void Values::takeTold(SubdocumentId id) {
    const auto found = figures_.find(id);
    if (found == figures_.end() || !found->second.live)
        return;
    const media::ValueWatch& watched = found->second.live->watched();
    for (std::size_t i = 0; i < watched.values().values.size(); ++i)
        take(found->second, watched.expressions()[i], std::nullopt, knownOf(watched.values(), i));
    tell();
}

// A motion that was computed anew has other values at fixed times, too.
void Values::takeTime(SubdocumentId id) {
    const auto found = figures_.find(id);
    if (found == figures_.end() || !found->second.live || !found->second.live->time())
        return;
    Figure& figure = found->second;
    const ipc::TimeChanged& time = *figure.live->time();
    const bool hadMotion = std::exchange(figure.hasMotion, isKnowingMotion(time));
    const bool isAnother =
        figure.hasMotion && std::exchange(figure.motion, time.motion) != time.motion && hadMotion;
    const bool hasMoved = std::exchange(figure.shown, time.time) != time.time;
    if (std::exchange(figure.isPlaying, time.playing) != time.playing)
        hasChanged_ = true;
    const bool isUnwatched = figure.moving.size() > media::ValueWatch::most && hasMoved;
    if (isAnother)
        expectOthers(figure);
    if (isReady(*figure.live) &&
        (isAnother || (figure.awaited == 0 &&
                       ((figure.hasMotion && !hadMotion) || (isUnwatched && !time.playing)))))
        ask(id);
    tell();
}

// Those that are known may be out of date.
void Values::expectOthers(Figure& figure) {
    ++figure.text;
    figure.refusal.clear();
    if (!late_.isActive())
        late_.start(lateMs);
}

void Values::textChanged(SubdocumentId id) {
    const auto found = figures_.find(id);
    if (found == figures_.end())
        return;
    expectOthers(found->second);
    ask(id);
}

void Values::markLate() {
    for (auto& [id, figure] : figures_)
        if (figure.answered != figure.text) {
            figure.isLate = true;
            hasChanged_ = true;
        }
    tell();
}

void Values::tell() {
    if (tell_.isActive())
        return; // it comes
    const bool numbers = std::exchange(hasChanged_, false);
    const bool faults = std::exchange(haveFaultsChanged_, false);
    if (numbers || faults)
        tell_.start(betweenMs);
    if (numbers)
        Q_EMIT changed();
    if (faults)
        Q_EMIT faultsChanged();
}

// --- processes that start for values alone -----------------------------------------------------

void Values::want(SubdocumentId id) {
    if (held_.contains(id) || std::ranges::count(wanted_, id) > 0)
        return;
    wanted_.push_back(id);
    startWanted();
}

void Values::startWanted() {
    while (held_.size() < atOnce && !wanted_.empty()) {
        const SubdocumentId id = wanted_.front();
        wanted_.pop_front();
        const auto found = figures_.find(id);
        if (found == figures_.end() || !found->second.live)
            continue;
        auto* timer = new QTimer(this);
        timer->setSingleShot(true);
        held_[id] = timer;
        connect(timer, &QTimer::timeout, this, [this, id] { giveUp(id); });
        timer->start(mostMs);
        // Nearer than anything that is seen, as for paper: it answers soon, and rests then.
        document_.media().setDistance(*found->second.live, this, -1);
    }
}

void Values::giveUp(SubdocumentId id) {
    const auto found = figures_.find(id);
    if (found == figures_.end())
        return release(id);
    found->second.awaited = 0;
    ++found->second.question;
    found->second.asked = found->second.text;
    refuse(found->second, {static_cast<ipc::Integer>(ipc::ErrorCode::notPossible),
                           "its medium did not answer in time"});
    release(id);
    tell();
    tellSettled();
}

void Values::release(SubdocumentId id) {
    std::erase(wanted_, id);
    const auto held = held_.find(id);
    if (held == held_.end())
        return;
    held->second->deleteLater();
    held_.erase(held);
    if (const auto found = figures_.find(id); found != figures_.end() && found->second.live)
        document_.media().setDistance(*found->second.live, this, media::LiveMedia::notNeeded);
    startWanted();
}

} // namespace session

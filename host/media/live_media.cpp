#include "media/live_media.h"

#include <algorithm>
#include <iterator>

namespace media {

namespace {

// How soon figures that wait for memory are looked at again.
constexpr int lookAgainMs = 500;

bool mayBeEnded(const LiveSubdocument& one) {
    return one.hasProcess() && !one.hasWindows() && one.windows().open == 0;
}

// The one that goes first of those that are equally near.
int rank(const LiveSubdocument& one) {
    const bool plays = one.time() && one.time()->playing;
    if (one.hasProcess())
        return plays || !one.hasPicture() ? 0 : 2;
    return one.hasPicture() ? 3 : 1;
}

} // namespace

LiveMedia::LiveMedia(Registry registry, QString executableFolder, PipeThread& pipes,
                     TimeLimits limits, QObject* parent)
    : QObject(parent), registry_(std::move(registry)),
      executableFolder_(std::move(executableFolder)), pipes_(pipes), limits_(limits) {
    choice_.setSingleShot(true);
    choice_.setInterval(0);
    connect(&choice_, &QTimer::timeout, this, &LiveMedia::choose);
    room_.setSingleShot(true);
    room_.setInterval(lookAgainMs);
    connect(&room_, &QTimer::timeout, this, &LiveMedia::choose);
}

void LiveMedia::setMostLive(int count) {
    mostLive_ = std::max(1, count);
    scheduleChoice();
}

void LiveMedia::scheduleChoice() {
    if (!choice_.isActive())
        choice_.start();
}

std::unique_ptr<LiveSubdocument> LiveMedia::create(const QString& documentClass) {
    const Manifest* manifest = registry_.forClass(documentClass);
    if (!manifest)
        return nullptr;
    auto subdocument = std::make_unique<LiveSubdocument>(
        *manifest, programOf(*manifest, executableFolder_), pipes_, limits_);
    LiveSubdocument* made = subdocument.get();
    connect(made, &QObject::destroyed, this, [this, made] {
        distances_.remove(made);
        scheduleChoice();
    });
    connect(made, &LiveSubdocument::firstPicture, this, &LiveMedia::scheduleChoice);
    connect(made, &LiveSubdocument::processGone, this, &LiveMedia::scheduleChoice);
    return subdocument;
}

void LiveMedia::setDistance(LiveSubdocument& subdocument, const void* view, double distance) {
    auto& ofViews = distances_[&subdocument];
    if (distance >= notNeeded)
        ofViews.remove(view);
    else
        ofViews[view] = distance;
    scheduleChoice();
}

std::vector<LiveSubdocument*> LiveMedia::byDistance() const {
    std::vector<std::pair<double, LiveSubdocument*>> order;
    for (auto of = distances_.begin(); of != distances_.end(); ++of)
        if (!of->isEmpty())
            order.emplace_back(*std::min_element(of->begin(), of->end()), of.key());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
        return std::pair(a.first, rank(*a.second)) < std::pair(b.first, rank(*b.second));
    });
    std::vector<LiveSubdocument*> result;
    for (const auto& [distance, subdocument] : order)
        if (subdocument->condition() != Condition::failed)
            result.push_back(subdocument);
    return result;
}

int LiveMedia::live() const {
    int count = 0;
    for (auto of = distances_.begin(); of != distances_.end(); ++of)
        count += of.key()->hasProcess() ? 1 : 0;
    return count;
}

// There is too little memory for one that is needed: `another`, if any, gives back what it holds,
// unless one that was ended before is still about to.
void LiveMedia::awaitRoom(LiveSubdocument* another) {
    if (another && pipes_.alive() <= live())
        another->makeStill();
    room_.start();
}

void LiveMedia::choose() {
    std::vector<LiveSubdocument*> wanted = byDistance();
    if (wanted.size() > static_cast<std::size_t>(mostLive_))
        wanted.resize(static_cast<std::size_t>(mostLive_));
    std::vector<LiveSubdocument*> idle;
    for (auto of = distances_.begin(); of != distances_.end(); ++of)
        if (mayBeEnded(*of.key()) && std::ranges::find(wanted, of.key()) == wanted.end())
            idle.push_back(of.key());
    for (auto next = wanted.begin(); next != wanted.end(); ++next) {
        if ((*next)->condition() != Condition::still)
            continue;
        if (!pipes_.hasRoom()) {
            const auto farthest = std::find_if(wanted.rbegin(), std::make_reverse_iterator(next),
                                               [](auto* one) { return mayBeEnded(*one); });
            const bool isFarther = farthest != std::make_reverse_iterator(next);
            return awaitRoom(!idle.empty() ? idle.back() : isFarther ? *farthest : nullptr);
        }
        if (live() >= mostLive_ && !idle.empty()) {
            idle.back()->makeStill();
            idle.pop_back();
        }
        (*next)->start();
    }
}

} // namespace media

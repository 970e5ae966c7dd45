#include "processes/pulse.h"

#include <algorithm>

namespace media {

void Pulse::begin() {
    phase_ = Phase::beginning;
    since_.start();
}

void Pulse::introduced() {
    phase_ = Phase::pinged;
    since_.start();
}

void Pulse::askedToEnd() {
    phase_ = Phase::ending;
    since_.start();
}

bool Pulse::answered() {
    sincePing_.invalidate();
    if (phase_ == Phase::pinged)
        since_.start();
    return !std::exchange(responding_, true);
}

int Pulse::interval() const {
    return std::min({limits_.pingEvery, limits_.quiet, limits_.shutdown}) / 2 + 1;
}

Pulse::Due Pulse::due() {
    if (phase_ == Phase::beginning && since_.hasExpired(limits_.initialize))
        return {Due::What::end, QStringLiteral("did not answer within %1 s of its start")
                                    .arg(limits_.initialize / 1e3)};
    if (phase_ == Phase::ending && since_.hasExpired(limits_.shutdown))
        return {Due::What::end, QStringLiteral("did not end when asked to")};
    return phase_ == Phase::pinged ? dueOfPing() : Due{};
}

Pulse::Due Pulse::dueOfPing() {
    if (!sincePing_.isValid())
        return {since_.hasExpired(limits_.pingEvery) ? Due::What::ping : Due::What::nothing};
    if (sincePing_.hasExpired(limits_.hung))
        return {Due::What::end, QStringLiteral("did not respond for %1 s").arg(limits_.hung / 1e3)};
    if (!responding_ || !sincePing_.hasExpired(limits_.quiet))
        return {};
    responding_ = false;
    return {Due::What::sayThatItIsQuiet};
}

} // namespace media

#include "media/restarts.h"

#include <QObject>
#include <algorithm>

namespace media {

namespace {

constexpr qint64 minute = 60'000;
constexpr qint64 hour = 60 * minute;

} // namespace

int Restarts::since(qint64 time) const {
    return static_cast<int>(std::ranges::count_if(times_, [=](qint64 at) { return at > time; }));
}

bool Restarts::mayTry(qint64 now) {
    if (since(now - minute) >= perMinute_ || since(now - hour) >= perHour_)
        return false;
    std::erase_if(times_, [=](qint64 at) { return at <= now - hour; });
    times_.push_back(now);
    return true;
}

QString Restarts::told(qint64 now) const {
    const int inMinute = since(now - minute), inHour = since(now - hour);
    if (inHour == 0)
        return {};
    return inMinute == inHour
               ? QObject::tr("It was started again %1 times within a minute.").arg(inMinute)
               : QObject::tr("It was started again %1 times within an hour.").arg(inHour);
}

} // namespace media

#include "media/kept_time.h"

#include <algorithm>

namespace media {

KeptTime::Commands KeptTime::told(const ipc::TimeChanged& time) {
    last_ = time;
    Commands commands;
    if (!poster_ || time.finish <= time.start)
        return commands;
    if (time.playing) {
        poster_.reset();
        commands.seek = ipc::TimeSeek{time.start};
        commands.play = true; // the finish may have come before
    } else if (time.time == std::clamp(*poster_, time.start, time.finish)) {
        atPoster_ = true;
    } else if (atPoster_) {
        poster_.reset();
    }
    return commands;
}

KeptTime::Commands KeptTime::forNextProcess() const {
    Commands commands;
    if (last_) {
        commands.rate = ipc::TimeRate{last_->rate, last_->loop};
        commands.seek = ipc::TimeSeek{last_->time};
        commands.play = last_->playing;
    } else if (poster_) {
        commands.seek = ipc::TimeSeek{*poster_};
    }
    return commands;
}

} // namespace media

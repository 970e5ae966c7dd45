// The time that a subdocument shows, over all of its processes.
//
// At first it stands at its poster. Playing begins at the start, whoever began it: a command of
// ours, or the medium's menu and keys. A time that was looked for by hand stays, and the next
// process is told the last time, rate and whether it played.
#pragma once

#include "ipc/messages.h"

#include <optional>

namespace media {

class KeptTime {
public:
    // For a process, in this order.
    struct Commands {
        std::optional<ipc::TimeRate> rate;
        std::optional<ipc::TimeSeek> seek;
        bool play = false;
    };

    void setPoster(std::optional<double> time) { poster_ = time; } // s
    void chosenByHand() { poster_.reset(); }

    // The time that a process told last: nothing before, and of a medium without time.
    [[nodiscard]] const std::optional<ipc::TimeChanged>& last() const { return last_; }
    // A process told its time; the commands in return.
    [[nodiscard]] Commands told(const ipc::TimeChanged& time);
    [[nodiscard]] Commands forNextProcess() const; // right behind the text

private:
    std::optional<ipc::TimeChanged> last_;
    std::optional<double> poster_; // until it is played
    bool atPoster_ = false;        // the medium has told that it shows it
};

} // namespace media

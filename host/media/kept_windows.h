// The state of a medium's own windows, for its next process.
//
// The medium sends it in words of its own (session/keep): the open windows with the text typed
// there. It outlives the process. The next process in edit mode gets it, once: if that one ends
// before it has sent a state itself, the old state may have ended it, and the process after it
// shows pictures only, until the user asks for a window.
#pragma once

#include "processes/manifest.h"

#include "ipc/messages.h"

#include <QString>
#include <optional>
#include <string>

namespace media {

class KeptWindows {
public:
    static constexpr std::size_t longest = 8 << 20; // bytes; a longer state is not kept

    void keep(const std::string& state); // "": no window is open
    [[nodiscard]] const std::string& state() const { return state_; }
    [[nodiscard]] bool any() const { return !state_.empty(); }

    // For a process in edit mode that begins; `why` is the sentence that says how the last one
    // ended, "" when it is not known.
    [[nodiscard]] std::optional<ipc::SessionRestore> handOver(const QString& medium,
                                                              const QString& why);
    // A process ended unexpectedly: whether the next is to open the windows again.
    [[nodiscard]] bool opensAgain();

    // The sentence that the reader is told at the picture, until it is dismissed.
    [[nodiscard]] const QString& notice() const { return notice_; }
    [[nodiscard]] bool dismiss(); // false: there was none

private:
    std::string state_;
    QString notice_;
    bool untried_ = false; // was handed over, and nothing was kept since
};

} // namespace media

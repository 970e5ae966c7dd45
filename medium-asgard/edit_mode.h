// The medium's process in mode `edit`: the same session, beside windows in which the author works.
//
// The text is the host's. A window proposes its change to the host; it becomes the text when the
// host accepts. Changes by the host (undo, redo, another view) arrive in every window. Scene and
// motion are the session's: the windows show what the renditions in the document show.
#pragma once

#include "service/serve.h"

namespace asgard {

// Opens the windows that menu entries name; made once the mode is known.
class Windows {
public:
    virtual ~Windows() = default;
    virtual std::optional<std::string> open(const std::string& entry,
                                            const std::optional<ipc::ScreenArea>& figure) = 0;
    // Those of a process that ended; `notice` says in them what happened.
    virtual void restore(const std::string& state, const std::string& notice) = 0;
};

// Serves until the connection is closed. `windows` points to the windows meanwhile.
void serveWithWindows(service::Connection& connection, Windows*& windows);

} // namespace asgard

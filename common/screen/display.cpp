#include "screen/display.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace screen {

namespace {

// Does a server listen at this place? A name that begins with a zero byte is not in the file
// system.
bool listens(const std::string& name) {
    sockaddr_un address{};
    if (name.empty() || name.size() >= sizeof address.sun_path)
        return false;
    const int handle = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (handle < 0)
        return false;
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, name.data(), name.size());
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    const bool connected =
        connect(handle, reinterpret_cast<const sockaddr*>(&address), length) == 0;
    close(handle);
    return connected;
}

// DISPLAY is HOST:NUMBER.SCREEN; without a host, or with "unix", it is of this machine.
bool answersX11(const std::string& display) {
    const std::size_t colon = display.rfind(':');
    if (colon == std::string::npos)
        return false;
    if (display[0] == '/') // a socket by its name
        return listens(display) || listens(display.substr(0, colon));
    if (colon > 0 && display.compare(0, colon, "unix") != 0)
        return true;
    const std::string number = display.substr(colon + 1, display.find('.', colon) - colon - 1);
    const std::string socket = "/tmp/.X11-unix/X" + number;
    return listens(socket) || listens(std::string(1, '\0') + socket);
}

bool answersWayland(const std::string& display, const std::string& folder) {
    return listens(display[0] == '/' ? display : folder + "/" + display);
}

} // namespace

std::string displayFault(const Environment& environment) {
    if (!environment("QT_QPA_PLATFORM").empty()) // chosen by who knows
        return "";
    const std::string x11 = environment("DISPLAY"), wayland = environment("WAYLAND_DISPLAY");
    if (x11.empty() && wayland.empty())
        return "there is no display to open a window on";
    if (!x11.empty() && answersX11(x11))
        return "";
    if (!wayland.empty() && answersWayland(wayland, environment("XDG_RUNTIME_DIR")))
        return "";
    return "the display " + (x11.empty() ? wayland : x11) + " does not answer";
}

std::string displayFault() {
    return displayFault([](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value ? value : "");
    });
}

} // namespace screen

#include "processes/environment.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <unistd.h>

namespace media {

namespace {

// The variables that desktops and their libraries read: by their first letters...
constexpr std::array<std::string_view, 9> families{"QT_",  "XDG_",   "XCURSOR_", "WAYLAND_", "KDE_",
                                                   "GTK_", "GNOME_", "IBUS_",    "FCITX_"};
// ...and by name.
constexpr std::array<std::string_view, 13> names{"DISPLAY",
                                                 "XAUTHORITY",
                                                 "XMODIFIERS",
                                                 "HOME",
                                                 "USER",
                                                 "LOGNAME",
                                                 "TZ",
                                                 "DESKTOP_SESSION",
                                                 "LANGUAGE",
                                                 "SESSION_MANAGER",
                                                 "TMPDIR",
                                                 "GDK_SCALE",
                                                 "DBUS_SESSION_BUS_ADDRESS"};
// The categories of a locale but LC_NUMERIC.
constexpr std::array<const char*, 11> categories{
    "LC_CTYPE", "LC_TIME",    "LC_COLLATE",   "LC_MONETARY",    "LC_MESSAGES",      "LC_PAPER",
    "LC_NAME",  "LC_ADDRESS", "LC_TELEPHONE", "LC_MEASUREMENT", "LC_IDENTIFICATION"};

std::string_view valueOf(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

// LC_ALL would hold for numbers, too: it is spread over the other categories.
void addLanguage(std::vector<std::string>& environment) {
    const std::string_view all = valueOf("LC_ALL"), lang = valueOf("LANG");
    environment.push_back("LANG=" + std::string(!all.empty()    ? all
                                                : !lang.empty() ? lang
                                                                : "C.UTF-8"));
    for (const char* category : categories)
        if (const auto value = all.empty() ? valueOf(category) : all; !value.empty())
            environment.push_back(std::string(category) + '=' + std::string(value));
    environment.emplace_back("LC_NUMERIC=C");
}

bool isOfDesktop(std::string_view name) {
    return std::ranges::find(names, name) != names.end() ||
           std::ranges::any_of(families,
                               [&](std::string_view family) { return name.starts_with(family); });
}

} // namespace

std::vector<std::string> environmentFor(ipc::Mode mode) {
    std::vector<std::string> environment{"PATH=/usr/local/bin:/usr/bin:/bin"};
    if (mode != ipc::Mode::edit) {
        environment.insert(environment.end(), {"LANG=C.UTF-8", "LC_ALL=C.UTF-8"});
        return environment;
    }
    addLanguage(environment);
    for (char** variable = environ; variable && *variable; ++variable) {
        const std::string_view entry = *variable;
        if (isOfDesktop(entry.substr(0, entry.find('='))))
            environment.emplace_back(entry);
    }
    return environment;
}

} // namespace media

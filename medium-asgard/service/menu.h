// The commands that the medium puts into the host's menus and tool area.
#pragma once

#include "ipc/messages.h"
#include "render/renderer.h"
#include "service/thing_commands.h"

#include <array>
#include <memory>

namespace service {

// The state that the menus show.
struct MenuState {
    bool hasMotion = false, playing = false, loops = false, computing = false;
    bool drafts = false; // something typed in a window is not in the document yet
    double rate = 1;
    std::string selected;                                      // body "b1"; "": nothing is
    std::shared_ptr<const std::vector<ThingCommand>> commands; // for it; null: none
    std::string closing; // the offer to close joints or move bodies apart; "": there is none
    std::vector<std::string> ways; // in place of a drag that could not be
    render::Display display;       // of the visible renditions
    bool operator==(const MenuState&) const;
};

inline constexpr std::array rates{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

// Makes drafts the document's text; hosts offer it before they save or close.
inline constexpr const char* updateDrafts = "update-drafts";

// Closes joints that are open at the start, or moves bodies apart; once more stops it.
inline constexpr const char* closeJoints = "close-joints";
// One of the ways in place of what could not be; its number follows.
inline const std::string wayPrefix = "way ";

// Of a command for the selected thing; its name follows the key, so that a menu that was opened for
// another thing does nothing.
[[nodiscard]] std::string idOf(const ThingCommand& command, const std::string& name);

[[nodiscard]] std::vector<ipc::MenuEntry> menuOf(const MenuState& state);

// The rate that "rate-0.25" names.
[[nodiscard]] std::optional<double> rateOf(const std::string& id);
// The switch of the display that an entry turns over, or null.
[[nodiscard]] bool render::Display::*displaySwitch(const std::string& id);

} // namespace service

// The commands that the medium puts into the host's menus and tool area.
#pragma once

#include "ipc/messages.h"
#include "render/renderer.h"

#include <array>

namespace service {

// The state that the menus show.
struct MenuState {
    bool hasMotion = false, playing = false, loops = false, computing = false;
    bool drafts = false; // something typed in a window is not in the document yet
    double rate = 1;
    std::string selected;    // body "b1"; "": nothing is
    render::Display display; // of the visible renditions
    bool operator==(const MenuState&) const;
};

inline constexpr std::array rates{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

// Makes drafts the document's text; hosts offer it before they save or close.
inline constexpr const char* updateDrafts = "update-drafts";

// Commands for the selected thing of a picture; its name follows, so that a menu that was opened
// for another thing does nothing.
inline const std::string deleteSelected = "delete ", duplicateSelected = "duplicate ";

[[nodiscard]] std::vector<ipc::MenuEntry> menuOf(const MenuState& state);

// The rate that "rate-0.25" names.
[[nodiscard]] std::optional<double> rateOf(const std::string& id);
// The switch of the display that an entry turns over, or null.
[[nodiscard]] bool render::Display::*displaySwitch(const std::string& id);

} // namespace service

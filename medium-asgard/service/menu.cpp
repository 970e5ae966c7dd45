#include "service/menu.h"

#include <cstdio>

namespace service {
namespace {

struct Switch {
    const char* id;
    const char* label;
    bool render::Display::*value;
    const char* group = "";
};
constexpr Switch switches[] = {
    {"position-handles", "Positions", &render::Display::positionHandles, "Handles"},
    {"orientation-handles", "Orientations", &render::Display::orientationHandles, "Handles"},
    {"velocity-handles", "Velocities", &render::Display::velocityHandles, "Handles"},
    {"spin-handles", "Angular Velocities", &render::Display::spinHandles, "Handles"},
    {"force-handles", "Forces", &render::Display::forceHandles, "Handles"},
    {"torque-handles", "Torques", &render::Display::torqueHandles, "Handles"},
    {"link-handles", "Links", &render::Display::linkHandles, "Handles"},
    {"joint-handles", "Joints", &render::Display::jointHandles, "Handles"},
    {"light-handles", "Lights", &render::Display::lightHandles, "Handles"},
    {"trajectories", "Trajectories", &render::Display::trajectories, "Handles"},
    {"wireframe", "Wireframe", &render::Display::wireframe},
    {"axes", "Axes", &render::Display::axes},
    {"grid", "Grid", &render::Display::grid},
    {"trails", "Trails", &render::Display::trails},
    {"joints", "Joints", &render::Display::joints},
    {"shadows", "Shadows", &render::Display::shadows},
    {"contact-forces", "Contact Forces", &render::Display::contactForces},
    {"friction-cones", "Friction Cones", &render::Display::frictionCones},
};

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

ipc::MenuEntry entry(std::string id, std::string label, std::string icon = "") {
    ipc::MenuEntry e;
    e.id = std::move(id);
    e.label = std::move(label);
    e.icon = std::move(icon);
    return e;
}

ipc::MenuEntry checkable(std::string id, std::string label, bool checked, ipc::Scope scope) {
    ipc::MenuEntry e = entry(std::move(id), std::move(label));
    e.checkable = true;
    e.checked = checked;
    e.scope = scope;
    return e;
}

ipc::MenuEntry window(std::string id, std::string label, std::string shortcut) {
    ipc::MenuEntry e = entry(std::move(id), std::move(label));
    e.shortcut = std::move(shortcut);
    e.mode = ipc::Mode::edit;
    return e;
}

// None of a name that is too long for an id.
std::vector<ipc::MenuEntry> ofSelected(const std::string& name) {
    constexpr std::size_t most = 1000;
    if (name.empty() || name.size() > most)
        return {};
    return {entry(deleteSelected + name, "Delete " + name),
            entry(duplicateSelected + name, "Duplicate " + name), entry("line", "-")};
}

} // namespace

bool MenuState::operator==(const MenuState& other) const {
    bool same = hasMotion == other.hasMotion && playing == other.playing && loops == other.loops &&
                computing == other.computing && rate == other.rate && drafts == other.drafts &&
                selected == other.selected;
    for (const Switch& s : switches)
        same = same && display.*s.value == other.display.*s.value;
    return same;
}

std::vector<ipc::MenuEntry> menuOf(const MenuState& state) {
    std::vector<ipc::MenuEntry> menu = ofSelected(state.selected);
    const auto command = [&](const char* id, const char* label, const char* icon, bool enabled) {
        menu.push_back(entry(id, label, icon));
        menu.back().enabled = enabled;
    };
    command("play", "Play", "media-playback-start", state.hasMotion && !state.playing);
    command("pause", "Pause", "media-playback-pause", state.playing);
    command("stop", "Stop", "media-playback-stop", state.hasMotion);
    command("step", "Step", "media-skip-forward", state.hasMotion);
    for (const double rate : rates) {
        menu.push_back(checkable("rate-" + number(rate), number(rate) + "\u00d7",
                                 state.rate == rate, ipc::Scope::subdocument));
        menu.back().group = "Rate";
    }
    menu.push_back(checkable("loop", "Loop", state.loops, ipc::Scope::subdocument));
    menu.back().icon = "media-playlist-repeat";
    for (const Switch& s : switches) {
        menu.push_back(checkable(s.id, s.label, state.display.*s.value, ipc::Scope::rendition));
        menu.back().group = s.group;
    }
    menu.push_back(entry("reset-view", "Reset View"));
    menu.back().scope = ipc::Scope::rendition;
    menu.push_back(entry("recompute", "Recompute Motion", "view-refresh"));
    menu.push_back(window("open-graphical-viewer", "New Graphical Viewer", "Ctrl+Shift+G"));
    menu.push_back(window("open-language-viewer", "New Language Viewer", "Ctrl+L"));
    menu.push_back(window(updateDrafts, "Update from the Language Viewers", ""));
    menu.back().enabled = state.drafts;
    return menu;
}

std::optional<double> rateOf(const std::string& id) {
    for (const double rate : rates)
        if (id == "rate-" + number(rate))
            return rate;
    return std::nullopt;
}

bool render::Display::*displaySwitch(const std::string& id) {
    for (const Switch& s : switches)
        if (id == s.id)
            return s.value;
    return nullptr;
}

} // namespace service

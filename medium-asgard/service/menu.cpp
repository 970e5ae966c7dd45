#include "service/menu.h"

#include <cstdio>

namespace service {
namespace {

struct Switch {
    const char* id;
    const char* label;
    bool render::Display::*value;
    const char* group;
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
    {"wireframe", "Wireframe", &render::Display::wireframe, "Show"},
    {"axes", "Axes", &render::Display::axes, "Show"},
    {"grid", "Grid", &render::Display::grid, "Show"},
    {"trails", "Trails", &render::Display::trails, "Show"},
    {"joints", "Joints", &render::Display::joints, "Show"},
    {"shadows", "Shadows", &render::Display::shadows, "Show"},
    {"contact-forces", "Contact Forces", &render::Display::contactForces, "Show"},
    {"friction-cones", "Friction Cones", &render::Display::frictionCones, "Show"},
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

ipc::MenuEntry line(const char* id) { return entry(id, "-"); }

// The ways and offers of the moment, and what can be done with the selected thing. None of a name
// that is too long for an id.
std::vector<ipc::MenuEntry> ofTheMoment(const MenuState& state) {
    std::vector<ipc::MenuEntry> menu;
    for (std::size_t i = 0; i < state.ways.size(); ++i)
        menu.push_back(entry(wayPrefix + std::to_string(i), state.ways[i]));
    if (!state.closing.empty())
        menu.push_back(entry(closeJoints, state.closing));
    if (!menu.empty())
        menu.push_back(line("line-offers"));
    constexpr std::size_t most = 1000;
    if (state.selected.empty() || !state.commands)
        return menu;
    for (const ThingCommand& one : *state.commands) {
        if (one.key.size() + state.selected.size() > most)
            continue;
        ipc::MenuEntry& added = menu.emplace_back(entry(idOf(one, state.selected), one.label));
        added.group = one.group;
        added.checkable = one.checked.has_value();
        added.checked = one.checked.value_or(false);
        if (one.inWindows)
            added.mode = ipc::Mode::edit;
    }
    menu.push_back(line("line-selected"));
    return menu;
}

} // namespace

bool MenuState::operator==(const MenuState& other) const {
    bool same = hasMotion == other.hasMotion && playing == other.playing && loops == other.loops &&
                computing == other.computing && rate == other.rate && drafts == other.drafts &&
                selected == other.selected && closing == other.closing && ways == other.ways &&
                (commands == other.commands ||
                 (commands && other.commands && *commands == *other.commands));
    for (const Switch& s : switches)
        same = same && display.*s.value == other.display.*s.value;
    return same;
}

std::string idOf(const ThingCommand& command, const std::string& name) {
    return command.key + " " + name;
}

// What one wants every day stands at hand, the rest in submenus.
std::vector<ipc::MenuEntry> menuOf(const MenuState& state) {
    std::vector<ipc::MenuEntry> menu = ofTheMoment(state);
    const auto command = [&](const char* id, const char* label, const char* icon, bool enabled) {
        menu.push_back(entry(id, label, icon));
        menu.back().enabled = enabled;
    };
    command("play", "Play", "media-playback-start", state.hasMotion && !state.playing);
    command("pause", "Pause", "media-playback-pause", state.playing);
    command("stop", "Stop", "media-playback-stop", state.hasMotion);
    const std::size_t inTime = menu.size();
    command("step", "Step", "media-skip-forward", state.hasMotion);
    menu.push_back(checkable("loop", "Loop", state.loops, ipc::Scope::subdocument));
    menu.back().icon = "media-playlist-repeat";
    for (const double rate : rates)
        menu.push_back(checkable("rate-" + number(rate), number(rate) + "\u00d7",
                                 state.rate == rate, ipc::Scope::subdocument));
    menu.push_back(entry("recompute", "Recompute Motion", "view-refresh"));
    for (std::size_t i = inTime; i < menu.size(); ++i)
        menu[i].group = "Time";
    for (const Switch& s : switches) {
        menu.push_back(checkable(s.id, s.label, state.display.*s.value, ipc::Scope::rendition));
        menu.back().group = s.group;
    }
    menu.push_back(entry("reset-view", "Reset View"));
    menu.back().scope = ipc::Scope::rendition;
    menu.push_back(line("line-windows"));
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

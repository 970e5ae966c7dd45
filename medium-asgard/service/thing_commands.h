// The commands for the selected thing of a picture: those of a graphical viewer's menu for it, by
// the same code (commands/).
#pragma once

#include "commands/asked_value.h"
#include "ipc/messages.h"

#include <optional>
#include <string>
#include <vector>

namespace service {

struct ThingCommand {
    std::string key; // the thing's name follows in a menu's id
    std::string label, group = {};
    std::optional<bool> checked = {}; // none: it is no switch
    bool inWindows = false;           // it opens one
    bool operator==(const ThingCommand&) const = default;
};

inline const std::string deleteThing = "delete", duplicateThing = "duplicate", fixThing = "fixed",
                         openThing = "open-in-editor";

// `name`: body "b1", as the entries call it.
[[nodiscard]] std::vector<ThingCommand> commandsOf(const std::shared_ptr<const scene::Scene>& scene,
                                                   const simulation::MotionPointer& motion,
                                                   const editing::Element& element,
                                                   const std::string& name);

// The thing that is called so; none: there is none.
[[nodiscard]] std::optional<editing::Element> thingCalled(const scene::Scene& scene,
                                                          const std::string& name);

// The numbers that a command asks for; none: it asks for none.
[[nodiscard]] std::optional<commands::AskedValue> askedBy(const ThingCommand& command,
                                                          const gestures::Ground& ground,
                                                          const editing::Element& element);

// The plot that a command writes, where it writes one.
struct NewPlot {
    text::Edits edits;
    std::string name;
};
[[nodiscard]] std::optional<NewPlot> plotBy(const ThingCommand& command,
                                            const gestures::Ground& ground,
                                            const editing::Element& element);

// The change of a command that shows a value beside the thing, or does not show it any more.
struct Changed {
    editing::Answer answer;
    std::string label; // of the step of undo
};
[[nodiscard]] std::optional<Changed> besideBy(const ThingCommand& command,
                                              const gestures::Ground& ground,
                                              const editing::Element& element);

// With the values that were typed; "": as they are.
[[nodiscard]] ipc::Question questionOf(const commands::AskedValue& asked,
                                       const std::vector<std::string>& typed);

// The lines of the text that the edits would change; LIMIT: the first 20.
[[nodiscard]] std::vector<ipc::ChangedLine> changesOf(const std::string& text,
                                                      const text::Edits& edits);

} // namespace service

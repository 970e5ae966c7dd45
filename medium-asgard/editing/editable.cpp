#include "editing/editable.h"

#include "editing/changes.h"

#include <algorithm>
#include <array>

namespace editing {

namespace {

struct Option {
    Kind kind;
    const char* name;
    std::size_t values; // 0: a list of points, of which each can be moved
};

constexpr std::array options = {
    Option{Kind::body, "-init_pos", 3},
    Option{Kind::body, "-init_rot", 3},
    Option{Kind::body, "-init_dpos", 3},
    Option{Kind::body, "-init_drot", 3},
    Option{Kind::force, "-offset", 3},
    Option{Kind::force, "-x", 1},
    Option{Kind::force, "-y", 1},
    Option{Kind::force, "-z", 1},
    Option{Kind::force, "-gravitational", 3},
    Option{Kind::link, "-offset1", 3},
    Option{Kind::link, "-offset2", 3},
    Option{Kind::link, "-x", 1},
    Option{Kind::link, "-y", 1},
    Option{Kind::link, "-z", 1},
    Option{Kind::joint, "-offset1", 3},
    Option{Kind::joint, "-offset2", 3},
    Option{Kind::joint, "-axis", 3},
    Option{Kind::light, "-direction", 3},
    Option{Kind::light, "-pos", 3},
    Option{Kind::trajectory, "-points", 0},
    Option{Kind::trajectory, "-bezier", 0},
};

const Option* graphical(Kind kind, const std::string& name) {
    for (const Option& option : options)
        if (option.kind == kind && option.name == name)
            return &option;
    return nullptr;
}

// Numbers that nobody has written, so that a wish for them names every literal that it needs.
std::vector<double> others(std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(1.2345678912345e77 * static_cast<double>(i + 1));
    return values;
}

} // namespace

std::vector<Editable> editablesOf(const std::string& text,
                                  const std::shared_ptr<const scene::Scene>& scene) {
    // Masses and parameters do not change: the literal beside one is the author's to change, by
    // whatever it is multiplied.
    const Mapper mapper(text, scene, [&](const std::string& name) {
        const bool constant = name.ends_with(".mass") ||
                              std::ranges::any_of(scene->parameters, [&](const auto& parameter) {
                                  return parameter.name == name;
                              });
        return constant ? std::optional(1.0) : std::nullopt;
    });
    std::vector<Editable> found;
    for (const Element& element : elementsOf(*scene)) {
        const scene::Source* source = sourceOf(*scene, element);
        if (!source || source->runs != 1)
            continue;
        for (const scene::Argument& argument : source->arguments) {
            const Option* option = graphical(element.kind, argument.option);
            if (!option)
                continue;
            if (argument.literal && option->values != 1) {
                found.push_back({element, argument.option, argument.word});
                continue;
            }
            if (option->values == 0)
                continue;
            const Answer answer = mapper.answer({.element = element,
                                                 .option = argument.option,
                                                 .path = {},
                                                 .values = others(option->values)});
            for (const text::Edit& edit : answer.edits)
                found.push_back({element, argument.option, {edit.range.from, edit.range.to}});
        }
    }
    return found;
}

} // namespace editing

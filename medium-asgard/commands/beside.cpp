#include "commands/beside.h"

#include "element_edits/deletion.h"
#include "element_edits/property_edit.h"

#include <algorithm>

namespace commands {

namespace {

std::string plainLabel(const Quantity& quantity) {
    std::string label = quantity.label;
    std::erase(label, '&');
    return label;
}

bool has(const scene::Plot& plot, const Quantity& quantity) {
    return std::ranges::find(plot.values, quantity.expression) != plot.values.end();
}

editing::Answer withOption(const std::string& text,
                           const std::shared_ptr<const scene::Scene>& scene,
                           const std::vector<editing::Element>& plots, const std::string& value) {
    for (const editing::OptionHint* option : editing::optionsOf(*scene, plots.front()))
        if (option->name == "-beside")
            return editing::Properties(text, scene).set(plots, *option, {value});
    return {};
}

editing::Answer without(const std::string& text, const std::shared_ptr<const scene::Scene>& scene,
                        const Quantity& quantity) {
    const std::vector<std::string> label = {plainLabel(quantity)};
    for (std::size_t i = 0; i < scene->plots.size(); ++i) {
        const scene::Plot& plot = scene->plots[i];
        if (!plot.beside || !has(plot, quantity))
            continue;
        const std::vector<editing::Element> one = {{editing::Kind::plot, i}};
        if (plot.values.size() > 1 || plot.labels != label || !plot.title.empty())
            return withOption(text, scene, one, "");
        editing::Deletion deletion = editing::deletionOf(text, *scene, one);
        editing::Answer answer;
        answer.edits = std::move(deletion.edits);
        answer.reason = std::move(deletion.reason);
        answer.cause = deletion.cause;
        return answer;
    }
    return {};
}

} // namespace

bool isBeside(const scene::Scene& scene, const Quantity& quantity) {
    return std::ranges::any_of(
        scene.plots, [&](const scene::Plot& plot) { return plot.beside && has(plot, quantity); });
}

editing::Answer withBeside(const std::string& text,
                           const std::shared_ptr<const scene::Scene>& scene,
                           const Quantity& quantity) {
    if (isBeside(*scene, quantity))
        return without(text, scene, quantity);
    for (std::size_t i = 0; i < scene->plots.size(); ++i)
        if (scene->plots[i].values == std::vector{quantity.expression})
            return withOption(text, scene, {{editing::Kind::plot, i}}, "1");
    editing::NewElement plot = plotOf(text, *scene, quantity.expression, plainLabel(quantity));
    plot.words.insert(plot.words.end(), {"-beside", "1"});
    editing::Answer answer;
    answer.edits = editing::created(text, *scene, {plot});
    return answer;
}

std::string labelOfBeside(const scene::Scene& scene, const Quantity& quantity) {
    return (isBeside(scene, quantity) ? "Do Not Show " : "Show ") + plainLabel(quantity) +
           " Beside It";
}

} // namespace commands

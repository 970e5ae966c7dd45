#include "framing/standing_points.h"

#include "expression/parse.h"

#include <cmath>
#include <span>
#include <string_view>
#include <variant>

namespace render {

std::optional<double> constantValue(const scene::Scene& scene, const simulation::Motion* motion,
                                    const std::string& text) {
    return constantValue(scene::Names(scene), scene, motion, text);
}

std::optional<double> constantValue(const scene::Names& names, const scene::Scene& scene,
                                    const simulation::Motion* motion, const std::string& text) {
    const auto meaning = [&](expression::Graph& graph, std::string_view name,
                             std::span<const expression::Node> arguments,
                             bool isCall) -> expression::Meaning {
        const auto what = names.find(name, isCall ? std::optional(arguments.size()) : std::nullopt,
                                     scene::Reading::state);
        if (const auto* parameter = std::get_if<scene::ParameterName>(&what))
            return {graph.constant(scene.parameters[parameter->parameter].value), "", ""};
        if (const auto* body = std::get_if<scene::BodyName>(&what);
            body && body->quantity == scene::BodyQuantity::mass) {
            const auto& given = scene.bodies[body->body].mass;
            if (given || (motion && body->body < motion->bodies()))
                return {graph.constant(given ? *given : motion->mass(body->body)), "", ""};
        }
        return {std::nullopt, "it changes", ""};
    };
    expression::Graph graph;
    const auto parsed = expression::parse(graph, text, meaning);
    const auto* node = std::get_if<expression::Node>(&parsed);
    if (!node || graph.op(*node) != expression::Op::constant || !std::isfinite(graph.value(*node)))
        return std::nullopt;
    return graph.value(*node);
}

std::optional<Vector> standingPoint(const scene::Scene& scene, const simulation::Motion* motion,
                                    const scene::PointEnd& end) {
    const scene::Names names(scene);
    Vector place;
    for (int i = 0; i < 3; ++i) {
        const auto value =
            constantValue(names, scene, motion, end.coordinates[static_cast<std::size_t>(i)]);
        if (!value)
            return std::nullopt;
        place[i] = *value;
    }
    return place;
}

std::vector<Vector> anchorsOf(const scene::Scene& scene, const simulation::Motion* motion) {
    std::vector<Vector> anchors;
    for (const scene::Link& link : scene.links)
        if (const auto* point = std::get_if<scene::PointEnd>(&link.second); point && link.spring)
            if (const auto place = standingPoint(scene, motion, *point))
                anchors.push_back(*place);
    return anchors;
}

} // namespace render

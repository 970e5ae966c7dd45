// rope.
#include "script/scene_maker.h"

#include "script/numbers.h"

#include <algorithm>

namespace script {

using scene::Rope;

namespace {
constexpr std::string_view pointsWish =
    "a list of points, each {BODY {offset}}, {BODY {offset} RADIUS ?AXIS?} or {x y z}";
}

void SceneMaker::rope(Call& call) {
    Rope rope;
    rope.name = newName(call, Kind::rope);
    if (rope.name.empty())
        return;
    Arguments arguments(faults_, call, "rope " + quoted(rope.name), 2,
                        {"-points", "-length", "-restitution", "-closed", "-release"});
    if (!arguments.attempted("-points"))
        arguments.wrongElement("wants -points with the points that it goes through",
                               "write -points {{A {0 0 0}} {0 1 0}}");
    rope.points = ropePoints(arguments);
    rope.length = arguments.number("-length", Sign::positive);
    rope.restitution = arguments.number("-restitution", Sign::unit).value_or(0);
    rope.isClosed = arguments.flag("-closed").value_or(false);
    rope.release = expressionOf(arguments, "-release", scene::Reading::release);
    rope.source = call.source;
    const auto moves = [&](const Rope::Point& point) {
        const scene::Body* body = point.body ? scene::findBody(made_.scene, *point.body) : nullptr;
        return body != nullptr && !body->fixed;
    };
    if (!rope.points.empty() && std::ranges::none_of(rope.points, moves))
        arguments.wrongElement("has no point on a body that moves");
    made_.scene.ropes.push_back(std::move(rope));
}

// Empty: some of them are wrong.
std::vector<Rope::Point> SceneMaker::ropePoints(Arguments& arguments) {
    std::vector<Rope::Point> points;
    const Value* value = arguments.wanted("-points", pointsWish);
    const auto words = value ? arguments.listIn("-points", *value, pointsWish) : std::nullopt;
    if (!words)
        return {};
    if (words->size() < 2) {
        arguments.wrong("-points", value->range, "at least two points",
                        "and gets " + std::to_string(words->size()));
        return {};
    }
    for (const Value& word : *words) {
        const auto point = ropePoint(arguments, word);
        if (!point)
            return {};
        points.push_back(*point);
    }
    return points;
}

std::optional<Rope::Point> SceneMaker::ropePoint(Arguments& arguments, const Value& value) {
    const auto parts = arguments.listIn("-points", value, pointsWish);
    if (!parts)
        return std::nullopt;
    Rope::Point point;
    if (parts->empty() || parts->size() > 4) {
        arguments.wrong("-points", value.range, pointsWish, "not " + quoted(value.text));
        return std::nullopt;
    }
    const std::string& first = (*parts)[0].text;
    if (decimalNumber(first)) {
        point.place = arguments.vectorIn("-points", value, pointsWish);
        return point.place ? std::optional(point) : std::nullopt;
    }
    if (!exists(Kind::body, first)) {
        faults_.error((*parts)[0].range, arguments.subject() + ": no body named " + quoted(first),
                      suggest(Kind::body, first));
        return std::nullopt;
    }
    point.body = first;
    if (parts->size() > 1) {
        point.place = arguments.vectorIn("-points", (*parts)[1], pointsWish);
        if (!point.place)
            return std::nullopt;
    }
    if (parts->size() > 2 && !ropeWheel(arguments, *parts, point))
        return std::nullopt;
    return point;
}

// {BODY {offset} RADIUS ?AXIS?}
bool SceneMaker::ropeWheel(Arguments& arguments, const std::vector<Value>& parts,
                           Rope::Point& point) {
    constexpr std::string_view wants = "a radius of a wheel that is not 0";
    const auto radius = arguments.numberIn("-points", parts[2], Sign::any, wants);
    if (!radius)
        return false;
    if (*radius == 0) {
        arguments.wrong("-points", parts[2].range, wants, "not 0",
                        "without a radius the rope slides through the point");
        return false;
    }
    point.radius = *radius;
    if (parts.size() < 4)
        return true;
    const auto axis = arguments.vectorIn("-points", parts[3], "an axis of three numbers");
    if (axis && axis->isZero(0))
        arguments.wrong("-points", parts[3].range, "a direction as axis of a wheel",
                        "and all its numbers are 0");
    if (!axis || axis->isZero(0))
        return false;
    point.axis = *axis;
    return true;
}

} // namespace script

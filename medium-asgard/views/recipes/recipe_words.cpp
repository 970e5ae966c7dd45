#include "recipes/recipe_words.h"

#include "editing/number_text.h"
#include "script/svg_colors.h"

#include <algorithm>
#include <array>

namespace views {

using editing::Kind;
using editing::NewElement;

std::string listed(const Vector& v, double resolution) {
    std::string text = "{";
    for (int i = 0; i < 3; ++i)
        text += (i == 0 ? "" : " ") + editing::numberText(v[i], editing::decimalStep(resolution));
    return text + "}";
}

Vector alongAxis(const Vector& v) {
    constexpr double steady = 0.1; // radians
    Eigen::Index axis = 0;
    v.cwiseAbs().maxCoeff(&axis);
    const Vector along = v[axis] * Vector::Unit(axis);
    return (v - along).norm() <= steady * along.norm() ? along : v;
}

Step showBody(const QString& prompt) { return {Wanted::body, prompt, ""}; }

Step showPlace(const QString& prompt, const QString& otherwise) {
    Step step{Wanted::point, prompt, otherwise};
    step.snaps = true;
    return step;
}

Step showWholeBody(const QString& prompt) {
    Step step = showBody(prompt);
    step.whole = true;
    return step;
}

std::vector<std::string> placeWords(const Vector& place, const geometry::Quaternion& attitude,
                                    double resolution) {
    std::vector<std::string> words{"-init_pos", listed(place, resolution)};
    constexpr double least = 1e-9;
    if (const Vector turn = geometry::toRotationVector(attitude); turn.norm() > least)
        words.insert(words.end(), {"-init_rot", listed(turn, least)});
    return words;
}

namespace {

// The one of these that the fewest bodies have, the first of several.
const char* rarestColor(const scene::Scene& scene) {
    static constexpr std::array<const char*, 6> colors{"steelblue", "indianred",    "goldenrod",
                                                       "seagreen",  "mediumpurple", "peru"};
    return *std::ranges::min_element(colors, {}, [&](const char* name) {
        return std::ranges::count(scene.bodies, script::namedColor(name),
                                  [](const scene::Body& body) { return body.appearance.color; });
    });
}

} // namespace

void addRoomWords(NewElement& body, const scene::Scene& scene, bool isBall, bool isColored) {
    body.words.insert(body.words.end(), {"-restitution", isBall ? "0.7" : "0", "-friction", "0.3"});
    if (!isColored)
        body.words.insert(body.words.end(), {"-color", rarestColor(scene)});
}

void addOffset(NewElement& element, const char* option, const Indicated& shown) {
    if (shown.atCenter)
        return;
    element.words.insert(element.words.end(), {option, listed(shown.onBody, shown.resolution)});
}

std::string bodyName(const scene::Scene& scene, const Indicated& shown) {
    return scene.bodies[*shown.body].name;
}

Path pathFrom(const std::string& text, const scene::Scene& scene, const Indicated& shown,
              const Vector& place, const Vector& way, double resolution) {
    if (shown.trajectory) {
        const std::size_t index = *shown.trajectory;
        return {scene.trajectories[index].name, {{Kind::trajectory, index}}, {}};
    }
    Path path;
    path.name = editing::unusedName(text, scene, Kind::trajectory, "path");
    const double finish = scene.simulator.finish, start = scene.simulator.start;
    const auto point = [&](double time, const Vector& at) {
        const std::string places = listed(at, resolution);
        return "{" + editing::numberText(time, 0) + " " + places.substr(1);
    };
    path.made.push_back(
        {Kind::trajectory,
         path.name,
         {"-points", "{" + point(start, place) + " " + point(finish, place + way) + "}"},
         {}});
    return path;
}

} // namespace views

// Create > Light, Trajectory, Parameter, Plot, View, and measuring.
#include "recipes/recipes.h"

#include "commands/quantities.h"
#include "editing/number_text.h"
#include "framing/extent.h"
#include "recipes/recipe_words.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace views {

using editing::Element;
using editing::Kind;
using editing::NewElement;

Recipe measure() {
    Recipe recipe;
    recipe.label = QObject::tr("Measure");
    const auto point = [](const QString& prompt) {
        Step step = showPlace(prompt, {});
        step.surface = true;
        return step;
    };
    recipe.steps = {point(QObject::tr("Click on the first point.")),
                    point(QObject::tr("Click on the second point."))};
    recipe.make = [](const std::string&, const scene::Scene&, const std::vector<Indicated>&) {
        return std::vector<NewElement>();
    };
    recipe.tells = [](const std::vector<Indicated>& shown) {
        const Vector way = shown[1].point - shown[0].point;
        const double fine = std::max(shown[0].resolution, shown[1].resolution);
        const std::string apart = listed(way, fine);
        return QObject::tr("The distance is %1 m; along x, y and z %2 m.")
            .arg(
                QString::fromStdString(editing::numberText(way.norm(), editing::decimalStep(fine))),
                QString::fromStdString(apart.substr(1, apart.size() - 2)));
    };
    return recipe;
}

// On the middle of the scene, and into the picture: it lights the sides that one sees.
static Vector firstDirection(const scene::Scene& scene, const Indicated& place) {
    const Vector way = render::extentOf(scene, nullptr).box.center() - place.point;
    const Vector onto = way.norm() > 1e-9 ? Vector(way.normalized()) : Vector(0, -1, 0);
    return (0.8 * onto - place.sight).normalized();
}

Recipe newLight(bool point) {
    return {QObject::tr("New Light"),
            {showPlace((point ? QObject::tr("Click where the light shall stand.")
                              : QObject::tr("Click where the light comes from.")) +
                           " " + QObject::tr("A scene's own lights replace the usual one."),
                       "")},
            [point](const std::string& text, const scene::Scene& scene,
                    const std::vector<Indicated>& shown) {
                NewElement light{Kind::light,
                                 editing::unusedName(text, scene, Kind::light, "light"),
                                 {"-pos", listed(shown[0].point, shown[0].resolution)},
                                 {}};
                if (!point)
                    light.words.insert(
                        light.words.end(),
                        {"-direction", listed(firstDirection(scene, shown[0]), 0.1)});
                return std::vector{light};
            },
            &render::Display::lightHandles};
}

namespace {

Step pathPoint() {
    Step step = showPlace(QObject::tr("Click on its points, one after another, or type x y z."),
                          QObject::tr("Return ends it."));
    step.repeats = true;
    return step;
}

} // namespace

Recipe newTrajectory() {
    return {QObject::tr("New Trajectory"),
            {pathPoint()},
            [](const std::string& text, const scene::Scene& scene,
               const std::vector<Indicated>& shown) -> std::vector<NewElement> {
                std::vector<Indicated> points;
                std::ranges::copy_if(shown, std::back_inserter(points), &Indicated::given);
                if (points.size() < 2)
                    return {};
                // Over the whole motion, evenly.
                const double start = scene.simulator.start;
                const double length = scene.simulator.finish - start;
                std::string list;
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const double share =
                        static_cast<double>(i) / static_cast<double>(points.size() - 1);
                    list += (i == 0 ? "{{" : " {") +
                            editing::numberText(start + share * length, 1e-3 * length) + " " +
                            listed(points[i].point, points[i].resolution).substr(1);
                }
                return {NewElement{Kind::trajectory,
                                   editing::unusedName(text, scene, Kind::trajectory, "path"),
                                   {"-points", list + "}"},
                                   {}}};
            },
            &render::Display::trajectories};
}

Recipe attachTrajectory() {
    return {QObject::tr("Attach Trajectory"),
            {showBody(QObject::tr("Click on the body that is to be led.")),
             {Wanted::trajectory, QObject::tr("Click on the trajectory that leads it."),
              QObject::tr("Return makes a new one.")}},
            [](const std::string& text, const scene::Scene& scene,
               const std::vector<Indicated>& shown) {
                const scene::Body& led = scene.bodies[*shown[0].body];
                Path path = pathFrom(text, scene, shown[1], led.initialPosition, Vector(1, 0, 0),
                                     shown[0].resolution);
                NewElement held{
                    Kind::constraint, "", {led.name, "-pos", path.name}, std::move(path.behind)};
                held.behind.push_back({Kind::body, *shown[0].body});
                path.made.push_back(held);
                return path.made;
            },
            &render::Display::trajectories};
}

Recipe newParameter(const std::string& name, const std::string& value, const std::string& minimum,
                    const std::string& maximum) {
    return {
        QObject::tr("New Parameter"),
        {},
        [=](const std::string&, const scene::Scene&, const std::vector<Indicated>&) {
            return std::vector{NewElement{
                Kind::parameter, name, {"-value", value, "-min", minimum, "-max", maximum}, {}}};
        }};
}

Recipe newPlot(const std::string& expression, const std::string& curve) {
    return {QObject::tr("New Plot"),
            {},
            [=](const std::string& text, const scene::Scene& scene, const std::vector<Indicated>&) {
                return std::vector{commands::plotOf(text, scene, expression, curve)};
            }};
}

Recipe keptView(const render::Camera& camera, double resolution) {
    return {QObject::tr("Keep This View"),
            {},
            [=](const std::string& text, const scene::Scene& scene, const std::vector<Indicated>&) {
                return std::vector{
                    NewElement{Kind::view,
                               editing::unusedName(text, scene, Kind::view, "view"),
                               {"-pos", listed(camera.position, 1e-3), "-rot",
                                listed(geometry::toRotationVector(camera.rotation), 1e-4), "-scale",
                                editing::numberText(camera.scale, 1e-4 * camera.scale), "-center",
                                listed(camera.center, resolution)},
                               {}}};
            }};
}

} // namespace views

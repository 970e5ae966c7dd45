// Create > Force > Attraction of Two Bodies, of All Bodies, Orbit Round a Body.
//
// An orbit is a circle at the start: of two bodies at the distance d that attract each other, one
// goes round the other at the speed  v = sqrt(G (M + m) / d), across d; M alone where the other is
// fixed. Both share it by their masses: the middle of their mass goes on as the sun did, or, where
// the planet moved already, as that middle did. It goes round upright things, as on the grid; in a
// picture that looks along an axis, in the picture.
#include "editing/number_text.h"
#include "framing/extent.h"
#include "physics/mass.h"
#include "recipes/recipe_words.h"
#include "recipes/recipes.h"

#include <QObject>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace views {

using editing::Kind;
using editing::NewElement;

namespace {

std::string xOf(const scene::Force& force) {
    const auto* parts = std::get_if<scene::ComponentForce>(&force.kind);
    return parts ? parts->components[0] : std::string();
}

// The parameter that attractions have already: what another one called G is for, nobody knows.
std::optional<std::string> constantOf(const scene::Scene& scene) {
    for (const scene::Parameter& one : scene.parameters)
        for (const scene::Force& force : scene.forces)
            if (xOf(force).starts_with(one.name + " * " + force.body + ".mass * "))
                return one.name;
    return std::nullopt;
}

// Newton's law of gravitation: the force on one body by another.
NewElement attractionOn(const scene::Scene& scene, const std::string& constant, std::size_t one,
                        std::size_t other) {
    const std::string a = scene.bodies[one].name, b = scene.bodies[other].name;
    const auto along = [&](const char* axis) { return b + "." + axis + " - " + a + "." + axis; };
    const std::string distance =
        "hypot(" + along("x") + ", " + along("y") + ", " + along("z") + ")^3";
    NewElement force{Kind::force, "", {"-body", a}, {{Kind::body, one}, {Kind::body, other}}};
    for (const auto& [option, axis] : {std::pair("-x", "x"), {"-y", "y"}, {"-z", "z"}})
        force.words.insert(force.words.end(),
                           {option, "{" + constant + " * " + a + ".mass * " + b + ".mass * (" +
                                        along(axis) + ") / " + distance + "}"});
    return force;
}

// Of each pair on each that can move, but for what is there already.
class Attractions {
public:
    Attractions(const std::string& text, const scene::Scene& scene)
        : scene_(scene), known_(constantOf(scene)),
          constant_(known_.value_or(nameOf(text, scene))) {}

    void add(std::size_t one, std::size_t other) {
        for (const auto& [a, b] : {std::pair(one, other), std::pair(other, one)})
            if (!scene_.bodies[a].fixed && !isThere(a, b))
                made_.push_back(attractionOn(scene_, constant_, a, b));
    }
    [[nodiscard]] std::vector<NewElement> withConstant() {
        if (!made_.empty() && !known_)
            made_.insert(
                made_.begin(),
                {Kind::parameter, constant_, {"-value", "1", "-min", "0", "-max", "10"}, {}});
        return std::move(made_);
    }

private:
    static std::string nameOf(const std::string& text, const scene::Scene& scene) {
        const std::string usual = "G";
        return std::ranges::find(scene.parameters, usual, &scene::Parameter::name) ==
                       scene.parameters.end()
                   ? usual
                   : editing::unusedName(text, scene, Kind::parameter, usual);
    }
    [[nodiscard]] bool isThere(std::size_t one, std::size_t other) const {
        const std::string &a = scene_.bodies[one].name, b = scene_.bodies[other].name;
        return known_ && std::ranges::any_of(scene_.forces, [&](const scene::Force& force) {
                   return force.body == a &&
                          xOf(force).starts_with(constant_ + " * " + a + ".mass * " + b + ".mass ");
               });
    }

    const scene::Scene& scene_;
    std::optional<std::string> known_;
    std::string constant_;
    std::vector<NewElement> made_;
};

bool hasMass(const scene::Scene& scene, const scene::Body& body) {
    const auto set = std::ranges::find(scene.shapeSets, body.shape, &scene::ShapeSet::name);
    return set != scene.shapeSets.end() &&
           std::ranges::none_of(set->parts, [](const scene::Part& part) {
               return std::holds_alternative<scene::PlaneShape>(part.shape);
           });
}

struct Orbit {
    Vector sun = Vector::Zero(), planet = Vector::Zero(); // their velocities
    double speed = 0, period = 0;
};

// The axis that it goes round.
Vector axisOf(const scene::Scene& scene, const Vector& sight, const Vector& way) {
    constexpr double along = 0.95, nearly = 0.9;
    Eigen::Index facing = 0;
    sight.cwiseAbs().maxCoeff(&facing);
    const Vector inPicture = Vector::Unit(facing), up = render::upOf(scene);
    const bool isInPicture = std::abs(sight[facing]) > along;
    for (const Vector& axis : {isInPicture ? inPicture : up, isInPicture ? up : inPicture})
        if (std::abs(axis.dot(way)) < nearly)
            return axis;
    return Vector::UnitX();
}

// The sentence says why there is none.
std::variant<Orbit, QString> orbitOf(const scene::Scene& scene, const Indicated& middle,
                                     const Indicated& round) {
    const scene::Body &sun = scene.bodies[*middle.body], &planet = scene.bodies[*round.body];
    const auto say = [](const QString& words, const scene::Body& body) {
        return words.arg(QString::fromStdString(body.name));
    };
    if (&sun == &planet)
        return say(QObject::tr("%1 cannot go round itself."), planet);
    if (planet.fixed)
        return say(QObject::tr("%1 is fixed."), planet);
    scene::ShapeReader shapes;
    physics::MassReader masses(scene, shapes);
    const auto massOf = [&](const scene::Body& body) {
        const auto mass = masses.massOf(body);
        const auto* known = std::get_if<physics::BodyMass>(&mass);
        return known ? *known : physics::BodyMass();
    };
    const physics::BodyMass heavy = massOf(sun), light = massOf(planet);
    const auto place = [](const scene::Body& body, const physics::BodyMass& mass) {
        return Vector(body.initialPosition + body.initialAttitude * mass.centroid);
    };
    const Vector way = place(planet, light) - place(sun, heavy);
    const double distance = way.norm();
    if (!(heavy.mass > 0))
        return say(QObject::tr("%1 has no mass."), sun);
    if (!(distance > 0))
        return say(QObject::tr("%1 stands in the middle."), planet);
    const auto known = constantOf(scene);
    const auto constant =
        std::ranges::find(scene.parameters, known.value_or(std::string()), &scene::Parameter::name);
    const double strength = constant == scene.parameters.end() ? 1 : constant->value;
    const double both = heavy.mass + (sun.fixed ? 0 : light.mass);
    Orbit orbit;
    orbit.speed = std::sqrt(std::max(strength, 0.0) * both / distance);
    orbit.period = 2 * std::numbers::pi * distance / orbit.speed;
    const Vector relative =
        orbit.speed * axisOf(scene, middle.sight, way / distance).cross(way).normalized();
    const double share = sun.fixed ? 0 : light.mass / both;
    const Vector common =
        planet.initialVelocity.isZero(0)
            ? sun.initialVelocity
            : Vector((1 - share) * sun.initialVelocity + share * planet.initialVelocity);
    orbit.sun = common - share * relative;
    orbit.planet = common + (1 - share) * relative;
    return orbit;
}

// In three digits.
QString figure(double value) { return QString::number(value, 'g', 3); }

Judged judgeOrbit(const scene::Scene& scene, const std::vector<Indicated>& shown,
                  const Indicated& next) {
    const QString name = QString::fromStdString(scene.bodies[*next.body].name);
    if (shown.empty())
        return {name, true};
    const auto found = orbitOf(scene, shown.front(), next);
    if (const auto* why = std::get_if<QString>(&found))
        return {*why, false};
    const Orbit& orbit = std::get<Orbit>(found);
    return {QObject::tr("%1: at %2 m/s once round in %3 s")
                .arg(name, figure(orbit.speed), figure(orbit.period)),
            true};
}

} // namespace

Recipe newAttraction() {
    Recipe recipe;
    recipe.label = QObject::tr("New Attraction");
    recipe.steps = {showWholeBody(QObject::tr("Click on a body: a sun.")),
                    showWholeBody(QObject::tr("Click on the body that it attracts: a planet."))};
    recipe.make = [](const std::string& text, const scene::Scene& scene,
                     const std::vector<Indicated>& shown) {
        Attractions made(text, scene);
        if (shown[0].body != shown[1].body)
            made.add(*shown[0].body, *shown[1].body);
        return made.withConstant();
    };
    recipe.otherwise = QObject::tr("Two different bodies, please, one of which can move, and which "
                                   "do not attract each other yet.");
    return recipe;
}

Recipe attractionOfAll() {
    Recipe recipe;
    recipe.label = QObject::tr("Attraction of All Bodies");
    recipe.keepsSelection = true;
    recipe.make = [](const std::string& text, const scene::Scene& scene,
                     const std::vector<Indicated>&) {
        Attractions made(text, scene);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            for (std::size_t k = i + 1; k < scene.bodies.size(); ++k)
                if (hasMass(scene, scene.bodies[i]) && hasMass(scene, scene.bodies[k]))
                    made.add(i, k);
        return made.withConstant();
    };
    recipe.otherwise = QObject::tr("There are no two bodies one of which can move and that do not "
                                   "attract each other yet.");
    return recipe;
}

Recipe newOrbit() {
    Recipe recipe;
    recipe.label = QObject::tr("New Orbit");
    recipe.steps = {showWholeBody(QObject::tr("Click on the body in the middle: a sun.")),
                    showWholeBody(QObject::tr("Click on the body that goes round it: a planet."))};
    for (Step& step : recipe.steps)
        step.judge = judgeOrbit;
    recipe.make = [](const std::string& text, const scene::Scene& scene,
                     const std::vector<Indicated>& shown) {
        Attractions made(text, scene);
        made.add(*shown[0].body, *shown[1].body);
        return made.withConstant();
    };
    recipe.moves = [](const scene::Scene& scene, const std::vector<Indicated>& shown) {
        std::vector<editing::Wish> wishes;
        const auto found = orbitOf(scene, shown[0], shown[1]);
        const auto* orbit = std::get_if<Orbit>(&found);
        if (!orbit)
            return wishes;
        const auto numbers = [](const Vector& v) { return std::vector{v.x(), v.y(), v.z()}; };
        const auto give = [&](std::size_t body, const Vector& velocity) {
            wishes.push_back({{Kind::body, body},
                              "-init_dpos",
                              {},
                              numbers(velocity),
                              1e-6 * orbit->speed,
                              {0, 0, 0},
                              numbers(scene.bodies[body].initialVelocity)});
        };
        give(*shown[1].body, orbit->planet);
        if (!scene.bodies[*shown[0].body].fixed)
            give(*shown[0].body, orbit->sun);
        return wishes;
    };
    recipe.otherwise = QObject::tr("It goes round like that already.");
    return recipe;
}

} // namespace views

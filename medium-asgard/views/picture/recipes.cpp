#include "picture/recipes.h"

#include "editing/number_text.h"
#include "framing/extent.h"
#include "picture/recipe_words.h"
#include "point_edits/shape_edit.h"

#include <QObject>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace views {

using editing::Element;
using editing::Kind;
using editing::NewElement;

namespace {

Step body(const QString& prompt) { return {Wanted::body, prompt, ""}; }

Step place(const QString& prompt, const QString& otherwise) {
    Step step{Wanted::point, prompt, otherwise};
    step.snaps = true;
    return step;
}

Step wholeBody(const QString& prompt) {
    Step step = body(prompt);
    step.whole = true;
    return step;
}

// Where on its body something acts; nothing at its centre of mass, which is what is meant then.
void addOffset(NewElement& element, const char* option, const Indicated& shown) {
    if (shown.atCenter)
        return;
    element.words.insert(element.words.end(), {option, listed(shown.onBody, shown.resolution)});
}

std::string bodyName(const scene::Scene& scene, const Indicated& shown) {
    return scene.bodies[*shown.body].name;
}

void addComponents(NewElement& element, const Vector& v, double resolution) {
    constexpr const char* options[] = {"-x", "-y", "-z"};
    for (int i = 0; i < 3; ++i)
        element.words.insert(
            element.words.end(),
            {options[i], editing::numberText(v[i], editing::decimalStep(resolution))});
}

double tightnessOf(const scene::Scene& scene) {
    const auto last = std::find_if(scene.links.rbegin(), scene.links.rend(),
                                   [](const scene::Link& link) { return !link.spring; });
    return last == scene.links.rend() ? 100 : last->tightness;
}

std::vector<std::string> placeWords(const Indicated& shown) {
    std::vector<std::string> words{"-init_pos", listed(shown.point, shown.resolution)};
    constexpr double least = 1e-9;
    if (const Vector turn = geometry::toRotationVector(shown.attitude); turn.norm() > least)
        words.insert(words.end(), {"-init_rot", listed(turn, least)});
    return words;
}

// A trajectory that was shown, or a new one that begins at that place.
struct Path {
    std::string name;
    std::vector<Element> behind;
    std::vector<NewElement> made;
};

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

} // namespace

Recipe newBody(const std::string& shape, std::vector<scene::Part> ghost) {
    Step where = place(QObject::tr("Click where the new body shall be, on a body that it rests on, "
                                   "or type x y z."),
                       QObject::tr("Return puts it at the origin."));
    where.rests = true;
    return {QObject::tr("New Body"),
            {where},
            [shape](const std::string& text, const scene::Scene& scene,
                    const std::vector<Indicated>& shown) {
                NewElement body{Kind::body,
                                editing::unusedName(text, scene, Kind::body, shape),
                                placeWords(shown[0]),
                                {},
                                shape};
                for (std::size_t i = 0; i < scene.shapeSets.size(); ++i)
                    if (scene.shapeSets[i].name == shape)
                        body.behind.push_back({Kind::shapeSet, i});
                return std::vector{body};
            },
            &render::Display::positionHandles,
            {},
            std::move(ghost)};
}

namespace {

// Things of a room, not the language's ideal ones: balls bounce, all else comes to rest where it
// falls, and wheels roll.
Recipe newBody(const std::string& stem, const std::string& description, bool isFixed = false) {
    Recipe recipe = views::newBody(std::string());
    recipe.make = [stem, description, isFixed](const std::string& text, const scene::Scene& scene,
                                               const std::vector<Indicated>& shown) {
        const std::string shape = editing::unusedName(text, scene, Kind::shapeSet, stem);
        const NewElement set{Kind::shapeSet, shape, {"-desc", description}, {}};
        NewElement body{Kind::body,
                        editing::unusedName(text, scene, Kind::body, "body", {shape}),
                        placeWords(shown[0]),
                        {},
                        shape};
        if (isFixed)
            body.words.insert(body.words.end(), {"-fixed", "1"});
        else
            body.words.insert(body.words.end(), {"-restitution", stem == "ball" ? "0.7" : "0"});
        body.words.insert(body.words.end(), {"-friction", "0.3"});
        return std::vector{set, body};
    };
    return recipe;
}

} // namespace

Recipe newBody(BasicShape basic) {
    const bool isBall = basic == BasicShape::sphere;
    Recipe recipe = isBall ? newBody("ball", "{-sub {-sphere 0.5}}")
                           : newBody("block", "{-sub {-box {1 1 1}}}");
    recipe.ghost.emplace_back();
    if (isBall)
        recipe.ghost.front().shape = scene::SphereShape{0.5};
    else
        recipe.ghost.front().shape = scene::BoxShape{};
    return recipe;
}

Recipe newBody(const editing::LibraryShape& shape) {
    std::string stem; // "thandle" of "T-handle"
    for (const char c : shape.name)
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            stem += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const bool isFixed = std::ranges::any_of(shape.parts, [](const scene::Part& part) {
        return std::holds_alternative<scene::PlaneShape>(part.shape);
    });
    Recipe recipe = newBody(stem, editing::descriptionText(shape.parts), isFixed);
    recipe.ghost = shape.parts;
    return recipe;
}

namespace {

// Of all bodies but planes, against the direction in which they fall; 0 for none.
double lowestOf(const scene::Scene& scene, const Vector& up) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const scene::Body& body : scene.bodies) {
        const geometry::Pose pose{body.initialPosition, body.initialAttitude};
        for (const render::Ball& ball : render::outlineOf(scene, body))
            lowest = std::min(lowest, up.dot(pose.toWorld(ball.center)) - ball.radius);
    }
    return std::isfinite(lowest) ? lowest : 0;
}

} // namespace

// At 0, or under the lowest body. A plane is what lies below its y, so that it is turned where
// things fall another way.
Recipe newFloor() {
    Recipe recipe;
    recipe.label = QObject::tr("New Floor");
    recipe.make = [](const std::string& text, const scene::Scene& scene,
                     const std::vector<Indicated>&) {
        const Vector up = render::upOf(scene);
        Indicated below;
        below.point = std::min(lowestOf(scene, up), 0.0) * up;
        below.resolution = 1e-6;
        std::vector<NewElement> made =
            newBody(editing::libraryShape("Floor")).make(text, scene, {below});
        const Vector turn =
            geometry::toRotationVector(geometry::Quaternion::FromTwoVectors(Vector::UnitY(), up));
        if (turn.norm() > 1e-9)
            made.back().words.insert(made.back().words.end(), {"-init_rot", listed(turn, 0)});
        return made;
    };
    return recipe;
}

Recipe measure() {
    Recipe recipe;
    recipe.label = QObject::tr("Measure");
    const auto point = [](const QString& prompt) {
        Step step = place(prompt, {});
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
        return QObject::tr("The distance is %1; along x, y and z %2.")
            .arg(
                QString::fromStdString(editing::numberText(way.norm(), editing::decimalStep(fine))),
                QString::fromStdString(apart.substr(1, apart.size() - 2)));
    };
    return recipe;
}

Recipe newForce(bool couple, double perUnit) {
    Recipe recipe;
    recipe.label = couple ? QObject::tr("New Torque") : QObject::tr("New Force");
    recipe.steps = {couple ? wholeBody(QObject::tr("Click on the body that it turns."))
                           : body(QObject::tr("Click where it acts on a body.")),
                    {Wanted::point,
                     couple ? QObject::tr("Click where the head of its axis shall be.")
                            : QObject::tr("Click where the head of its arrow shall be."),
                     couple ? QObject::tr("Return: 1 about z.")
                            : QObject::tr("Return: 1 downwards, along -y.")}};
    recipe.make = [couple, perUnit](const std::string&, const scene::Scene& scene,
                                    const std::vector<Indicated>& shown) {
        NewElement force{Kind::force, "", {}, {{Kind::body, *shown[0].body}}};
        if (couple)
            force.words = {"-torque", "1"};
        force.words.insert(force.words.end(), {"-body", bodyName(scene, shown[0])});
        const Vector unit = couple ? Vector(0, 0, 1) : Vector(0, -1, 0);
        addComponents(force,
                      shown[1].given ? Vector((shown[1].point - shown[0].point) / perUnit) : unit,
                      shown[1].given ? shown[1].resolution / perUnit : 1);
        if (!couple)
            addOffset(force, "-offset", shown[0]);
        return std::vector{force};
    };
    recipe.handles = couple ? &render::Display::torqueHandles : &render::Display::forceHandles;
    return recipe;
}

Recipe newWeight(double perUnit, std::function<double(std::size_t)> massOf, const Vector& usual) {
    const bool down = usual.x() == 0 && usual.z() == 0 && usual.y() < 0;
    const QString value =
        QString::fromStdString(down ? editing::numberText(-usual.y(), 0) : listed(usual, 0));
    Recipe recipe;
    recipe.label = QObject::tr("New Gravitational Force");
    recipe.steps = {wholeBody(QObject::tr("Click on the body that has weight.")),
                    {Wanted::point, QObject::tr("Click where the head of its arrow shall be."),
                     down ? QObject::tr("Return: %1 downwards, along -y.").arg(value)
                          : QObject::tr("Return: %1, as others have it.").arg(value)}};
    recipe.make = [perUnit, massOf = std::move(massOf),
                   usual](const std::string&, const scene::Scene& scene,
                          const std::vector<Indicated>& shown) {
        Vector acceleration = usual;
        double resolution = 0;
        if (shown[1].given) { // its arrow is that of the force
            const double length = perUnit * massOf(*shown[0].body);
            acceleration = alongAxis((shown[1].point - shown[0].point) / length);
            resolution = shown[1].resolution / length;
        }
        return std::vector{NewElement{Kind::force,
                                      "",
                                      {"-body", bodyName(scene, shown[0]), "-gravitational",
                                       listed(acceleration, resolution)},
                                      {{Kind::body, *shown[0].body}}}};
    };
    recipe.handles = &render::Display::forceHandles;
    return recipe;
}

Recipe weightForAll(const Vector& acceleration) {
    Recipe recipe;
    recipe.label = QObject::tr("Gravity for All Bodies");
    recipe.make = [acceleration](const std::string&, const scene::Scene& scene,
                                 const std::vector<Indicated>&) {
        std::set<std::string> heavy;
        for (const scene::Force& force : scene.forces)
            if (!force.couple && std::holds_alternative<scene::GravitationalForce>(force.kind))
                heavy.insert(force.body);
        std::vector<NewElement> made;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const scene::Body& body = scene.bodies[i];
            if (!body.fixed && !heavy.contains(body.name))
                made.push_back({Kind::force,
                                "",
                                {"-body", body.name, "-gravitational", listed(acceleration, 0)},
                                {{Kind::body, i}}});
        }
        return made;
    };
    recipe.otherwise = QObject::tr("Every body that is not fixed has a weight already.");
    recipe.handles = &render::Display::forceHandles;
    return recipe;
}

std::optional<Vector> commonGravity(const scene::Scene& scene) {
    std::map<std::string, Vector> weights; // by body
    for (const scene::Force& force : scene.forces)
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind);
            weight && !force.couple)
            weights.emplace(force.body, weight->acceleration);
    std::optional<Vector> common;
    for (const scene::Body& body : scene.bodies) {
        if (body.fixed)
            continue;
        const auto own = weights.find(body.name);
        if (own == weights.end() || (common && *common != own->second))
            return std::nullopt;
        common = own->second;
    }
    return common;
}

Vector usualGravity(const scene::Scene& scene) {
    Vector usual(0, -9.81, 0);
    for (const scene::Force& force : scene.forces)
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind);
            weight && weight->acceleration != Vector::Zero())
            usual = weight->acceleration;
    return usual;
}

Recipe newTrajectoryForce(bool couple) {
    return {couple ? QObject::tr("New Torque by a Trajectory")
                   : QObject::tr("New Force by a Trajectory"),
            {body(QObject::tr("Click on the body that it acts on.")),
             {Wanted::trajectory, QObject::tr("Click on the trajectory that gives its value."),
              QObject::tr("Return makes a new one.")}},
            [couple](const std::string& text, const scene::Scene& scene,
                     const std::vector<Indicated>& shown) {
                Path path = pathFrom(text, scene, shown[1], Vector(0, -1, 0), Vector(0, 0, 0), 1);
                NewElement force{Kind::force, "", {}, std::move(path.behind)};
                if (couple)
                    force.words = {"-torque", "1"};
                force.words.insert(force.words.end(),
                                   {"-body", bodyName(scene, shown[0]), "-trajectory", path.name});
                force.behind.push_back({Kind::body, *shown[0].body});
                path.made.push_back(force);
                return path.made;
            },
            couple ? &render::Display::torqueHandles : &render::Display::forceHandles};
}

Recipe newLink(Wanted second) {
    Recipe recipe;
    recipe.label = QObject::tr("New Link");
    const QString what = second == Wanted::body ? QObject::tr("Click on the body at its other end.")
                         : second == Wanted::point
                             ? QObject::tr("Click on the point that it is tied to.")
                             : QObject::tr("Click on the trajectory that leads it.");
    recipe.steps = {
        body(QObject::tr("Click where the link is fastened on a body.")),
        {second, what,
         second == Wanted::trajectory ? QObject::tr("Return makes a new one.") : QString()}};
    recipe.steps.back().snaps = second == Wanted::point;
    recipe.make = [second](const std::string& text, const scene::Scene& scene,
                           const std::vector<Indicated>& shown) {
        NewElement link{
            Kind::link, "", {"-body1", bodyName(scene, shown[0])}, {{Kind::body, *shown[0].body}}};
        std::vector<NewElement> made;
        addOffset(link, "-offset1", shown[0]);
        if (second == Wanted::body) {
            link.words.insert(link.words.end(), {"-body2", bodyName(scene, shown[1])});
            addOffset(link, "-offset2", shown[1]);
            link.behind.push_back({Kind::body, *shown[1].body});
        } else if (second == Wanted::point) {
            addComponents(link, shown[1].point, shown[1].resolution);
        } else {
            Path path = pathFrom(text, scene, shown[1], shown[0].point, Vector(1, 0, 0),
                                 shown[0].resolution);
            link.words.insert(link.words.end(), {"-trajectory", path.name});
            link.behind.insert(link.behind.end(), path.behind.begin(), path.behind.end());
            made = path.made;
        }
        link.words.insert(link.words.end(),
                          {"-tightness", editing::numberText(tightnessOf(scene), 0)});
        made.push_back(link);
        return made;
    };
    recipe.handles = &render::Display::linkHandles;
    return recipe;
}

Recipe newSpring(Wanted second) {
    Recipe recipe = newLink(second);
    recipe.label = QObject::tr("New Spring");
    recipe.steps.front().prompt = QObject::tr("Click where the spring is fastened on a body.");
    recipe.make = [make = recipe.make, second](const std::string& text, const scene::Scene& scene,
                                               const std::vector<Indicated>& shown) {
        auto made = make(text, scene, shown);
        NewElement& spring = made.back();
        spring.command = "spring";
        spring.name = editing::unusedName(text, scene, Kind::link, "spring");
        constexpr const char* usual = "20"; // a body of half a kilogram swings once a second
        const auto tightness = std::ranges::find(spring.words, "-tightness");
        spring.words.erase(tightness, spring.words.end());
        spring.words.insert(spring.words.end(), {"-stiffness", usual});
        // Its length now, so that whoever moves an end stretches it.
        const double rest = (shown[1].point - shown[0].point).norm();
        if (second != Wanted::trajectory && rest > 0)
            spring.words.insert(spring.words.end(),
                                {"-rest", editing::numberText(rest, 0.01 * shown[0].resolution)});
        return made;
    };
    return recipe;
}

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

} // namespace

Recipe newAttraction() {
    Recipe recipe;
    recipe.label = QObject::tr("New Attraction");
    recipe.steps = {wholeBody(QObject::tr("Click on a body: a sun.")),
                    wholeBody(QObject::tr("Click on the body that it attracts: a planet."))};
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

// On the middle of the scene, and into the picture: it lights the sides that one sees.
static Vector firstDirection(const scene::Scene& scene, const Indicated& place) {
    const Vector way = render::extentOf(scene, nullptr).box.center() - place.point;
    const Vector onto = way.norm() > 1e-9 ? Vector(way.normalized()) : Vector(0, -1, 0);
    return (0.8 * onto - place.sight).normalized();
}

Recipe newLight(bool point) {
    return {QObject::tr("New Light"),
            {place((point ? QObject::tr("Click where the light shall stand.")
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
    Step step = place(QObject::tr("Click on its points, one after another, or type x y z."),
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
            {body(QObject::tr("Click on the body that is to be led.")),
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

Recipe newPlot(const std::string& expression) {
    return {
        QObject::tr("New Plot"),
        {},
        [=](const std::string& text, const scene::Scene& scene, const std::vector<Indicated>&) {
            NewElement plot{Kind::plot,
                            editing::unusedName(text, scene, Kind::plot, "plot"),
                            {"-values", "{{" + expression + "}}"},
                            {}};
            for (const Kind kind : {Kind::body, Kind::link, Kind::joint, Kind::rope, Kind::contact})
                for (std::size_t i = 0; editing::sourceOf(scene, {kind, i}); ++i)
                    if (const std::string name = editing::nameOf(scene, {kind, i});
                        !name.empty() && expression.find(name + ".") != std::string::npos)
                        plot.behind.push_back({kind, i});
            return std::vector{plot};
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

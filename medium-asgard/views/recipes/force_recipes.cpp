// Create > Force, Gravity, Link, Spring.
#include "editing/number_text.h"
#include "recipes/recipe_words.h"
#include "recipes/recipes.h"

#include <QObject>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace views {

using editing::Element;
using editing::Kind;
using editing::NewElement;

namespace {

void addComponents(NewElement& element, const Vector& v, double resolution) {
    constexpr const char* options[] = {"-x", "-y", "-z"};
    for (int i = 0; i < 3; ++i)
        element.words.insert(
            element.words.end(),
            {options[i], editing::numberText(v[i], editing::decimalStep(resolution))});
}

// The head of an arrow is clicked, or its value is typed.
Step arrowHead(const QString& prompt, const QString& otherwise, const QString& unit,
               std::function<double(const Indicated& tail)> perUnit) {
    Step head{Wanted::point, prompt, otherwise};
    head.headOf = [perUnit](const std::vector<Indicated>& shown, const Vector& value) {
        return Vector(shown[0].point + perUnit(shown[0]) * value);
    };
    head.judge = [perUnit, unit](const scene::Scene&, const std::vector<Indicated>& shown,
                                 const Indicated& next) {
        const double length = perUnit(shown[0]);
        const std::string value =
            listed((next.point - shown[0].point) / length, next.resolution / length);
        return Judged{QString::fromStdString(value.substr(1, value.size() - 2)) + unit, true};
    };
    return head;
}

double tightnessOf(const scene::Scene& scene) {
    const auto last = std::find_if(scene.links.rbegin(), scene.links.rend(),
                                   [](const scene::Link& link) { return !link.spring; });
    return last == scene.links.rend() ? 100 : last->tightness;
}

} // namespace

Recipe newForce(bool couple, double perUnit) {
    Recipe recipe;
    recipe.label = couple ? QObject::tr("New Torque") : QObject::tr("New Force");
    recipe.steps = {
        couple ? showWholeBody(QObject::tr("Click on the body that it turns."))
               : showBody(QObject::tr("Click where it acts on a body.")),
        arrowHead(couple ? QObject::tr("Click where the head of its axis shall be, or type its "
                                       "x y z.")
                         : QObject::tr("Click where the head of its arrow shall be, or type its "
                                       "x y z."),
                  couple ? QObject::tr("Return: 1 about z.")
                         : QObject::tr("Return: 1 downwards, along -y."),
                  couple ? QStringLiteral(" N m") : QStringLiteral(" N"),
                  [perUnit](const Indicated&) { return perUnit; })};
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
    recipe.steps = {
        showWholeBody(QObject::tr("Click on the body that has weight.")),
        arrowHead(QObject::tr("Click where the head of its arrow shall be, or type its x y z."),
                  down ? QObject::tr("Return: %1 downwards, along -y.").arg(value)
                       : QObject::tr("Return: %1, as others have it.").arg(value),
                  QStringLiteral(" m/s²"), [perUnit, massOf](const Indicated& tail) {
                      return perUnit * massOf(*tail.body);
                  })};
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

namespace {

// `isMeant`: of a body of the scene.
Recipe weights(const Vector& acceleration, std::function<bool(std::size_t)> isMeant) {
    Recipe recipe;
    recipe.make = [acceleration, isMeant = std::move(isMeant)](const std::string&,
                                                               const scene::Scene& scene,
                                                               const std::vector<Indicated>&) {
        std::set<std::string> heavy;
        for (const scene::Force& force : scene.forces)
            if (!force.couple && std::holds_alternative<scene::GravitationalForce>(force.kind))
                heavy.insert(force.body);
        std::vector<NewElement> made;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const scene::Body& body = scene.bodies[i];
            if (isMeant(i) && !body.fixed && !heavy.contains(body.name))
                made.push_back({Kind::force,
                                "",
                                {"-body", body.name, "-gravitational", listed(acceleration, 0)},
                                {{Kind::body, i}}});
        }
        return made;
    };
    recipe.handles = &render::Display::forceHandles;
    recipe.keepsSelection = true;
    return recipe;
}

} // namespace

Recipe weightForAll(const Vector& acceleration) {
    Recipe recipe = weights(acceleration, [](std::size_t) { return true; });
    recipe.label = QObject::tr("Gravity for All Bodies");
    recipe.otherwise = QObject::tr("Every body that is not fixed has a weight already.");
    return recipe;
}

Recipe weightFor(const std::vector<std::size_t>& bodies, const Vector& acceleration) {
    Recipe recipe = weights(acceleration, [bodies](std::size_t body) {
        return std::ranges::find(bodies, body) != bodies.end();
    });
    recipe.label = QObject::tr("Gravity for the Selected Bodies");
    recipe.otherwise =
        bodies.empty() ? QObject::tr("No body is selected: click on one, and with Shift on others.")
                       : QObject::tr("Each selected body is fixed or has a weight already.");
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
            {showBody(QObject::tr("Click on the body that it acts on.")),
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
        showBody(QObject::tr("Click where the link is fastened on a body.")),
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

} // namespace views

// Create > Body and Floor.
#include "editing/number_text.h"
#include "framing/extent.h"
#include "point_edits/shape_edit.h"
#include "recipes/recipe_words.h"
#include "recipes/recipes.h"

#include <QObject>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace views {

using editing::Kind;
using editing::NewElement;

namespace {

scene::Part scaled(scene::Part part, double times) {
    part.position *= times;
    std::visit(
        [times](auto& shape) {
            if constexpr (requires { shape.radius; })
                shape.radius *= times;
            if constexpr (requires { shape.height; })
                shape.height *= times;
            if constexpr (requires { shape.inner; })
                shape.inner *= times;
            if constexpr (requires { shape.outer; })
                shape.outer *= times;
            if constexpr (requires { shape.edges; })
                shape.edges *= times;
            if constexpr (requires { shape.axes; })
                shape.axes *= times;
            if constexpr (requires { shape.points; })
                for (Vector& point : shape.points)
                    point *= times;
        },
        part.shape);
    return part;
}

bool isBallShape(const std::vector<scene::Part>& parts) {
    return std::ranges::all_of(parts, [](const scene::Part& part) {
        return std::holds_alternative<scene::SphereShape>(part.shape);
    });
}

} // namespace

Recipe newBody(const std::string& shape, std::vector<scene::Part> ghost) {
    Step where =
        showPlace(QObject::tr("Click where the new body shall be, on the grid or on a body that "
                              "it rests on, or type x y z."),
                  QObject::tr("Return puts it at the origin."));
    where.rests = true;
    return {QObject::tr("New Body"),
            {where},
            [shape](const std::string& text, const scene::Scene& scene,
                    const std::vector<Indicated>& shown) {
                NewElement body{Kind::body,
                                editing::unusedName(text, scene, Kind::body, shape),
                                placeWords(shown[0].point, shown[0].attitude, shown[0].resolution),
                                {},
                                shape};
                for (std::size_t i = 0; i < scene.shapeSets.size(); ++i)
                    if (scene.shapeSets[i].name == shape)
                        body.behind.push_back({Kind::shapeSet, i});
                if (const scene::ShapeSet* set = scene::findShapeSet(scene, shape)) {
                    const bool isColored =
                        set->appearance.color ||
                        std::ranges::any_of(set->parts, [](const scene::Part& part) {
                            return part.appearance.color.has_value();
                        });
                    addRoomWords(body, scene, isBallShape(set->parts), isColored);
                }
                return std::vector{body};
            },
            &render::Display::positionHandles,
            {},
            std::move(ghost)};
}

namespace {

Recipe newBody(const std::string& stem, const std::string& description, bool isFixed = false) {
    Recipe recipe = views::newBody(std::string());
    recipe.make = [stem, description, isFixed](const std::string& text, const scene::Scene& scene,
                                               const std::vector<Indicated>& shown) {
        const std::string shape = editing::unusedName(text, scene, Kind::shapeSet, stem);
        const NewElement set{Kind::shapeSet, shape, {"-desc", description}, {}};
        NewElement body{Kind::body,
                        editing::unusedName(text, scene, Kind::body, "body", {shape}),
                        placeWords(shown[0].point, shown[0].attitude, shown[0].resolution),
                        {},
                        shape};
        if (isFixed)
            body.words.insert(body.words.end(), {"-fixed", "1", "-friction", "0.3"});
        else
            addRoomWords(body, scene, stem == "ball", false);
        return std::vector{set, body};
    };
    return recipe;
}

} // namespace

Recipe newBody(BasicShape basic, double times) {
    const bool isBall = basic == BasicShape::sphere;
    scene::Part part;
    if (isBall)
        part.shape = scene::SphereShape{0.5 * times};
    else
        part.shape = scene::BoxShape{times * Vector::Ones()};
    Recipe recipe = newBody(isBall ? "ball" : "block", editing::descriptionText({part}));
    recipe.ghost = {part};
    return recipe;
}

Recipe newBody(const editing::LibraryShape& shape, double times) {
    std::string stem; // "thandle" of "T-handle"
    for (const char c : shape.name)
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            stem += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::vector<scene::Part> parts;
    for (const scene::Part& part : shape.parts)
        parts.push_back(scaled(part, times));
    Recipe recipe = newBody(stem, editing::descriptionText(parts), shape.stands);
    recipe.ghost = std::move(parts);
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

} // namespace views

// shape_set and body.
#include "script/scene_maker.h"

#include "script/suggestion.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>

namespace script {

using geometry::Vector;

namespace {

constexpr std::string_view wantsDescription =
    "a list of -face {points} and -sub {part} descriptions";

// It is the other one, rounded to four digits behind the point or more.
bool isRounded(double number, double of) {
    constexpr double none = 1e-13;
    for (const double unit : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
        if (std::abs(number - std::round(of / unit) * unit) <= none)
            return true;
    return false;
}

// About one axis: 1.5708 means a quarter turn, and 3.1416 a half.
Vector withWholeQuarters(Vector rotation) {
    constexpr double quarter = std::numbers::pi / 2;
    for (double& angle : rotation) {
        const double whole = std::round(angle / quarter) * quarter;
        if (whole != 0 && std::abs(angle) == rotation.norm() && isRounded(angle, whole))
            angle = whole;
    }
    return rotation;
}

// Four of the points span a body that is not flat against its own size.
bool spanSpace(const std::vector<Vector>& points) {
    constexpr double flat = 1e-9;
    if (points.size() < 4)
        return false;
    const Vector origin = points[0];
    const auto farthest = [&](auto measure) {
        double most = -1;
        Vector best = Vector::Zero();
        for (const Vector& p : points)
            if (const double m = measure(Vector(p - origin)); m > most) {
                most = m;
                best = p - origin;
            }
        return std::pair(best, most);
    };
    const auto [edge, length] = farthest([](const Vector& d) { return d.norm(); });
    if (!(length > 0))
        return false;
    const Vector along = edge / length;
    const auto [side, width] =
        farthest([&](const Vector& d) { return (d - d.dot(along) * along).norm(); });
    if (!(width > flat * length))
        return false;
    const Vector normal = along.cross(Vector((side - side.dot(along) * along) / width));
    const auto depth = farthest([&](const Vector& d) { return std::abs(d.dot(normal)); }).second;
    return depth > flat * length;
}

} // namespace

bool SceneMaker::solid(Arguments& arguments, std::string_view option, Range range,
                       const std::vector<Vector>& points) {
    if (spanSpace(points))
        return true;
    const std::string but =
        points.size() < 4 ? "and there are fewer"
                          : "and these " + std::to_string(points.size()) + " lie in one plane";
    arguments.wrong(option, range, "at least four points that bound a solid", but);
    return false;
}

// -color, -shininess and -transparency inside a description; `i` moves on to their value.
bool SceneMaker::appearanceWord(Arguments& arguments, const std::vector<Value>& words,
                                std::size_t& i, scene::Appearance& appearance) {
    const std::string& option = words[i].text;
    if (option != "-color" && option != "-shininess" && option != "-transparency")
        return false;
    if (i + 1 >= words.size()) {
        arguments.wrong(option, words[i].range, "a value", "and nothing follows it");
        return true;
    }
    const Value& value = words[++i];
    if (option == "-color")
        appearance.color = arguments.colorIn(option, value);
    else if (option == "-shininess")
        appearance.shininess =
            arguments.numberIn(option, value, Sign::unit, "a number from 0 to 1");
    else
        appearance.transparency =
            arguments.numberIn(option, value, Sign::unit, "a number from 0 to 1");
    return true;
}

bool SceneMaker::facePoints(Arguments& arguments, const Value& face, std::vector<Vector>& points,
                            scene::Appearance& appearance) {
    const auto words = arguments.listIn("-face", face, "a list of points {x y z}");
    if (!words)
        return false;
    bool good = true;
    std::size_t count = 0;
    scene::Appearance own;
    for (std::size_t i = 0; i < words->size(); ++i) {
        if (appearanceWord(arguments, *words, i, own))
            continue;
        const auto point = arguments.vectorIn("-face", (*words)[i], "points of three numbers");
        good = good && point.has_value();
        ++count;
        if (point)
            points.push_back(*point);
        else
            break; // one report per face
    }
    if (good && count < 3) {
        arguments.wrong("-face", face.range, "at least three points", "and gets fewer");
        good = false;
    }
    // Several colours in one hull: the first is the hull's.
    if (!appearance.color)
        appearance.color = own.color;
    if (!appearance.shininess)
        appearance.shininess = own.shininess;
    if (!appearance.transparency)
        appearance.transparency = own.transparency;
    return good;
}

// {radius height}; without height it may be flat where `mayBeFlat`.
template <typename Round>
bool SceneMaker::roundPart(Arguments& arguments, const std::string& option, const Value& value,
                           bool mayBeFlat, scene::Part& part) {
    const std::string wants =
        mayBeFlat ? "{radius height}, a positive number and one that is not negative"
                  : "{radius height}, two positive numbers";
    const auto numbers = arguments.numbersIn(option, value, wants);
    if (!numbers)
        return false;
    if (numbers->size() != 2) {
        arguments.wrong(option, value.range, wants, "and gets " + std::to_string(numbers->size()));
        return false;
    }
    const double radius = (*numbers)[0], height = (*numbers)[1];
    if (!(radius > 0) || !(mayBeFlat ? height >= 0 : height > 0)) {
        arguments.wrong(option, value.range, wants, "not " + quoted(value.text));
        return false;
    }
    part.shape = Round{radius, height};
    return true;
}

// {r R h} of a tube, {r R} of a bowl: the hollow is the smaller.
bool SceneMaker::hollowPart(Arguments& arguments, const std::string& option, const Value& value,
                            scene::Part& part) {
    const bool isTube = option == "-tube";
    const std::string wants =
        isTube ? "{r R h}, the radii inside and outside and the height, with 0 < r < R and 0 < h"
               : "{r R}, the radii inside and outside, with 0 < r < R";
    const auto numbers = arguments.numbersIn(option, value, wants);
    if (!numbers)
        return false;
    const std::size_t count = isTube ? 3 : 2;
    if (numbers->size() != count) {
        arguments.wrong(option, value.range, wants, "and gets " + std::to_string(numbers->size()));
        return false;
    }
    const double inner = (*numbers)[0], outer = (*numbers)[1];
    if (!(inner > 0) || !(outer > inner) || !(numbers->back() > 0)) {
        arguments.wrong(option, value.range, wants, "not " + quoted(value.text));
        return false;
    }
    if (isTube)
        part.shape = scene::TubeShape{inner, outer, (*numbers)[2]};
    else
        part.shape = scene::BowlShape{inner, outer};
    return true;
}

// Those with a value; of -plane in partOf().
bool SceneMaker::shapeOfPart(Arguments& arguments, const std::string& option, const Value& value,
                             scene::Part& part) {
    if (option == "-sphere") {
        const auto radius = arguments.numberIn(option, value, Sign::positive, "a positive radius");
        part.shape = scene::SphereShape{radius.value_or(1)};
        return radius.has_value();
    }
    if (option == "-box") {
        const auto edges = arguments.vectorIn(option, value, "three positive edge lengths");
        if (edges && edges->minCoeff() <= 0)
            arguments.wrong(option, value.range, "three positive edge lengths",
                            "not " + quoted(value.text));
        part.shape = scene::BoxShape{edges.value_or(Vector::Ones())};
        return edges && edges->minCoeff() > 0;
    }
    if (option == "-cylinder")
        return roundPart<scene::CylinderShape>(arguments, option, value, true, part);
    if (option == "-cone")
        return roundPart<scene::ConeShape>(arguments, option, value, false, part);
    if (option == "-capsule")
        return roundPart<scene::CapsuleShape>(arguments, option, value, true, part);
    if (option == "-tube" || option == "-bowl")
        return hollowPart(arguments, option, value, part);
    if (option == "-ellipsoid") {
        const auto axes = arguments.vectorIn(option, value, "three positive half axes");
        if (axes && axes->minCoeff() <= 0)
            arguments.wrong(option, value.range, "three positive half axes",
                            "not " + quoted(value.text));
        part.shape = scene::EllipsoidShape{axes.value_or(Vector::Ones())};
        return axes && axes->minCoeff() > 0;
    }
    const auto list = arguments.listIn(option, value, "a list of points {x y z}");
    if (!list)
        return false;
    scene::HullShape hull;
    for (const Value& point : *list) {
        const auto p = arguments.vectorIn(option, point, "points of three numbers");
        if (!p)
            return false; // one report per list
        hull.points.push_back(*p);
    }
    part.shape = hull;
    return solid(arguments, option, value.range, hull.points);
}

std::optional<scene::Part> SceneMaker::partOf(Arguments& arguments, const Value& description) {
    static const std::vector<std::string> options = {
        "-sphere",    "-box",   "-points",    "-cylinder",    "-cone", "-capsule",
        "-ellipsoid", "-tube",  "-bowl",      "-plane",       "-pos",  "-rot",
        "-density",   "-color", "-shininess", "-transparency"};
    const auto words = arguments.listIn("-sub", description, "a list of options");
    if (!words)
        return std::nullopt;
    const std::string whole = "-sub of " + arguments.subject();
    scene::Part part;
    bool shaped = false;
    bool good = true;
    for (std::size_t i = 0; i < words->size(); ++i) {
        if (appearanceWord(arguments, *words, i, part.appearance))
            continue;
        const Value& option = (*words)[i];
        if (std::find(options.begin(), options.end(), option.text) == options.end()) {
            faults_.error(option.range, whole + " has no option " + quoted(option.text),
                          suggestionFor(option.text, options, "options here"));
            return std::nullopt;
        }
        if (option.text == "-plane" && !shaped) {
            part.shape = scene::PlaneShape{};
            shaped = true;
            continue;
        }
        if (i + 1 >= words->size() && option.text != "-plane") {
            arguments.wrong(option.text, option.range, "a value", "and nothing follows it");
            return std::nullopt;
        }
        const Value& value = option.text == "-plane" ? option : (*words)[++i];
        if (option.text == "-pos" || option.text == "-rot") {
            const auto v = arguments.vectorIn(option.text, value, "three numbers");
            good = good && v.has_value();
            (option.text == "-pos" ? part.position : part.rotation) =
                option.text == "-rot" && v ? withWholeQuarters(*v) : v.value_or(Vector::Zero());
        } else if (option.text == "-density") {
            part.density =
                arguments.numberIn(option.text, value, Sign::positive, "a positive number");
            good = good && part.density.has_value();
        } else if (std::exchange(shaped, true)) {
            faults_.error(option.range, whole + " is one part, and has a shape already",
                          "write another -sub {...} for another part");
            return std::nullopt;
        } else {
            good = shapeOfPart(arguments, option.text, value, part) && good;
        }
    }
    if (!shaped && good)
        arguments.wrong("-sub", description.range,
                        "one of -sphere, -box, -cylinder, -cone, -capsule, -ellipsoid, -tube, "
                        "-bowl, -points and -plane",
                        "and gets none");
    if (part.density && std::holds_alternative<scene::PlaneShape>(part.shape)) {
        arguments.wrong("-density", description.range, "a part with a volume",
                        "and a -plane has no mass");
        good = false;
    }
    return good && shaped ? std::optional(part) : std::nullopt;
}

std::vector<scene::Part> SceneMaker::partsOf(Arguments& arguments, const Value& description) {
    std::vector<scene::Part> parts;
    const auto words = arguments.listIn("-desc", description, wantsDescription);
    if (!words)
        return parts;
    std::optional<std::size_t> hullAt;
    std::vector<Vector> points;
    scene::Appearance hullAppearance;
    bool good = true;
    for (std::size_t i = 0; i < words->size(); ++i) {
        const Value& option = (*words)[i];
        if (option.text != "-face" && option.text != "-sub") {
            static const std::vector<std::string> known = {"-face", "-sub"};
            arguments.wrong("-desc", option.range, wantsDescription, "not " + quoted(option.text),
                            suggestionFor(option.text, known, "here"));
            return parts;
        }
        if (i + 1 >= words->size()) {
            arguments.wrong(option.text, option.range, "a description in braces",
                            "and nothing follows it");
            return parts;
        }
        const Value& value = (*words)[++i];
        if (option.text == "-face") {
            if (!hullAt) {
                hullAt = parts.size();
                parts.emplace_back();
            }
            good = facePoints(arguments, value, points, hullAppearance) && good;
        } else if (auto part = partOf(arguments, value)) {
            parts.push_back(std::move(*part));
        } else {
            good = false;
        }
    }
    if (parts.empty() && good)
        arguments.wrong("-desc", description.range, wantsDescription, "and gets none");
    if (hullAt) {
        if (good)
            solid(arguments, "-face", description.range, points);
        parts[*hullAt].shape = scene::HullShape{points};
        parts[*hullAt].appearance = hullAppearance;
    }
    return parts;
}

void SceneMaker::shapeSet(Call& call) {
    scene::ShapeSet set;
    set.name = newName(call, Kind::shapeSet);
    if (set.name.empty())
        return;
    Arguments arguments(faults_, call, "shape set " + quoted(set.name), 2,
                        {"-desc", "-color", "-shininess", "-transparency"});
    set.appearance = arguments.appearance();
    if (const Value* description = arguments.find("-desc"))
        set.parts = partsOf(arguments, *description);
    else if (arguments.attempted("-desc"))
        arguments.text("-desc");
    else
        arguments.wrongElement("wants -desc with the description of its parts");
    set.source = call.source;
    made_.scene.shapeSets.push_back(std::move(set));
}

// --- bodies ---------------------------------------------------------------------------------

void SceneMaker::attitude(Arguments& arguments, scene::Body& body) {
    constexpr std::string_view wants =
        "three numbers (a rotation vector) or four (a quaternion w x y z)";
    const Value* value = arguments.find("-init_rot");
    if (!value) {
        if (arguments.attempted("-init_rot"))
            arguments.wrong("-init_rot", arguments.optionRange("-init_rot"), wants,
                            "and nothing follows it");
        return;
    }
    const auto n = arguments.numbersIn("-init_rot", *value, wants);
    if (!n)
        return;
    if (n->size() == 3) {
        const Vector v = withWholeQuarters({(*n)[0], (*n)[1], (*n)[2]});
        const double angle = v.norm();
        if (angle > 0)
            body.initialAttitude =
                geometry::Quaternion(Eigen::AngleAxisd(angle, Vector(v / angle)));
    } else if (n->size() == 4) {
        geometry::Quaternion q((*n)[0], (*n)[1], (*n)[2], (*n)[3]);
        const double largest = q.coeffs().cwiseAbs().maxCoeff();
        if (!(largest > 0)) {
            arguments.wrong("-init_rot", value->range, wants, "and the quaternion is zero");
            return;
        }
        q.coeffs() /= largest; // squares neither overflow nor vanish
        body.initialAttitude = q.normalized();
    } else {
        arguments.wrong("-init_rot", value->range, wants, "and gets " + std::to_string(n->size()));
    }
}

void SceneMaker::inertia(Arguments& arguments, scene::Body& body) {
    constexpr std::string_view wants = "three numbers (principal) or six (xx yy zz xy xz yz)";
    const Value* value = arguments.find("-inertia");
    if (!value) {
        if (arguments.attempted("-inertia"))
            arguments.wrong("-inertia", arguments.optionRange("-inertia"), wants,
                            "and nothing follows it");
        return;
    }
    const auto n = arguments.numbersIn("-inertia", *value, wants);
    if (!n)
        return;
    if (n->size() != 3 && n->size() != 6) {
        arguments.wrong("-inertia", value->range, wants, "and gets " + std::to_string(n->size()));
        return;
    }
    std::array<double, 6> entries{};
    std::copy(n->begin(), n->end(), entries.begin());
    geometry::Matrix tensor;
    tensor << entries[0], entries[3], entries[4], entries[3], entries[1], entries[5], entries[4],
        entries[5], entries[2];
    const double scale = tensor.cwiseAbs().maxCoeff();
    const Eigen::LLT<geometry::Matrix> factors(scale > 0 ? geometry::Matrix(tensor / scale)
                                                         : tensor);
    if (!(scale > 0) || factors.info() != Eigen::Success) {
        arguments.wrong("-inertia", value->range, "a positive definite tensor",
                        "not " + quoted(value->text));
        return;
    }
    body.inertia = entries;
}

// A disc weighs nothing, and a half space cannot move; where trajectories hold it is known at the
// end (checkPlanes).
void SceneMaker::checkShapeOf(Arguments& arguments, const scene::Body& body) {
    const scene::ShapeSet* set = scene::findShapeSet(made_.scene, body.shape);
    if (!set || body.fixed || set->parts.empty())
        return;
    if (scene::hasPlane(*set))
        planes_.emplace_back(body.name, arguments.commandRange());
    else if (!scene::hasVolume(*set) && !arguments.attempted("-mass"))
        arguments.wrongElement("wants -mass: its shape has no volume");
}

void SceneMaker::body(Call& call) {
    scene::Body body;
    body.name = newName(call, Kind::body);
    if (body.name.empty())
        return;
    const std::string subject = "body " + quoted(body.name);
    std::size_t first = 2;
    const bool positional = call.words.size() > 2 && !call.words[2].text.starts_with('-');
    if (positional) {
        first = 3;
        call.source.arguments.push_back({"", call.words[2].range, call.words[2].exact});
    }
    Arguments arguments(faults_, call, subject, first,
                        {"-shape",
                         "-init_pos",
                         "-init_rot",
                         "-init_dpos",
                         "-init_drot",
                         "-mass",
                         "-inertia",
                         "-center",
                         "-density",
                         "-restitution",
                         "-friction",
                         "-static_friction",
                         "-rolling_friction",
                         "-surface_velocity",
                         "-fixed",
                         "-artbody",
                         "-ct",
                         "-color",
                         "-shininess",
                         "-transparency"});
    if (positional) {
        body.shape = call.words[2].text;
        if (!exists(Kind::shapeSet, body.shape))
            faults_.error(call.words[2].range,
                          subject + ": no shape set named " + quoted(body.shape),
                          suggest(Kind::shapeSet, body.shape));
        else if (arguments.has("-shape"))
            faults_.error(arguments.optionRange("-shape"),
                          subject + " has its shape already: " + quoted(body.shape));
    } else if (arguments.attempted("-shape")) {
        body.shape = reference(arguments, "-shape", Kind::shapeSet).value_or("");
    } else {
        arguments.wrongElement("wants a shape: body NAME SHAPE ... or -shape SHAPE");
    }
    body.initialPosition = arguments.vector("-init_pos").value_or(Vector::Zero());
    attitude(arguments, body);
    body.initialVelocity = arguments.vector("-init_dpos").value_or(Vector::Zero());
    body.initialAngularVelocity = arguments.vector("-init_drot").value_or(Vector::Zero());
    body.mass = arguments.number("-mass", Sign::positive);
    inertia(arguments, body);
    body.center = arguments.vector("-center");
    if (arguments.attempted("-center") &&
        (!arguments.attempted("-mass") || !arguments.attempted("-inertia")))
        faults_.error(arguments.optionRange("-center"),
                      "-center of " + subject +
                          " wants -mass and -inertia beside it, which the shape would give about "
                          "another centre");
    body.density = arguments.number("-density", Sign::positive).value_or(1);
    body.restitution = arguments.number("-restitution", Sign::unit).value_or(1);
    body.friction = arguments.number("-friction", Sign::notNegative).value_or(0);
    body.staticFriction = arguments.number("-static_friction", Sign::notNegative);
    if (body.staticFriction && *body.staticFriction < body.friction)
        faults_.error(arguments.optionRange("-static_friction"),
                      "-static_friction of " + subject + " is less than its -friction");
    body.rollingFriction = arguments.number("-rolling_friction", Sign::notNegative).value_or(0);
    body.surfaceVelocity = arguments.vector("-surface_velocity").value_or(Vector::Zero());
    body.fixed = arguments.flag("-fixed").value_or(false);
    checkShapeOf(arguments, body);
    body.articulatedBody = arguments.name("-artbody", "an articulated body").value_or("");
    body.collisionGroup = arguments.integer("-ct");
    body.appearance = arguments.appearance();
    body.source = call.source;
    made_.scene.bodies.push_back(std::move(body));
}

} // namespace script

#include "element_edits/options.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace editing {

namespace {

using enum Wants;

constexpr OptionHint simulatorOptions[] = {
    {"-start", number, "the time at which the motion begins (0)", ""},
    {"-finish", number, "the time at which it ends (10)", ""},
    {"-step", number, "the first step; the engine's choice", ""},
    {"-accuracy", number, "largest position error over the size of the scene (1e-4)", ""},
    {"-method", choice, "how it is integrated (auto)",
     "auto forward-euler symplectic-euler midpoint rk4 trapezoidal backward-euler tsit5 dopri5 "
     "dop853 gbs "
     "tr-bdf2 radau5 sdirk4 rodas4 original"},
    {"-collisions", flag, "1: bodies hit each other; 0: they pass through", ""},
};
constexpr OptionHint shapeOptions[] = {
    {"-desc", list,
     "parts: -sub {... -sphere R | -box {a b c} | -cylinder {r h} | -cone {r h} | -capsule {r h} | "
     "-ellipsoid {a b c} | -tube {r R h} | -bowl {r R} | -plane | -points {...}} and -face {{x y "
     "z} ...}",
     "", "Parts"},
    {"-color", color, "#rrggbb, a name, or {r g b} from 0 to 1", "", "Colour"},
    {"-shininess", number, "from 0, matt, to 1", ""},
    {"-transparency", number, "from 0, opaque, to 1", ""},
};
constexpr OptionHint bodyOptions[] = {
    {"-shape", shapeSet, "the name of a shape set", ""},
    {"-init_pos", vector, "three numbers: where its reference point starts", "", "Place"},
    {"-init_rot", vector, "a rotation vector (axis times angle), or a quaternion w x y z", "",
     "Attitude"},
    {"-init_dpos", vector, "three numbers: its velocity at the start", "", "Velocity"},
    {"-init_drot", vector, "three numbers: its angular velocity at the start, axis times rate", "",
     "Angular velocity"},
    {"-mass", number, "a positive number; else the shape's volume times -density", ""},
    {"-inertia", vector, "three principal values, or xx yy zz xy xz yz", ""},
    {"-center", vector, "three numbers: its centre of mass, with -mass and -inertia", "",
     "Centre of mass"},
    {"-density", number, "a positive number (1)", ""},
    {"-restitution", number,
     "0: it does not bounce, 1: it loses nothing; of two bodies that meet the smaller counts (1)",
     ""},
    {"-friction", number, "Coulomb's coefficient, of both bodies' the geometric mean (0)", ""},
    {"-static_friction", number, "the same while nothing slides, at least -friction", ""},
    {"-rolling_friction", number, "a length: the couple that resists rolling, over the force", ""},
    {"-surface_velocity", vector, "three numbers, body frame: its surface moves as a conveyor", ""},
    {"-fixed", flag, "1: it never moves", "0"},
    {"-artbody", text, "the articulated body that it is a part of", "", "Articulated body"},
    {"-ct", integer, "bodies of one collision group do not hit each other", "", "Collision group"},
    {"-color", color, "#rrggbb, a name, or {r g b} from 0 to 1", "", "Colour"},
    {"-shininess", number, "from 0, matt, to 1", ""},
    {"-transparency", number, "from 0, opaque, to 1", ""},
};
constexpr OptionHint forceOptions[] = {
    {"-body", body, "the body that it acts on", ""},
    {"-torque", flag, "1: it turns the body and makes no net force", "0", "Turns only"},
    {"-offset", vector, "three numbers: where it acts, in the body's frame", "", "Acts at"},
    {"-x", expression, "an expression: its component along x", "", "Along x"},
    {"-y", expression, "an expression: its component along y", "", "Along y"},
    {"-z", expression, "an expression: its component along z", "", "Along z"},
    {"-frame", choice, "whose axes x, y and z are (world)", "world body", "Axes of"},
    {"-trajectory", trajectory, "a trajectory whose value now is the force", ""},
    {"-gravitational", vector, "three numbers: the acceleration that it gives", "", "Gravity"},
    {"-release", expression, "an expression: the force is gone as soon as it is not 0", "",
     "Released when"},
};
template <std::size_t... Counts> constexpr auto joined(const OptionHint (&... parts)[Counts]) {
    std::array<OptionHint, (Counts + ...)> all{};
    auto next = all.begin();
    ((next = std::copy(std::begin(parts), std::end(parts), next)), ...);
    return all;
}

// Of a link and of a spring.
constexpr OptionHint endOptions[] = {
    {"-body1", body, "the body at its first end", "", "First body"},
    {"-offset1", vector, "three numbers: where, in the first body's frame", "",
     "Place on first body"},
    {"-body2", body, "the body at its other end", "", "Second body"},
    {"-offset2", vector, "three numbers: where, in the second body's frame", "",
     "Place on second body"},
    {"-x", expression, "an expression: x of the point at its other end", "", "Along x"},
    {"-y", expression, "an expression: y of the point", "", "Along y"},
    {"-z", expression, "an expression: z of the point", "", "Along z"},
    {"-trajectory", trajectory, "a trajectory that leads its other end", ""},
};
constexpr OptionHint ownLinkOptions[] = {
    {"-tightness", number, "the force for each unit of distance", ""},
    {"-damping", number, "the force for each unit of velocity; critical by default", ""},
    {"-release", expression, "an expression: the link is gone as soon as it is not 0", "",
     "Released when"},
};
constexpr OptionHint ownSpringOptions[] = {
    {"-stiffness", number, "the force for each unit of length", ""},
    {"-rest", number, "the length without a force; by default the length at the start", "",
     "Length at rest"},
    {"-damping", number, "the force for each unit of velocity along it (0)", ""},
    {"-pull_only", flag, "1: it never pushes, as a bungee", "0", "Only pulls"},
    {"-release", expression, "an expression: the spring is gone as soon as it is not 0", "",
     "Released when"},
};
constexpr auto linkOptions = joined(endOptions, ownLinkOptions);
constexpr auto springOptions = joined(endOptions, ownSpringOptions);
constexpr OptionHint jointOptions[] = {
    {"-type", choice, "what it leaves free",
     "fixed hinge slider cylindrical universal ball planar distance screw"},
    {"-body1", body, "the body that it holds", "", "First body"},
    {"-offset1", vector, "three numbers: where, in the first body's frame; its centre of mass", "",
     "Place on first body"},
    {"-body2", body, "the body that it holds on to; without it, the world", "", "Second body"},
    {"-offset2", vector, "three numbers: where, in the second body's frame", "",
     "Place on second body"},
    {"-axis", vector, "three numbers: a direction in the first body's frame", "", "Axis"},
    {"-axis2", vector, "three numbers: a direction in the second body's frame", "",
     "Axis on second body"},
    {"-pitch", number, "how far a screw slides in one turn; negative: left-handed", ""},
    {"-release", expression, "an expression: the joint is gone as soon as it is not 0", "",
     "Released when"},
    {"-limits", list, "{lo hi}: how far q goes; {} in place of a number: as far as it likes", ""},
    {"-limit_restitution", number, "0: it stops at its limits, 1: it loses nothing there (0)", ""},
    {"-motor", expression, "an expression: a force or couple along q", ""},
    {"-speed", expression, "an expression that the rate of q follows", ""},
    {"-position", expression, "an expression, or a trajectory, that q follows", ""},
    {"-max_motor", number,
     "the most that -speed or -position may take; without it, all that it takes", ""},
    {"-stiffness", number, "the force or couple for each unit of q", ""},
    {"-rest", number, "where the spring of -stiffness does not pull (0)", "", "Rests at"},
    {"-damping", number, "the force or couple for each unit of its rate", ""},
    {"-friction", number, "the most that its dry friction can be", ""},
    {"-from", number, "the value of q where the bodies start (0)", "", "Begins at"},
    {"-limits1", list, "{lo hi}: how far q1 goes; {} in place of a number: as far as it likes", ""},
    {"-limit_restitution1", number, "0: it stops at its limits, 1: it loses nothing there (0)", ""},
    {"-motor1", expression, "an expression: a force or couple along q1", ""},
    {"-speed1", expression, "an expression that the rate of q1 follows", ""},
    {"-position1", expression, "an expression, or a trajectory, that q1 follows", ""},
    {"-max_motor1", number,
     "the most that -speed1 or -position1 may take; without it, all that it takes", ""},
    {"-stiffness1", number, "the force or couple for each unit of q1", ""},
    {"-rest1", number, "where the spring of -stiffness1 does not pull (0)", ""},
    {"-damping1", number, "the force or couple for each unit of its rate", ""},
    {"-friction1", number, "the most that its dry friction can be", ""},
    {"-from1", number, "the value of q1 where the bodies start (0)", ""},
    {"-limits2", list, "{lo hi}: how far q2 goes; {} in place of a number: as far as it likes", ""},
    {"-limit_restitution2", number, "0: it stops at its limits, 1: it loses nothing there (0)", ""},
    {"-motor2", expression, "an expression: a force or couple along q2", ""},
    {"-speed2", expression, "an expression that the rate of q2 follows", ""},
    {"-position2", expression, "an expression, or a trajectory, that q2 follows", ""},
    {"-max_motor2", number,
     "the most that -speed2 or -position2 may take; without it, all that it takes", ""},
    {"-stiffness2", number, "the force or couple for each unit of q2", ""},
    {"-rest2", number, "where the spring of -stiffness2 does not pull (0)", ""},
    {"-damping2", number, "the force or couple for each unit of its rate", ""},
    {"-friction2", number, "the most that its dry friction can be", ""},
    {"-from2", number, "the value of q2 where the bodies start (0)", ""},
    {"-from3", number, "the value of q3 where the bodies start (0)", ""},
};
constexpr OptionHint gearOptions[] = {
    {"-joint1", joint, "the joint that turns by -ratio times the other", "", "First joint"},
    {"-joint2", joint, "the other joint", "", "Second joint"},
    {"-ratio", number, "joint1.q = ratio * joint2.q; not 0", ""},
    {"-joints", expressions, "two or more joints, NAME or NAME.q2", ""},
    {"-ratios", list, "a number for each: the sum of number times q stays", ""},
    {"-release", expression, "an expression: the gear is gone as soon as it is not 0", "",
     "Released when"},
};
constexpr OptionHint ropeOptions[] = {
    {"-points", expressions,
     "{{BODY {offset}} {x y z} ...}; a wheel is {BODY {offset} RADIUS ?AXIS?}", ""},
    {"-length", number, "how long it is; by default what it measures at the start", ""},
    {"-restitution", number, "of the impact when it becomes taut (0)", ""},
    {"-closed", flag, "1: it leads back to its first point, as a belt", "0"},
    {"-release", expression, "an expression: the rope is gone as soon as it is not 0", "",
     "Released when"},
};
constexpr OptionHint contactOptions[] = {
    {"-body1", body, "one of the two bodies that touch", "", "First body"},
    {"-body2", body, "the other one", "", "Second body"},
    {"-friction", number, "Coulomb's coefficient of this pair; by default both bodies' mean", ""},
    {"-static_friction", number, "the same while nothing slides, at least -friction", ""},
    {"-rolling_friction", number, "a length: the couple that resists rolling, over the force", ""},
    {"-restitution", number, "0: it does not bounce, 1: it loses nothing; the bodies' smaller", ""},
    {"-collide", flag, "1: these two may touch whatever joints and -ct say; 0: they never do", "",
     "May touch"},
};
constexpr OptionHint trajectoryOptions[] = {
    {"-points", list, "{{t x y z} ...}: a smooth curve through these", ""},
    {"-bezier", list, "{{t0 t1 {x y z} {x y z} ...} ...}: curves by their control points", "",
     "Control points"},
};
constexpr OptionHint constrainOptions[] = {
    {"-pos", trajectory, "a trajectory that leads its position", "", "Place led by"},
    {"-rot", trajectory, "a trajectory that leads its orientation", "", "Attitude led by"},
    {"-dpos", trajectory, "a trajectory that is its velocity", "", "Velocity led by"},
    {"-drot", trajectory, "a trajectory that is its angular velocity", "",
     "Angular velocity led by"},
    {"-x", trajectory, "a trajectory whose first component is its x", "", "x led by"},
    {"-y", trajectory, "a trajectory whose first component is its y", "", "y led by"},
    {"-z", trajectory, "a trajectory whose first component is its z", "", "z led by"},
    {"-dx", trajectory, "a trajectory whose first component is its velocity along x", "",
     "Velocity led along x"},
    {"-dy", trajectory, "a trajectory whose first component is its velocity along y", "",
     "Velocity led along y"},
    {"-dz", trajectory, "a trajectory whose first component is its velocity along z", "",
     "Velocity led along z"},
    {"-from", number, "the time at which it takes hold", "", "From time"},
    {"-to", number, "the time at which it lets go", "", "To time"},
};
constexpr OptionHint lightOptions[] = {
    {"-direction", vector, "three numbers: where the light goes", ""},
    {"-pos", vector, "three numbers: where it is", "", "Place"},
    {"-color", color, "#rrggbb, a name, or {r g b} from 0 to 1", "", "Colour"},
};
constexpr OptionHint viewOptions[] = {
    {"-pos", vector, "where the centre is on the screen", "", "Place"},
    {"-rot", vector, "a rotation vector: how the scene is turned", "", "Attitude"},
    {"-scale", number, "how large the scene is", ""},
    {"-center", vector, "what is in the middle: three numbers, expressions, or a trajectory", "",
     "Middle"},
    {"-eye", vector, "where the camera stands", ""},
    {"-look", vector, "what it looks at", "", "Looks at"},
    {"-up", vector, "which way is up", "", "Upwards"},
};
constexpr OptionHint parameterOptions[] = {
    {"-value", number, "a number, which sliders change", ""},
    {"-min", number, "the slider's left end", "", "Least"},
    {"-max", number, "the slider's right end", "", "Most"},
    {"-label", text, "what it is called", ""},
    {"-unit", text, "what is shown behind the number", ""},
};
constexpr OptionHint plotOptions[] = {
    {"-values", expressions, "expressions that are drawn against time", "", "Expressions"},
    {"-labels", list, "what they are called", ""},
    {"-title", text, "what stands above", ""},
    {"-beside", flag, "pictures have the values, too, beside what they are of", "0",
     "Beside it in pictures"},
};

constexpr std::array commands = {
    CommandHint{"simulator", "simulator ?options?", "From when to when, and how accurately.", text,
                false, simulatorOptions},
    CommandHint{"shape_set", "shape_set NAME -desc DESC", "A shape, the union of its parts.", text,
                true, shapeOptions},
    CommandHint{"body", "body NAME SHAPE ?options?", "A body that moves.", shapeSet, true,
                bodyOptions},
    CommandHint{"instance", "instance NAME SHAPE ?options?", "A body that moves.", shapeSet, true,
                bodyOptions},
    CommandHint{"force", "force -body B -x E -y E -z E", "A force or torque on a body.", text,
                false, forceOptions},
    CommandHint{"link", "link -body1 B -body2 B -tightness K",
                "A stiff spring that holds a body to a body, a point or a trajectory.", text, false,
                linkOptions},
    CommandHint{"spring", "spring ?NAME? -body1 A -body2 B -stiffness K",
                "A spring between two bodies, or a body and a point.", text, true, springOptions},
    CommandHint{"joint", "joint NAME -type TYPE -body1 A ?-body2 B? ?options?",
                "An exact condition between two bodies, or a body and the world.", text, true,
                jointOptions},
    CommandHint{"gear", "gear NAME -joint1 J -joint2 K -ratio R", "Two joints that turn together.",
                text, true, gearOptions},
    CommandHint{"rope", "rope NAME -points {P P ...} ?-length L?",
                "A rope of fixed length through points and around wheels: it only pulls.", text,
                true, ropeOptions},
    CommandHint{"contact", "contact ?NAME? -body1 A -body2 B ?options?",
                "The friction and restitution of one pair of bodies.", text, true, contactOptions},
    CommandHint{"trajectory", "trajectory NAME -points {{t x y z} ...}", "A path in time.", text,
                true, trajectoryOptions},
    CommandHint{"constrain", "constrain BODY -pos T", "A trajectory leads a body.", body, false,
                constrainOptions},
    CommandHint{"lightsource", "lightsource ?NAME? -direction {x y z}", "A light.", text, true,
                lightOptions},
    CommandHint{"view", "view ?NAME? ?options?", "From where the scene is seen.", text, true,
                viewOptions},
    CommandHint{"parameter", "parameter NAME -value V", "A number with a slider.", text, true,
                parameterOptions},
    CommandHint{"plot", "plot NAME -values {E ...}", "Quantities drawn against time.", text, true,
                plotOptions},
};

} // namespace

std::span<const CommandHint> commandHints() { return commands; }

const CommandHint* hintOf(std::string_view command) {
    for (const CommandHint& hint : commands)
        if (hint.name == command)
            return &hint;
    return nullptr;
}

const CommandHint& hintOf(const scene::Scene& scene, const Element& element) {
    return *hintOf(commandOf(scene, element));
}

std::string captionOf(const OptionHint& option) {
    if (!option.caption.empty())
        return std::string(option.caption);
    std::string caption(option.name.substr(1));
    std::ranges::replace(caption, '_', ' ');
    caption.front() = static_cast<char>(std::toupper(caption.front()));
    return caption;
}

const OptionHint* hintOf(const CommandHint& command, std::string_view option) {
    for (const OptionHint& hint : command.options)
        if (hint.name == option)
            return &hint;
    return nullptr;
}

} // namespace editing

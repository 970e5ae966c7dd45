#include "script/meant.h"

#include "script/commands.h"

#include <algorithm>
#include <cctype>

namespace script {
namespace {

struct Meaning {
    std::string_view words;   // any of these, blanks between them
    std::string_view command; // what is offered, where the language has it ...
    std::string_view offer;
    std::string_view otherwise = {}; // ... and where it has not
};

constexpr Meaning meanings[] = {
    {"hinge pin pivot revolute axle", "joint", "a hinge: joint NAME -type hinge -body1 B",
     "a soft pin: link -body1 B -x 0 -y 0 -z 0 -tightness K"},
    {"rail prismatic track", "joint", "a slider: joint NAME -type slider -body1 B -axis {1 0 0}",
     "constrain holds single coordinates: constrain B -y T"},
    {"slider", "joint",
     "a rail: joint NAME -type slider -body1 B -axis {1 0 0}; for a number "
     "that readers change: parameter NAME -value V -min A -max B",
     "for a number that readers change: parameter NAME -value V -min A -max B"},
    {"weld glue rivet attach connect fix", "joint",
     "joint NAME -type fixed -body1 A -body2 B holds two bodies together",
     "link -body1 A -body2 B -tightness K holds a body to a body, -fixed 1 of a body for ever"},
    {"ball_joint ballsocket socket spherical", "joint", "joint NAME -type ball -body1 A -body2 B",
     "link -body1 A -body2 B -tightness K"},
    {"rod strut", "joint", "a massless rod: joint NAME -type distance -body1 A -body2 B",
     "a body with a shape of -box, held by links"},
    {"motor engine servo actuator", "joint",
     "-motor, -speed and -position are options of a joint: joint NAME -type hinge -body1 B "
     "-speed 2",
     "a couple turns a body: force -body B -torque 1 -z 5"},
    {"cable cord thread chain winch", "rope", "a rope: rope NAME -points {{A {0 0 0}} {0 1 0}}",
     "what pulls and never pushes: spring -body1 A -body2 B -stiffness K -pull_only 1"},
    {"rope", "rope", "",
     "what pulls and never pushes: spring -body1 A -body2 B -stiffness K "
     "-pull_only 1"},
    {"pulley", "rope",
     "a middle point with a radius is a wheel: rope NAME -points {{A {0 0 0}} "
     "{W {0 0 0} 0.2} {B {0 0 0}}}",
     ""},
    {"joint", "joint", "", "a soft pin: link -body1 A -body2 B -tightness K"},
    {"gears gearbox gearing rack", "gear", "gear NAME -joint1 J -joint2 K -ratio R", ""},
    {"bungee elastic rubber", "spring", "spring -body1 A -body2 B -stiffness K -pull_only 1"},
    {"damper dashpot shock", "spring", "spring -body1 A -body2 B -stiffness 0 -damping C"},
    {"gravity gravitation weight gravitational", "force",
     "gravity acts on each body by its own command: force -body B -gravitational {0 -9.81 0}"},
    {"friction", "contact",
     "friction is an option of a body: body B SHAPE -friction 0.3; of one pair: contact -body1 A "
     "-body2 B -friction 0.3"},
    {"restitution bounce elasticity", "body", "it is an option: body B SHAPE -restitution 0.5"},
    {"collide collision collisions", "simulator",
     "bodies collide by themselves; simulator -collisions 0 turns it off"},
    {"torque couple moment", "force", "force -body B -torque 1 -z 5"},
    {"drag wind push pull thrust impulse", "force", "force -body B -x E -y E -z E"},
    {"ball sphere box cube block cuboid cylinder cone capsule tube pipe bowl shape mesh",
     "shape_set", "shapes are shape_set NAME -desc {-sub {-sphere 0.5}}, bodies body NAME SHAPE"},
    {"mass object particle rigid rigid_body rigidbody", "body", "body NAME SHAPE -mass 1"},
    {"floor ground wall table ceiling plane", "body",
     "a body that never moves: body floor SHAPE -fixed 1"},
    {"constraint hold fasten", "constrain", "constrain BODY -pos TRAJECTORY"},
    {"path curve spline motion", "trajectory", "trajectory NAME -points {{t x y z} ...}"},
    {"camera eye look", "view", "view -eye {0 0 10} -look {0 0 0}"},
    {"light lamp sun", "lightsource", "lightsource -direction {x y z}"},
    {"graph chart diagram", "plot", "plot NAME -values {B.x B.y}"},
    {"simulate simulation run play duration time start finish accuracy step", "simulator",
     "simulator -finish 10 -accuracy 1e-6"},
    {"variable number const constant", "parameter",
     "set NAME VALUE, or with a slider: parameter NAME -value V -min A -max B"}};

struct OptionMeaning {
    std::string_view words;  // any of these, without "-" or "-init_"
    std::string_view option; // what is offered, where there is such an option
    std::string_view offer;
};

constexpr OptionMeaning optionMeanings[] = {
    {"velocity vel speed linear_velocity linvel v v0", "-init_dpos",
     "the velocity is -init_dpos {vx vy vz}"},
    {"spin omega angular_velocity angvel angular_vel w", "-init_drot",
     "the angular velocity is -init_drot {wx wy wz}"},
    {"position pos place at location centre center", "-init_pos", "the place is -init_pos {x y z}"},
    {"rotation rot orientation attitude angle angles", "-init_rot",
     "the attitude is -init_rot {x y z}, a rotation vector"},
    {"weight m", "-mass", "the mass is -mass"},
    {"bounce bounciness elasticity e", "-restitution", "the bounce is -restitution E, from 0 to 1"},
    {"mu coefficient_of_friction", "-friction", "the coefficient is -friction"},
    {"static immovable anchored", "-fixed", "a body that never moves has -fixed 1"},
    {"k spring_constant constant", "-stiffness", "a spring's constant is -stiffness"},
    {"length rest_length l0", "-rest", "the length without force is -rest"}};

bool has(std::string_view words, std::string_view word) {
    for (std::size_t from = 0; from < words.size();) {
        const std::size_t to = std::min(words.find(' ', from), words.size());
        if (words.substr(from, to - from) == word)
            return true;
        from = to + 1;
    }
    return false;
}

} // namespace

std::string meantBy(std::string_view command) {
    std::string word(command);
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    // Several of a kind: "hinges".
    const std::string single = word.ends_with('s') ? word.substr(0, word.size() - 1) : word;
    for (const Meaning& meaning : meanings)
        if (has(meaning.words, word) || has(meaning.words, single))
            return std::string(isSceneCommand(meaning.command) ? meaning.offer : meaning.otherwise);
    return "";
}

std::vector<std::string> meantWords() {
    std::vector<std::string> words;
    for (const Meaning& meaning : meanings)
        for (std::size_t from = 0; from < meaning.words.size();) {
            const std::size_t to = std::min(meaning.words.find(' ', from), meaning.words.size());
            words.emplace_back(meaning.words.substr(from, to - from));
            from = to + 1;
        }
    return words;
}

std::string meantByOption(std::string_view option, std::span<const std::string> existing) {
    std::string_view word = option;
    for (const std::string_view beginning : {"-init_", "-"})
        if (word.starts_with(beginning)) {
            word.remove_prefix(beginning.size());
            break;
        }
    for (const OptionMeaning& meaning : optionMeanings)
        if (has(meaning.words, word) &&
            std::ranges::find(existing, meaning.option) != existing.end())
            return std::string(meaning.offer);
    return "";
}

} // namespace script

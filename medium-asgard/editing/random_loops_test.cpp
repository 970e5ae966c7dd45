// Random loops and procedures, random wishes of what they make: each offer is evaluated, and the
// scene is what it said, with the same elements and nothing else changed.
//
// ASGARD_LOOPS sets how many (200 otherwise), ASGARD_SEED where they begin.
#include "editing/test_reading.h"
#include "editing/value_edit.h"

#include <cstdlib>
#include <random>

namespace editing {
namespace {

using geometry::Vector;

class RandomLoops : public testing::Test {
protected:
    static unsigned setting(const char* name, unsigned otherwise) {
        const char* text = std::getenv(name);
        return text ? static_cast<unsigned>(std::atoi(text)) : otherwise;
    }
    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
    }
    std::string any(const std::vector<std::string>& of) { return of[below(of.size())]; }
    std::string number() {
        return any({"1", "2", "3", "-2", "0.5", "2.0", "-1.50", "4", "10", "0"});
    }
    std::string component();
    std::string position() { return component() + " " + component() + " " + component(); }
    std::string statements();
    std::string loop();
    std::string text();
    Wish wishOf(const scene::Scene& scene, std::size_t body);
    std::vector<Wish> pushOf(const scene::Scene& scene, std::size_t force);
    void check(const std::string& text, const std::shared_ptr<const scene::Scene>& before,
               const Wish& wish, const Offer& offer);
    void checkForce(const std::string& text, const std::shared_ptr<const scene::Scene>& before,
                    const std::vector<Wish>& wishes, const Offer& offer);

    std::mt19937 random_{setting("ASGARD_SEED", 20261120U)};
    int offered_ = 0, loopsOffered_ = 0, forcesOffered_ = 0;
};

std::string RandomLoops::component() {
    return any(
        {number(), "$x", "$x", "${x}", "$h", "[expr {$x * " + number() + "}]",
         "[expr {" + number() + " + $x}]", "[expr {" + number() + " - $x}]",
         "[expr {$x / " + any({"2", "-2", "4.0", "0.5"}) + "}]", "[expr $x*" + number() + "]",
         "[expr {($x - " + number() + ") * " + number() + " + $h}]", "[expr {2 ** $x}]",
         "[expr {abs($x) + " + number() + "}]", "$h", "[incr q]", "[twice $x]", "[expr {$x % 3}]"});
}

// What a loop does for each value; the bodies' names are n, or of x, or counted.
std::string RandomLoops::statements() {
    const std::string name = any({"$n", "$n", "b$x", "b[incr c]", "b${n}z"});
    std::string all;
    if (below(12) == 0)
        all += "peek; ";
    if (below(8) == 0)
        all += any({"set x [expr {$x * 2}]", "incr c", "set y $x", "set h 2"}) + "; ";
    all += "body " + name + " s -init_pos \"" + position() + "\"";
    if (below(6) == 0)
        all += " -init_dpos \"" + position() + "\"";
    if (below(3) == 0)
        all += "; force -body " + name + " -x " + component() + " -y " + component() + " -z 1";
    if (below(8) == 0)
        all += "; " + any({"body e[incr k] s -init_pos \"$x 1 9\"", "incr x 0", "set y $x",
                           "lightsource -pos \"$x 0 0\""});
    return all;
}

std::string RandomLoops::loop() {
    std::string list;
    const std::size_t count = 2 + below(3);
    const std::string prefix = any({"u", "v", "w"}) + std::to_string(below(1000));
    for (std::size_t i = 0; i < count; ++i)
        list += (i > 0 ? " " : "") + prefix + std::to_string(i) + " " + number();
    switch (below(5)) {
    case 0:
        return "set xs {" + list + "}\nforeach {n x} $xs {" + statements() + "}\n";
    case 1: {
        const std::string step = any({"", " 2", " 3", " -1"});
        return "for {set x " + any({"0", "1"}) + "} {$x " +
               (step == " -1" ? ">" : any({"<", "<="})) +
               (step == " -1" ? " -3" : any({" 4", " 5", " 6"})) + "} {incr x" + step +
               "} {set n " + prefix + "$x; " + statements() + "}\n";
    }
    case 2: {
        std::string calls = "proc put {n x} {global h; " + statements() + "}\n";
        for (std::size_t i = 0; i < count; ++i)
            calls += "put " + prefix + std::to_string(i) + " " + number() + "\n";
        return calls;
    }
    default:
        return "foreach {n x} {" + list + "} {" + statements() + "}\n";
    }
}

std::string RandomLoops::text() {
    std::string text = "shape_set s -desc {-sub {-sphere 1}}\nset h 2\nset q 0\nset x 1\n"
                       "proc twice {v} {expr {2 * $v}}\n";
    const std::string loops = loop();
    if (loops.find("peek") != std::string::npos)
        text += "proc peek {} {uplevel 1 {body p[incr p] s -init_pos \"$x 7 0\"}}\n";
    text += loops;
    if (below(3) == 0)
        text += loop();
    if (below(5) == 0)
        text += "body last s -init_pos \"" + any({"$x 3 3", "3 $h 3", "3 3 3"}) + "\"\n";
    return text;
}

Wish RandomLoops::wishOf(const scene::Scene& scene, std::size_t body) {
    const Vector& now = scene.bodies[body].initialPosition;
    Wish wish{.element = {Kind::body, body}, .option = "-init_pos", .path = {}, .values = {}};
    wish.now = wish.values = {now.x(), now.y(), now.z()};
    wish.resolution = below(2) == 0 ? 0 : 0.01;
    const std::size_t only = below(4); // 3: all of them
    for (std::size_t i = 0; i < 3; ++i)
        if (only == i || only == 3)
            wish.values[i] += (below(2) == 0 ? 1 : -1) * static_cast<double>(1 + below(16)) / 4;
    return wish;
}

void RandomLoops::check(const std::string& text, const std::shared_ptr<const scene::Scene>& before,
                        const Wish& wish, const Offer& offer) {
    SCOPED_TRACE(text + offer.label + " of " + before->bodies[wish.element.index].name + "\n" +
                 text::applied(text, offer.edits));
    const auto after = readScene(text::applied(text, offer.edits));
    ASSERT_EQ(after->bodies.size(), before->bodies.size());
    ASSERT_EQ(after->lights.size(), before->lights.size());
    ++offered_;
    const bool isOfTheLoop = offer.label.find(", in ") != std::string::npos ||
                             offer.label.ends_with("by as much") ||
                             offer.label.starts_with("The step");
    loopsOffered_ += isOfTheLoop ? 1 : 0;
    const bool roughly =
        offer.label.ends_with("in common") || offer.label.starts_with("The step of the loop");
    const bool alone = offer.label.starts_with("Only");
    const scene::Range command = before->bodies[wish.element.index].source.command;
    for (std::size_t i = 0; i < after->bodies.size(); ++i) {
        const scene::Body &is = after->bodies[i], &was = before->bodies[i];
        ASSERT_EQ(is.name, was.name);
        ASSERT_EQ(is.initialVelocity, was.initialVelocity);
        const bool its = i == wish.element.index;
        if (alone ? !its : !(was.source.command == command)) {
            ASSERT_LT((is.initialPosition - was.initialPosition).norm(), 1e-9) << was.name;
        }
        for (std::size_t k = 0; its && !roughly && k < 3; ++k)
            ASSERT_NEAR(is.initialPosition[static_cast<Eigen::Index>(k)], wish.values[k],
                        1.0001 * wish.resolution + 1e-8 * std::max(1.0, std::abs(wish.values[k])));
    }
    for (std::size_t i = 0; i < after->lights.size(); ++i)
        ASSERT_EQ(after->lights[i].position, before->lights[i].position);
}

double componentOf(const scene::Scene& scene, std::size_t force, std::size_t which) {
    return std::stod(std::get<scene::ComponentForce>(scene.forces[force].kind).components[which]);
}

// All three at once, as a picture asks for them.
std::vector<Wish> RandomLoops::pushOf(const scene::Scene& scene, std::size_t force) {
    std::vector<Wish> wishes;
    const std::size_t only = below(3); // 2: both
    for (std::size_t k = 0; k < 3; ++k) {
        const double now = componentOf(scene, force, k);
        const bool changes = k < 2 && (only == k || only == 2);
        wishes.push_back(
            {.element = {Kind::force, force},
             .option = std::string("-") + "xyz"[k],
             .path = {},
             .values = {now + (changes ? 0.25 * static_cast<double>(1 + below(9)) : 0)},
             .resolution = 0.01,
             .absent = {now},
             .now = {now}});
    }
    return wishes;
}

void RandomLoops::checkForce(const std::string& text,
                             const std::shared_ptr<const scene::Scene>& before,
                             const std::vector<Wish>& wishes, const Offer& offer) {
    SCOPED_TRACE(text + offer.label + "\n" + text::applied(text, offer.edits));
    const auto after = readScene(text::applied(text, offer.edits));
    ASSERT_EQ(after->bodies.size(), before->bodies.size());
    ASSERT_EQ(after->forces.size(), before->forces.size());
    ++forcesOffered_;
    for (std::size_t i = 0; i < after->bodies.size(); ++i) {
        ASSERT_EQ(after->bodies[i].name, before->bodies[i].name);
        ASSERT_EQ(after->bodies[i].initialPosition, before->bodies[i].initialPosition);
    }
    const std::size_t its = wishes.front().element.index;
    const scene::Range command = before->forces[its].source.command;
    for (std::size_t i = 0; i < after->forces.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const double is = componentOf(*after, i, k), was = componentOf(*before, i, k);
            if (offer.label.starts_with("Only") ? i != its
                                                : !(before->forces[i].source.command == command)) {
                ASSERT_NEAR(is, was, 1e-9);
            }
            if (i == its && !offer.label.ends_with("in common") &&
                !offer.label.starts_with("The step of the loop")) {
                ASSERT_NEAR(is, wishes[k].values[0], 0.0101);
            }
        }
}

TEST_F(RandomLoops, OffersAreWhatTheTextThenGives) {
    const unsigned count = setting("ASGARD_LOOPS", 200);
    unsigned usable = 0;
    for (unsigned i = 0; i < count && !HasFatalFailure(); ++i) {
        const std::string text = this->text();
        const auto result = reader().read(text);
        if (!result.usable || result.scene.bodies.empty())
            continue; // two of a name, a sign twice
        ++usable;
        const auto scene = std::make_shared<const scene::Scene>(result.scene);
        const Mapper mapper(text, scene);
        for (int k = 0; k < 2 && !HasFatalFailure(); ++k) {
            const Wish wish = wishOf(*scene, below(scene->bodies.size()));
            const Answer answer = mapper.answer(wish);
            for (const Offer& offer : answer.offers)
                if (!HasFatalFailure())
                    check(text, scene, wish, offer);
        }
        if (scene->forces.empty() || HasFatalFailure())
            continue;
        const auto wishes = pushOf(*scene, below(scene->forces.size()));
        const Answer answer = mapper.answer(wishes);
        for (const Offer& offer : answer.offers)
            if (!HasFatalFailure())
                checkForce(text, scene, wishes, offer);
    }
    EXPECT_GT(usable, count / 8);
    EXPECT_GT(offered_, static_cast<int>(count / 8));
    EXPECT_GT(forcesOffered_, 0);
    EXPECT_GT(loopsOffered_, static_cast<int>(count / 40));
    RecordProperty("offered", std::to_string(offered_));
    RecordProperty("ofLoops", std::to_string(loopsOffered_));
    RecordProperty("ofForces", std::to_string(forcesOffered_));
}

} // namespace
} // namespace editing

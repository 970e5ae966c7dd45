// Random gestures on scenes as authors write them: bytes outside what is meant stay, what cannot be
// rewritten is refused with a reason, and what is written means what was wished.
//
// ASGARD_GRAPHICAL_EDITS sets how many (20,000 otherwise), ASGARD_SEED where they begin. One in a
// hundred is read by the real evaluator.
#include "editing/random_corpus.h"
#include "editing/test_reading.h"
#include "element_edits/creation.h"
#include "element_edits/deletion.h"
#include "point_edits/trajectory_edit.h"

#include "expression/parse.h"
#include "script/numbers.h"

#include <cstdlib>
#include <random>

namespace editing {
namespace {

using geometry::Vector;

std::vector<double> listed(const Vector& v) { return {v.x(), v.y(), v.z()}; }

// A force's component, where it does not change.
std::optional<double> valueOf(const scene::Scene& scene, const std::string& text) {
    expression::Graph graph;
    const auto parsed =
        expression::parse(graph, text,
                          [&](expression::Graph& g, std::string_view name,
                              std::span<const expression::Node>, bool) -> expression::Meaning {
                              for (const scene::Parameter& parameter : scene.parameters)
                                  if (parameter.name == name)
                                      return {g.constant(parameter.value), "", ""};
                              for (const scene::Body& body : scene.bodies)
                                  if (body.mass && body.name + ".mass" == name)
                                      return {g.constant(*body.mass), "", ""};
                              return {std::nullopt, "changes", ""};
                          });
    const auto* node = std::get_if<expression::Node>(&parsed);
    if (!node || graph.op(*node) != expression::Op::constant)
        return std::nullopt;
    return graph.value(*node);
}

// What an option of an element is now, as the pictures know it; none: that it changes.
using Values = std::optional<std::vector<double>>;

Values ofComponents(const scene::Scene& scene, const std::array<std::string, 3>& components,
                    const std::string& option) {
    const auto value = valueOf(scene, components[static_cast<std::size_t>(option[1] - 'x')]);
    return value ? Values(std::vector<double>{*value}) : std::nullopt;
}

Values valuesOf(const scene::Scene& scene, const Element& element, const std::string& option,
                const std::vector<std::size_t>& path) {
    const std::size_t i = element.index;
    const Vector none = Vector::Zero();
    if (element.kind == Kind::body) {
        const scene::Body& body = scene.bodies[i];
        return listed(option == "-init_pos"    ? body.initialPosition
                      : option == "-init_dpos" ? body.initialVelocity
                                               : body.initialAngularVelocity);
    }
    if (element.kind == Kind::force) {
        const scene::Force& force = scene.forces[i];
        if (option == "-offset")
            return listed(force.offset.value_or(none));
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind))
            return listed(weight->acceleration);
        return ofComponents(scene, std::get<scene::ComponentForce>(force.kind).components, option);
    }
    if (element.kind == Kind::link) {
        const scene::Link& link = scene.links[i];
        if (option == "-offset1")
            return listed(link.first.offset.value_or(none));
        return ofComponents(scene, std::get<scene::PointEnd>(link.second).coordinates, option);
    }
    if (element.kind == Kind::light)
        return listed(*(option == "-pos" ? scene.lights[i].position : scene.lights[i].direction));
    if (element.kind == Kind::parameter)
        return std::vector<double>{scene.parameters[i].value};
    const scene::Trajectory& trajectory = scene.trajectories[i];
    if (trajectory.points.empty())
        return listed(trajectory.curves[path[0]].control[path[1] - 2]);
    const auto& [time, place] = trajectory.points[path[0]];
    return std::vector<double>{time, place.x(), place.y(), place.z()};
}

struct Read {
    CorpusScene from;
    std::shared_ptr<const scene::Scene> scene;
    std::unique_ptr<Mapper> mapper;
    std::vector<Element> elements;
};

class RandomEdits : public testing::Test {
protected:
    static long setting(const char* name, long otherwise) {
        const char* text = std::getenv(name);
        return text ? std::atol(text) : otherwise;
    }
    void SetUp() override {
        for (const CorpusScene& one : corpus())
            scenes_.push_back(readAll(one));
    }
    static Read readAll(const CorpusScene& from) {
        Read read{from, readScene(from.text), nullptr, {}};
        read.mapper = std::make_unique<Mapper>(
            from.text, read.scene,
            [scene = read.scene](const std::string& name) { return valueOf(*scene, name); });
        for (const Kind kind :
             {Kind::body, Kind::force, Kind::link, Kind::light, Kind::parameter, Kind::trajectory})
            for (std::size_t i = 0; sourceOf(*read.scene, {kind, i}); ++i)
                read.elements.push_back({kind, i});
        return read;
    }
    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
    }
    double number(double size) {
        return std::uniform_real_distribution<double>(-size, size)(random_);
    }

    Wish wishFor(const Read& read, const Element& element);
    void changeValue(const Read& read, bool evaluate);
    void keepsItsWord(const Read& read, const Wish& wish, const std::string& label,
                      const std::string& offered);
    void create(const Read& read, bool evaluate);
    void remove(const Read& read, bool evaluate);
    void changePoints(const Read& read, bool evaluate);

    std::mt19937_64 random_{static_cast<std::uint64_t>(setting("ASGARD_SEED", 1))};
    std::vector<Read> scenes_;
    long changed_ = 0, refused_ = 0, evaluated_ = 0, kept_ = 0;
};

Wish RandomEdits::wishFor(const Read& read, const Element& element) {
    Wish wish;
    wish.element = element;
    const scene::Scene& scene = *read.scene;
    const auto one = [&](std::vector<std::string> options) {
        return options[below(options.size())];
    };
    if (element.kind == Kind::body) {
        wish.option = one({"-init_pos", "-init_dpos", "-init_drot"});
    } else if (element.kind == Kind::force) {
        const bool weight =
            std::holds_alternative<scene::GravitationalForce>(scene.forces[element.index].kind);
        wish.option =
            weight ? one({"-gravitational", "-offset"}) : one({"-x", "-y", "-z", "-offset"});
    } else if (element.kind == Kind::link) {
        wish.option = one({"-offset1", "-x", "-y", "-z"});
    } else if (element.kind == Kind::light) {
        wish.option = one({"-pos", "-direction"});
    } else if (element.kind == Kind::parameter) {
        wish.option = "-value";
    } else {
        const scene::Trajectory& trajectory = scene.trajectories[element.index];
        wish.option = trajectory.points.empty() ? "-bezier" : "-points";
        if (trajectory.points.empty()) {
            const std::size_t curve = below(trajectory.curves.size());
            wish.path = {curve, 2 + below(trajectory.curves[curve].control.size())};
        } else {
            wish.path = {below(trajectory.points.size())};
        }
    }
    const Values now = valuesOf(scene, element, wish.option, wish.path);
    wish.now = wish.absent = now.value_or(std::vector<double>());
    wish.values = now.value_or(std::vector<double>{0});
    constexpr double steps[] = {0, 1, 0.1, 0.01, 1e-4};
    wish.resolution = steps[below(std::size(steps))];
    const bool timed = wish.option == "-points";
    for (std::size_t i = timed ? 1 : 0; i < wish.values.size(); ++i) // always another number
        wish.values[i] += (below(2) == 0 ? 1 : -1) * (2 + std::abs(number(50)));
    return wish;
}

// What an offer says is what the text then gives: the same elements, the value, and with "Only"
// nothing else.
void RandomEdits::keepsItsWord(const Read& read, const Wish& wish, const std::string& label,
                               const std::string& offered) {
    const auto after = readScene(offered);
    ASSERT_EQ(after->bodies.size(), read.scene->bodies.size()) << label << "\n" << offered;
    ASSERT_EQ(after->forces.size(), read.scene->forces.size()) << label << "\n" << offered;
    for (std::size_t i = 0; i < after->bodies.size(); ++i) {
        const scene::Body &is = after->bodies[i], &was = read.scene->bodies[i];
        ASSERT_EQ(is.name, was.name) << label << "\n" << offered;
        if (label.starts_with("Only") && !(wish.element == Element{Kind::body, i})) {
            ASSERT_EQ(is.initialPosition, was.initialPosition) << label << "\n" << offered;
            ASSERT_EQ(is.initialVelocity, was.initialVelocity) << label << "\n" << offered;
        }
    }
    if (label.ends_with("in common") || label.starts_with("The step of the loop"))
        return;
    const Values is = valuesOf(*after, wish.element, wish.option, wish.path);
    ASSERT_TRUE(is) << label << "\n" << offered;
    for (std::size_t k = 0; k < wish.values.size(); ++k)
        ASSERT_NEAR((*is)[k], wish.values[k],
                    1.0001 * wish.resolution + 1e-9 * std::max(1.0, std::abs(wish.values[k])))
            << label << "\n"
            << offered;
    ++kept_;
}

// Where the numbers of an option are written as such, or those of the parameter that it names;
// none: variables or commands make them.
std::optional<scene::Range> writtenAt(const std::string& text, const scene::Scene& scene,
                                      const scene::Source& source, const std::string& option) {
    std::optional<scene::Range> found;
    for (const scene::Argument& argument : source.arguments)
        if (argument.option == option)
            found = argument.word;
    if (!found || !found->known() ||
        text.substr(found->from, found->to - found->from).find_first_of("$[\\") !=
            std::string::npos)
        return std::nullopt;
    const std::string written = text.substr(found->from, found->to - found->from);
    for (const scene::Parameter& parameter : scene.parameters)
        if (written == parameter.name || written == "{" + parameter.name + "}")
            return writtenAt(text, scene, parameter.source, "-value");
    return found;
}

// Every edit rewrites one number, the one that is meant, or puts an option behind a command.
void RandomEdits::changeValue(const Read& read, bool evaluate) {
    const std::string& text = read.from.text;
    const Element element = read.elements[below(read.elements.size())];
    const Wish wish = wishFor(read, element);
    const Answer answer = read.mapper->answer(wish);
    const std::string who = describe(*read.scene, element);
    if (read.from.oneNumberTwice.contains(who + " " + wish.option) &&
        std::abs(wish.values[0] - wish.values[1]) <= wish.resolution)
        return;
    const bool readOnly =
        read.from.readOnly.contains(who) || read.from.readOnly.contains(who + " " + wish.option);
    ASSERT_EQ(answer.possible(), !readOnly)
        << who << " " << wish.option << ": " << answer.reason << "\n"
        << text;
    if (readOnly) {
        ++refused_;
        ASSERT_TRUE(answer.edits.empty());
        ASSERT_GT(answer.reason.size(), who.size());
        for (const Offer& offer : answer.offers) {
            ASSERT_FALSE(offer.edits.empty());
            const std::string offered = text::applied(text, offer.edits);
            ASSERT_NE(offered, text);
            if (evaluate)
                keepsItsWord(read, wish, offer.label, offered);
        }
        return;
    }
    ++changed_;
    const scene::Source& source = *sourceOf(*read.scene, element);
    std::size_t last = 0;
    for (const text::Edit& edit : answer.edits) {
        ASSERT_GE(edit.range.from, last);
        last = edit.range.to;
        if (edit.range.empty()) {
            ASSERT_EQ(edit.range.from, source.command.to);
            ASSERT_TRUE(edit.text.starts_with(" " + wish.option + " "));
        } else {
            ASSERT_TRUE(script::decimalNumber(text.substr(edit.range.from, edit.range.size())));
            ASSERT_TRUE(script::decimalNumber(edit.text)) << edit.text;
            if (const auto word = writtenAt(text, *read.scene, source, wish.option)) {
                ASSERT_TRUE(word->from <= edit.range.from && edit.range.to <= word->to)
                    << who << " " << wish.option << ": " << edit.range.from << "\n"
                    << text;
            }
        }
    }
    ASSERT_FALSE(answer.edits.empty());
    if (!evaluate)
        return;
    ++evaluated_;
    const auto after = readScene(text::applied(text, answer.edits));
    const Values is = valuesOf(*after, element, wish.option, wish.path);
    ASSERT_TRUE(is);
    for (std::size_t i = 0; i < wish.values.size(); ++i)
        ASSERT_NEAR((*is)[i], wish.values[i],
                    0.5001 * wish.resolution + 1e-12 * std::abs(wish.values[i]))
            << text::applied(text, answer.edits);
}

void RandomEdits::create(const Read& read, bool evaluate) {
    const std::string& text = read.from.text;
    const scene::Scene& scene = *read.scene;
    constexpr Kind kinds[] = {Kind::body,  Kind::force,      Kind::link,
                              Kind::light, Kind::trajectory, Kind::parameter};
    const Kind kind = kinds[below(std::size(kinds))];
    NewElement element{kind, "", {}, {}};
    if (kind == Kind::body) {
        element.shape = scene.shapeSets[0].name;
        element.behind = {{Kind::shapeSet, 0}};
    } else if (kind == Kind::force || kind == Kind::link) {
        const std::size_t body = below(scene.bodies.size());
        element.behind = {{Kind::body, body}};
        element.words = kind == Kind::force
                            ? std::vector<std::string>{"-body", scene.bodies[body].name, "-y", "1"}
                            : std::vector<std::string>{"-body1",     scene.bodies[body].name,
                                                       "-x",         "0",
                                                       "-y",         "0",
                                                       "-z",         "1",
                                                       "-tightness", "10"};
    } else if (kind == Kind::light) {
        element.words = {"-pos", "{1 2 3}"};
    } else if (kind == Kind::trajectory) {
        element.words = {"-points", "{{0 0 0 0} {1 1 1 1}}"};
    } else {
        element.words = {"-value", "1"};
    }
    if (kind != Kind::force && kind != Kind::link)
        element.name = unusedName(text, scene, kind, "n");
    const text::Edits edits = created(text, scene, {element});
    ASSERT_EQ(edits.size(), 1U);
    ASSERT_TRUE(edits[0].range.empty()); // put in: nothing else changes
    ++changed_;
    if (!evaluate)
        return;
    ++evaluated_;
    const auto after = readScene(text::applied(text, edits));
    for (const Kind one : kinds)
        for (std::size_t i = 0;; ++i) {
            const bool had = sourceOf(scene, {one, i}), has = sourceOf(*after, {one, i});
            if (!had) {
                ASSERT_EQ(has, one == kind) << text::applied(text, edits);
                break;
            }
            ASSERT_EQ(nameOf(scene, {one, i}), nameOf(*after, {one, i}));
        }
}

void RandomEdits::remove(const Read& read, bool evaluate) {
    const std::string& text = read.from.text;
    const scene::Scene& scene = *read.scene;
    const Element element = read.elements[below(read.elements.size())];
    const Deletion deletion = deletionOf(text, scene, {element});
    if (!deletion.possible()) {
        ++refused_;
        ASSERT_TRUE(deletion.edits.empty());
        ASSERT_GT(deletion.reason.size(), 10U);
        return;
    }
    ++changed_;
    std::size_t last = 0;
    for (const text::Edit& edit : deletion.edits) {
        ASSERT_TRUE(edit.text.empty());
        ASSERT_GE(edit.range.from, last);
        last = edit.range.to;
    }
    if (!evaluate)
        return;
    ++evaluated_;
    const std::string after = text::applied(text, deletion.edits);
    const auto left = readScene(after);
    // All the others are there, and only they.
    std::vector<Element> gone = deletion.along;
    gone.push_back(element);
    for (const Kind one : {Kind::body, Kind::force, Kind::link, Kind::constraint, Kind::light,
                           Kind::trajectory, Kind::plot}) {
        std::vector<std::string> expected, found;
        for (std::size_t i = 0; sourceOf(scene, {one, i}); ++i)
            if (std::ranges::find(gone, Element{one, i}) == gone.end())
                expected.push_back(nameOf(scene, {one, i}));
        for (std::size_t i = 0; sourceOf(*left, {one, i}); ++i)
            found.push_back(nameOf(*left, {one, i}));
        ASSERT_EQ(found, expected) << after;
    }
}

// A point put in where there was none, or one taken out.
void RandomEdits::changePoints(const Read& read, bool evaluate) {
    const scene::Scene& scene = *read.scene;
    if (scene.trajectories.empty())
        return;
    const std::string& text = read.from.text;
    const std::size_t which = below(scene.trajectories.size());
    const TrajectoryEdits edits(text, read.scene, which);
    const bool in = below(2) == 0;
    const auto& points = edits.points();
    const Answer answer =
        in ? edits.add(points.front().time + 0.01 + (points.back().time + 1) * std::abs(number(1)),
                       {number(9), number(9), 0})
           : edits.remove(below(points.size()));
    if (!answer.possible()) {
        ++refused_;
        ASSERT_TRUE(answer.edits.empty());
        return;
    }
    ++changed_;
    ASSERT_FALSE(answer.edits.empty());
    if (!evaluate)
        return;
    ++evaluated_;
    const auto after = readScene(text::applied(text, answer.edits));
    const TrajectoryEdits now(text::applied(text, answer.edits), after, which);
    ASSERT_NE(now.points().size(), points.size());
    ASSERT_EQ(now.points().size() > points.size(), in);
}

TEST_F(RandomEdits, LeaveAllOtherBytesAndMeanWhatWasWished) {
    const long count = setting("ASGARD_GRAPHICAL_EDITS", 20000);
    for (long i = 0; i < count && !HasFatalFailure(); ++i) {
        const Read& read = scenes_[below(scenes_.size())];
        const bool evaluate = i % 100 == 0;
        SCOPED_TRACE(i);
        switch (below(10)) {
        case 0:
            create(read, evaluate);
            break;
        case 1:
            remove(read, evaluate);
            break;
        case 2:
            changePoints(read, evaluate);
            break;
        default:
            changeValue(read, evaluate);
        }
    }
    EXPECT_GT(changed_, count / 3);
    EXPECT_GT(refused_, count / 20);
    EXPECT_GT(evaluated_, count / 300);
    EXPECT_GT(kept_, count / 1500);
    RecordProperty("changed", std::to_string(changed_));
    RecordProperty("refused", std::to_string(refused_));
    RecordProperty("evaluated", std::to_string(evaluated_));
}

// Text edited again and again: what a gesture leaves is as good as what an author wrote.
TEST_F(RandomEdits, GoOnFromWhatTheyLeave) {
    const long count = setting("ASGARD_GRAPHICAL_EDITS", 20000) / 400;
    for (const CorpusScene& one : corpus()) {
        Read read = readAll(one);
        for (long i = 0; i < count / 7 + 3 && !HasFatalFailure(); ++i) {
            const Element element = read.elements[below(read.elements.size())];
            const Wish wish = wishFor(read, element);
            const Answer answer = read.mapper->answer(wish);
            const bool create = below(3) == 0;
            const text::Edits edits =
                create ? created(read.from.text, *read.scene,
                                 {{Kind::body,
                                   unusedName(read.from.text, *read.scene, Kind::body, "n"),
                                   {},
                                   {{Kind::shapeSet, 0}},
                                   read.scene->shapeSets[0].name}})
                       : answer.edits;
            const std::size_t bodies = read.scene->bodies.size();
            read = readAll({text::applied(read.from.text, edits), one.readOnly});
            ASSERT_EQ(read.scene->bodies.size(), bodies + (create ? 1 : 0)) << read.from.text;
            if (create || !answer.possible())
                continue;
            const Values is = valuesOf(*read.scene, element, wish.option, wish.path);
            ASSERT_TRUE(is) << read.from.text;
            for (std::size_t k = 0; k < wish.values.size(); ++k)
                ASSERT_NEAR((*is)[k], wish.values[k],
                            0.5001 * wish.resolution + 1e-12 * std::abs(wish.values[k]))
                    << read.from.text;
        }
    }
}

} // namespace
} // namespace editing

// Alike components are one model; what is made once stays made. Counts, not times.
#include "equations/component_model.h"

#include "solution/solver_testing.h"

#include <gmock/gmock.h>

using namespace solution;
using namespace solution::testing;
using ::testing::ElementsAre;

namespace {

std::string number(double value) { return std::to_string(value); }

// Pendulums with their own length, push and place.
std::vector<Line> pendulums(std::size_t count) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string name = "p" + std::to_string(i);
        const double own = 3.1415 + 0.013 * static_cast<double>(i);
        lines.push_back({name, "d" + name, 0.5 + 0.001 * static_cast<double>(i), 1});
        lines.push_back({"d" + name,
                         "-" + number(own) + "*sin(" + name + "-" + number(own / 7) + ")+" +
                             number(own / 3) + "*cos(t)",
                         0});
    }
    return lines;
}

std::shared_ptr<const PreparedEquations> prepared(const expression::EquationSet& set,
                                                  std::shared_ptr<ComponentModels> models = {}) {
    return std::make_shared<const PreparedEquations>(
        std::make_shared<const expression::EquationSet>(set),
        Preparation{.start = 0, .whole = false, .everyState = false, .models = std::move(models)});
}

} // namespace

TEST(ComponentModel, IsTheEquationsWithoutNamesAndNumbers) {
    const auto all = prepared(
        equationsOf({{"x", "v", 1, 1}, {"v", "-4.5*x+4.5*sin(w)-v^3", 0}, {"w", "w*0.3", 1}}));
    std::vector<std::string> texts;
    for (const auto& component : all->components)
        texts.push_back(component.bound->model->print());
    EXPECT_THAT(texts, ElementsAre("y0' = c0*y0\n", "y0' = y1\ny1' = c1*y0 + c0*sin(u0) - y1^3\n"));
    EXPECT_THAT(all->components[0].bound->constants, ElementsAre(0.3));
    EXPECT_THAT(all->components[1].bound->inputs, ElementsAre(2));
}

TEST(ComponentModel, IsOneForAThousandAlikeComponents) {
    const auto all = prepared(equationsOf(pendulums(1000)));
    EXPECT_EQ(all->partition.components.size(), 1000u);
    EXPECT_EQ(all->how.models->made(), 1u);
}

TEST(ComponentModel, IsFoundAgainInEquationsThatWereMadeAnew) {
    const auto models = std::make_shared<ComponentModels>();
    const auto first = prepared(equationsOf(pendulums(10)), models);
    std::vector<Line> lines = pendulums(12);
    lines.push_back({"x", "-x+sin(x)", 1});
    const auto second = prepared(equationsOf(lines), models);
    EXPECT_EQ(models->made(), 2u);
    EXPECT_EQ(first->components[3].bound->model, second->components[5].bound->model);
}

TEST(ComponentModels, ForgetThoseThatNobodyHasAndThatWereAskedForLongAgo) {
    const auto keyOf = [](std::uint32_t constants) { // y0' = the first of these constants
        ComponentModel::Key key{1, 0, 0, 0};
        key.insert(key.end(), constants, key::constant);
        key.insert(key.end(), {key::outputs, 0});
        return key;
    };
    ComponentModels models(100); // words
    const auto had = models.of(keyOf(20));
    for (std::uint32_t constants = 21; constants < 23; ++constants)
        (void)models.of(keyOf(constants));
    EXPECT_EQ(models.size(), 3u);
    (void)models.of(keyOf(21));
    (void)models.of(keyOf(23)); // too many: the 22 were asked for before the 21
    EXPECT_EQ(models.made(), 4u);
    EXPECT_EQ(models.of(keyOf(20)), had);
    EXPECT_EQ(models.made(), 4u);
    (void)models.of(keyOf(22));
    EXPECT_EQ(models.made(), 5u);
    EXPECT_LE(models.size(), 3u);
}

TEST(ComponentModel, FoldsNumbersThatA0LeavesTogether) {
    const auto all = prepared(equationsOf({{"x", "(3+y)*(5+y)*x", 1}, {"y", "y*t", 0}}));
    ASSERT_EQ(all->components.size(), 1u);
    EXPECT_EQ(all->components[0].bound->model->print(), "y0' = c0*y0\n");
    EXPECT_THAT(all->components[0].bound->constants, ElementsAre(15));
}

// Exponents are part of a model, since they say what is computed.
TEST(ComponentModel, DiffersByExponents) {
    const auto all = prepared(equationsOf({{"x", "-x^2", 1}, {"y", "-y^3", 1}, {"z", "-z^2", 2}}));
    EXPECT_EQ(all->how.models->made(), 2u);
}

TEST(PreparedEquations, AreSharedByRunsWithTheSameBits) {
    const expression::EquationSet set = equationsOf(pendulums(20));
    const auto shared = prepared(set);
    Solver first(shared, tolerance(1e-6)), second(shared, tolerance(1e-6)),
        own(set, tolerance(1e-6));
    for (Solver* solver : {&first, &second, &own})
        ASSERT_EQ(solver->advanceTo(5).reached, 5);
    EXPECT_EQ(shared->how.models->made(), 1u);
    for (std::size_t u = 0; u < 40; ++u) {
        EXPECT_EQ(first.histories().value(u, 4.9), own.histories().value(u, 4.9));
        EXPECT_EQ(second.histories().value(u, 4.9), own.histories().value(u, 4.9));
    }
}

// Figure 5.7: N components together cost what they cost alone, whatever their time constants.
TEST(Schedule, CostsTheSumOfItsComponents) {
    const auto oscillator = [](std::size_t i, double ratio) {
        const std::string name = "x" + std::to_string(i);
        return std::vector<Line>{{name, "d" + name, 1, 1},
                                 {"d" + name, "-sin(" + name + ")*" + number(ratio * ratio), 0}};
    };
    const auto evaluationsOf = [](const std::vector<Line>& lines) {
        return solved(equationsOf(lines), 10, tolerance(1e-4)).statistics().evaluations;
    };
    for (const double ratio : {1.0, 100.0}) {
        std::vector<Line> all;
        std::size_t sum = 0;
        for (std::size_t i = 0; i < 50; ++i) {
            const std::vector<Line> one = oscillator(i, i == 0 ? ratio : 1);
            all.insert(all.end(), one.begin(), one.end());
            sum += evaluationsOf(one);
        }
        EXPECT_EQ(evaluationsOf(all), sum) << ratio;
    }
}

// A source that looks and never finds: what would be thrown away stays within a step.
TEST(Schedule, KeepsGroupsWithinAStepOfEachOther) {
    class Looks final : public EventSource {
    public:
        std::optional<Event> next(const Histories& histories, double known) override {
            ++asked;
            for (std::size_t u = 0; u < histories.unknowns(); ++u)
                for (double t = known; t < histories.reached(u) && t < 10; ++joints)
                    t = histories.piece(u, t).until;
            return std::nullopt;
        }
        void apply(const Histories&, const Event&, EquationsInForce&, Changes&) override {}
        std::size_t asked = 0, joints = 0;
    } source;
    const Solver solver = solved(equationsOf(pendulums(100)), 10, tolerance(1e-4), &source);
    const Statistics statistics = solver.statistics();
    EXPECT_EQ(statistics.groups, 100u);
    // All have about the same step: a round is a step of each, and one question.
    EXPECT_LT(statistics.rounds, 2 * statistics.steps / 100);
    EXPECT_LE(source.asked, statistics.rounds + 1);
    EXPECT_LE(source.joints, 2 * 200 * source.asked);
}

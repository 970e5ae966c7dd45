#include "expression/function.h"
#include "expression/random_expressions.h"
#include "expression/testing.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <thread>

namespace expression {
namespace {

using namespace testing;

// Bit for bit, the sign of 0 included; of a NaN, that it is one.
bool hasSameBits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

std::vector<Target> targets() {
    std::vector<Target> all{{1, false}, {2, false}};
    if (manyAtOnce().avx)
        all.insert(all.end(), {{1, true}, {4, true}});
    return all;
}

// Machine code for one target, run on as many instances as it takes at once.
class Machine {
public:
    Machine(const Sequence& sequence, Purpose purpose, Target target)
        : lanes_(target.lanes), routine_(makeRoutine(sequence, purpose, abilityOf(target))),
          memory_(assemble(routine_, target)), scratch_(scratchOf(routine_, target)) {}

    [[nodiscard]] bool isMissing() const { return memory_.start() == nullptr; }
    [[nodiscard]] const Routine& routine() const { return routine_; }

    void run(std::span<const double> in, std::span<double> out, std::span<const double> constants,
             std::span<const Decision> decisions) {
        const auto entry = std::bit_cast<EntryPoint>(memory_.start());
        entry(in.data(), out.data(), constants.data(), decisions.data(), scratch_.data());
    }
    [[nodiscard]] unsigned lanes() const { return lanes_; }

private:
    unsigned lanes_;
    Routine routine_;
    ExecutableMemory memory_;
    std::vector<double> scratch_;
};

template <class T> using Instances = std::vector<std::vector<T>>; // by instance, then by index

template <class T> std::vector<T> interleaved(const Instances<T>& all, unsigned lanes) {
    std::vector<T> mixed(all[0].size() * lanes);
    for (std::size_t k = 0; k < mixed.size(); ++k)
        mixed[k] = all[k % lanes][k / lanes];
    return mixed;
}

struct Case {
    Tape tape;
    Instances<double> in, constants;
    Instances<Decision> decisions;
};

constexpr std::size_t instances = 4;

// Values that expression and constants of the instances may have, and branches that their values
// may not imply.
Case randomCase(const Graph& graph, std::span<const Node> symbols, std::span<const Node> outputs,
                RandomExpressions& random) {
    Case c{Tape(graph, symbols, outputs), {}, {}, {}};
    for (std::size_t k = 0; k < instances; ++k) {
        c.in.emplace_back(symbols.size());
        for (double& x : c.in[k])
            x = random.number();
        c.constants.emplace_back(c.tape.constants().begin(), c.tape.constants().end());
        c.decisions.emplace_back(c.tape.decisions());
        Tape::Scratch scratch;
        c.tape.decide(c.in[k], c.decisions[k], {}, scratch);
        for (Decision& d : c.decisions[k])
            if (random.number() > 2)
                d = random.number() > 3 ? noBranch : d == noBranch ? 0 : d - 1;
    }
    return c;
}

std::vector<double> interpreted(const Case& c, std::size_t instance, Purpose purpose) {
    Tape::Scratch scratch;
    std::vector<double> out(c.tape.outputs()), guards(c.tape.decisions());
    if (purpose == Purpose::values)
        c.tape.evaluate(c.in[instance], out, scratch);
    else
        c.tape.evaluate(c.in[instance], out, scratch, c.decisions[instance], guards);
    return purpose == Purpose::guards ? guards : out;
}

// The first difference between the tape and the machine, "" when there is none.
std::string difference(const Case& c, Purpose purpose, Target target) {
    Machine machine(c.tape.sequence(), purpose, target);
    if (machine.isMissing())
        return "no code";
    const unsigned lanes = target.lanes;
    for (std::size_t first = 0; first < instances; first += lanes) {
        const auto part = [&](const auto& all) {
            using All = std::remove_cvref_t<decltype(all)>;
            const auto from = all.begin() + static_cast<std::ptrdiff_t>(first);
            return interleaved(All(from, from + lanes), lanes);
        };
        std::vector<double> out(
            (purpose == Purpose::guards ? c.tape.decisions() : c.tape.outputs()) * lanes);
        machine.run(part(c.in), out, part(c.constants), part(c.decisions));
        for (unsigned lane = 0; lane < lanes; ++lane) {
            const std::vector<double> expected = interpreted(c, first + lane, purpose);
            for (std::size_t k = 0; k < expected.size(); ++k)
                if (!hasSameBits(out[k * lanes + lane], expected[k]))
                    return "tape " + std::to_string(expected[k]) + " machine " +
                           std::to_string(out[k * lanes + lane]) + " output " + std::to_string(k) +
                           " lane " + std::to_string(lane) + " of " + std::to_string(lanes) +
                           (target.avx ? " avx" : " sse2") + " purpose " +
                           std::to_string(static_cast<int>(purpose)) + '\n' + c.tape.print() +
                           machine.routine().print();
        }
    }
    return "";
}

std::string difference(const Case& c) {
    for (const Target target : targets())
        for (const Purpose purpose : {Purpose::values, Purpose::valuesOnBranches, Purpose::guards})
            if (std::string text = difference(c, purpose, target); !text.empty())
                return text;
    return "";
}

bool generates() { return manyAtOnce().lanes > 1; }

#define NEEDS_A_GENERATOR()                                                                        \
    if (!generates())                                                                              \
    GTEST_SKIP() << "no code is generated for this processor"

// The tree walk, the tape, and machine code one at a time and in lanes, on whatever values and on
// branches that the values do not imply.
TEST(Kernel, EveryEvaluatorGivesTheSameBits) {
    NEEDS_A_GENERATOR();
    RandomExpressions random(11);
    for (int i = 0; i < repetitions(10'000); ++i) {
        Xyz s;
        const Node n = random.make(s.graph, 5);
        const Case c = randomCase(s.graph, s.symbols, std::span(&n, 1), random);
        ASSERT_EQ(difference(c), "") << print(s.graph, n);
        const double plain = explained(s.graph, n, s.symbols, c.in[0]);
        ASSERT_TRUE(isSame(interpreted(c, 0, Purpose::values)[0], plain)) << print(s.graph, n);
    }
}

// More values at once than there are registers, across calls too.
TEST(Kernel, LargeSequencesRunOutOfRegistersAndGiveTheSameBits) {
    NEEDS_A_GENERATOR();
    RandomExpressions random(12);
    std::size_t spills = 0;
    for (int i = 0; i < repetitions(30); ++i) {
        Xyz s;
        std::vector<Node> outputs;
        for (int k = 0; k < 40; ++k)
            outputs.push_back(random.make(s.graph, 3));
        for (std::size_t k = 0; k < 40; ++k) // what was long ago is needed again
            outputs.push_back(s.graph.multiply(outputs[k], outputs[39 - k]));
        Node sum = s.graph.constant(0);
        for (const Node n : outputs)
            sum = s.graph.add(sum, s.graph.multiply(n, s.symbols[0]));
        outputs = {sum, outputs[70], outputs[3], sum, s.symbols[1], s.graph.constant(2)};
        const Case c = randomCase(s.graph, s.symbols, outputs, random);
        spills += makeRoutine(c.tape.sequence(), Purpose::values, abilityOf(oneAtATime())).spills;
        ASSERT_EQ(difference(c), "");
    }
    EXPECT_GT(spills, 30u * 10); // the test means something
}

TEST(Kernel, IsOneForAllTapesThatDifferInConstantsOnly) {
    const auto tapeOf = [](const char* text) {
        Graph graph;
        const Node x = graph.symbol("x"), n = parsed(graph, text);
        return Tape(graph, std::span(&x, 1), std::span(&n, 1));
    };
    const auto a = Kernel::of(tapeOf("7 - 3*sin(x)").sequence());
    EXPECT_EQ(Kernel::of(tapeOf("5 - 4.5*sin(x)").sequence()), a);
    EXPECT_NE(Kernel::of(tapeOf("5 + 4.5*sin(x)").sequence()), a);
    EXPECT_NE(Kernel::of(tapeOf("5 - 4.5*cos(x)").sequence()), a);
}

TEST(Kernel, ThousandPendulumsOfDifferentLengthsAreCompiledOnceByAnyNumberOfThreads) {
    NEEDS_A_GENERATOR();
    const Kernel::Counts before = Kernel::counts();
    const auto run = [](int first) {
        for (int i = first; i < 1000; i += 4) {
            Graph graph;
            const Node x = graph.symbol("angle");
            const Node n = graph.multiply(graph.constant(-9.81 / (1 + i)), graph.apply(Op::sin, x));
            const Function function(Tape(graph, std::span(&x, 1), std::span(&n, 1)));
            Function::Scratch scratch;
            for (int k = 0; k < 100; ++k) {
                const double angle = 0.1 * k;
                double out = 0;
                function.evaluate(std::span(&angle, 1), std::span(&out, 1), scratch);
                ASSERT_EQ(out, -9.81 / (1 + i) * std::sin(angle));
            }
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < 4; ++k)
        threads.emplace_back(run, k);
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(Kernel::counts().made - before.made, 1u);
    EXPECT_EQ(Kernel::counts().compiled - before.compiled, 1u);
}

TEST(Function, IsInterpretedUntilMachineCodePays) {
    NEEDS_A_GENERATOR();
    Graph graph;
    const Node x = graph.symbol("x"), n = parsed(graph, "x^3 + 41*x");
    const Function function(Tape(graph, std::span(&x, 1), std::span(&n, 1)));
    Function::Scratch scratch;
    const Kernel::Counts before = Kernel::counts();
    const double at = 2;
    double out = 0;
    const std::uint32_t worthwhile = Kernel::worthwhile(function.tape().sequence());
    for (std::uint32_t k = 1; k < worthwhile; ++k)
        function.evaluate(std::span(&at, 1), std::span(&out, 1), scratch);
    EXPECT_EQ(Kernel::counts().compiled, before.compiled);
    for (int k = 0; k < 20; ++k) // it is asked for now and then
        function.evaluate(std::span(&at, 1), std::span(&out, 1), scratch);
    EXPECT_EQ(Kernel::counts().compiled, before.compiled + 1);
    EXPECT_EQ(out, 90);
}

// As long as it is interpreted and after; also the branches of each instance are its own.
TEST(Function, LanesGiveWhatOneAtATimeGives) {
    RandomExpressions random(13);
    for (int i = 0; i < repetitions(20); ++i) {
        Xyz s;
        const Node outputs[] = {random.make(s.graph, 4), random.make(s.graph, 4)};
        const Function function(Tape(s.graph, s.symbols, outputs));
        const unsigned lanes = Function::lanes();
        const std::uint32_t calls = Kernel::worthwhile(function.tape().sequence()) + 40;
        Function::Scratch scratch;
        std::vector<double> in(3 * lanes), out(2 * lanes), onBranches(2 * lanes), own(3), one(2);
        std::vector<Decision> decisions(function.decisions() * lanes),
            branches(function.decisions());
        for (std::uint32_t call = 0; call < calls; ++call) {
            for (double& x : in)
                x = random.number();
            for (Decision& d : decisions)
                d = random.number() > 0 ? 1 : -1;
            function.evaluateLanes(in, out, scratch);
            function.evaluateLanes(in, onBranches, scratch, decisions);
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                for (std::size_t k = 0; k < 3; ++k)
                    own[k] = in[k * lanes + lane];
                for (std::size_t k = 0; k < branches.size(); ++k)
                    branches[k] = decisions[k * lanes + lane];
                function.tape().evaluate(own, one, scratch);
                for (std::size_t k = 0; k < 2; ++k)
                    ASSERT_TRUE(hasSameBits(out[k * lanes + lane], one[k]));
                function.evaluate(own, one, scratch, branches);
                for (std::size_t k = 0; k < 2; ++k)
                    ASSERT_TRUE(hasSameBits(onBranches[k * lanes + lane], one[k]));
            }
        }
    }
}

// What stays in registers, what is read where it stands, and what a call makes of both.
TEST(Routine, PrintsWhatTheMachineDoes) {
    Xyz s;
    const Node outputs[] = {parsed(s.graph, "sin(x*y)*z + x*y"), parsed(s.graph, "abs(z) - 2")};
    const Tape tape(s.graph, s.symbols, outputs);
    const Ability ability{.rounds = true, .branches = true};
    EXPECT_EQ(makeRoutine(tape.sequence(), Purpose::values, ability).print(),
              "x0 = in0\n"
              "x0 = * x0 in1\n"
              "spill0 = x0\n"
              "x0 = sin x0  (call)\n"
              "x1 = in2\n"
              "x0 = * x0 x1\n"
              "x0 = + x0 spill0\n"
              "out0 = x0\n"
              "x0 = abs x1\n"
              "x0 = - x0 const1\n"
              "out1 = x0\n");
    EXPECT_EQ(makeRoutine(tape.sequence(), Purpose::guards, ability).print(),
              "x0 = in2\n"
              "x0 = guard abs x0  [decision 0]\n"
              "out0 = x0\n");
}

} // namespace
} // namespace expression

#include "exact/closed_form.h"

#include "expression/operation.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace solution {

using expression::Decision;
using expression::Node;
using expression::Op;

namespace {

struct Polynomial {
    Coefficients c{};
    std::size_t degree = 0;
    std::vector<double> states = {}; // times each, added to it; empty: it reads none

    static Polynomial constant(double value) {
        Polynomial p;
        p.c[0] = value;
        return p;
    }
    void trim() {
        while (degree > 0 && c[degree] == 0)
            --degree;
    }
};

using Maybe = std::optional<Polynomial>;

Polynomial sum(const Polynomial& a, const Polynomial& b, double sign) {
    Polynomial r;
    r.degree = std::max(a.degree, b.degree);
    for (std::size_t k = 0; k <= r.degree; ++k)
        r.c[k] = a.c[k] + sign * b.c[k];
    r.trim();
    r.states = a.states.empty() ? std::vector<double>(b.states.size(), 0.0) : a.states;
    for (std::size_t i = 0; i < b.states.size(); ++i)
        r.states[i] += sign * b.states[i];
    return r;
}

Polynomial multiple(Polynomial a, double factor) {
    for (std::size_t k = 0; k <= a.degree; ++k)
        a.c[k] *= factor;
    for (double& x : a.states)
        x *= factor;
    a.trim();
    return a;
}

Maybe product(const Polynomial& a, const Polynomial& b) {
    if (!a.states.empty() || !b.states.empty()) { // linear is all that may be
        const Polynomial &linear = a.states.empty() ? b : a, &other = a.states.empty() ? a : b;
        if (other.degree > 0 || !other.states.empty())
            return std::nullopt;
        return multiple(linear, other.c[0]);
    }
    if (a.degree + b.degree > maximumDegree)
        return std::nullopt;
    Polynomial r;
    r.degree = a.degree + b.degree;
    for (std::size_t i = 0; i <= a.degree; ++i)
        for (std::size_t j = 0; j <= b.degree; ++j)
            r.c[i + j] += a.c[i] * b.c[j];
    r.trim();
    return r;
}

Maybe quotient(Polynomial a, double divisor) {
    for (std::size_t k = 0; k <= a.degree; ++k)
        a.c[k] /= divisor;
    for (double& x : a.states)
        x /= divisor;
    return a;
}

Maybe wholePower(const Polynomial& a, double exponent) {
    if (exponent != std::floor(exponent) || exponent < 0 || exponent > maximumDegree)
        return std::nullopt;
    Maybe r = Polynomial::constant(1);
    for (int k = 0; r && k < static_cast<int>(exponent); ++k)
        r = product(*r, a);
    return r;
}

// Evaluates nodes as polynomials of r = (t - t0) / scale.
class Evaluation {
public:
    // integrals: states are the integrals of their rates; linear: states are read linearly;
    // ofMultipliers: multipliers are, and no state may be read.
    enum class Kind { integrals, linear, ofMultipliers };

    // `y`: the states' values at t, for integrals.
    Evaluation(ComponentEquations& equations, double t, Kind kind, std::span<const double> y = {})
        : graph_(equations.graph()), equations_(equations), y_(y), t_(t), kind_(kind) {
        Inputs& inputs = equations.inputs();
        for (std::size_t i = 0; i < inputs.unknowns().size(); ++i) {
            const Piece& piece = inputs.at(i, t);
            until_ = std::min(until_, piece.until);
            scale_ = i == 0 ? piece.scale : std::min(scale_, piece.scale);
        }
    }
    [[nodiscard]] double until() const { return until_; }
    [[nodiscard]] double scale() const { return scale_; }

    // All rates are 0 at t: those that are constant are 0, though rounding is left of the forces
    // that balance in them.
    void balance(Evaluation scratch, std::span<const Node> rates) {
        for (const Node rate : rates)
            if (const Maybe p = scratch.of(rate); p && p->degree == 0)
                done_.insert_or_assign(rate.index, Polynomial::constant(0));
    }

    // Arguments first, on an own stack: expressions may be deep.
    Maybe of(Node root) {
        std::vector<Node> stack{root};
        while (!stack.empty()) {
            const Node n = stack.back();
            const std::size_t size = stack.size();
            if (!done_.contains(n.index))
                for (const Node argument : needed(n))
                    if (!done_.contains(argument.index))
                        stack.push_back(argument);
            if (stack.size() > size) {
                if (isIntegral(n) && !begun_.insert(n.index).second)
                    return std::nullopt; // its rate depends on it
                continue;
            }
            stack.pop_back();
            if (done_.contains(n.index))
                continue;
            const Maybe value = compute(n);
            if (!value)
                return std::nullopt;
            done_.emplace(n.index, *value);
        }
        return done_.at(root.index);
    }

private:
    // Branches that are not taken, and guards of what is decided, are not looked at.
    std::vector<Node> needed(Node n) {
        const auto arguments = graph_.arguments(n);
        const Op op = graph_.op(n);
        if (isIntegral(n))
            return {equations_.outputs()[*equations_.functions().stateOf(n)]};
        const auto decision = equations_.functions().decisionOf(n);
        if (decision && *decision != expression::noBranch) {
            if (op == Op::abs)
                return {arguments[0]};
            if (op == Op::min || op == Op::max)
                return {arguments[takesFirst(op, *decision) ? 0 : 1]};
            return {};
        }
        if (op == Op::select) {
            const auto condition = done_.find(arguments[0].index);
            if (condition == done_.end())
                return {arguments[0]};
            return {arguments[condition->second.c[0] != 0 ? 1 : 2]};
        }
        return {arguments.begin(), arguments.end()};
    }

    [[nodiscard]] bool isIntegral(Node n) const {
        return kind_ == Kind::integrals && graph_.op(n) == Op::symbol &&
               equations_.functions().stateOf(n).has_value();
    }

    static bool takesFirst(Op op, Decision decision) {
        return op == Op::min ? decision <= 0 : decision >= 0;
    }

    Maybe compute(Node n) {
        const Op op = graph_.op(n);
        if (op == Op::constant)
            return Polynomial::constant(graph_.value(n));
        if (op == Op::symbol)
            return symbol(n);
        const auto decision = equations_.functions().decisionOf(n);
        if (decision && *decision != expression::noBranch)
            return decided(n, op, *decision);
        if (op == Op::select)
            return select(n);
        return arithmetic(n, op);
    }

    Maybe symbol(Node n) {
        if (n == equations_.time()) {
            Polynomial p = Polynomial::constant(t_);
            p.c[1] = scale_;
            p.degree = 1;
            return p;
        }
        if (const auto constant = equations_.functions().constantOf(n))
            return Polynomial::constant(*constant);
        const auto input = equations_.functions().inputOf(n);
        if (!input)
            return state(n);
        const Piece& piece = equations_.inputs().at(*input, t_);
        Polynomial p;
        p.c = reparametrize(piece.coefficients, (t_ - piece.origin) / piece.scale,
                            scale_ / piece.scale);
        p.degree = piece.coefficients.size() - 1;
        p.trim();
        return p;
    }

    Maybe state(Node n) const {
        if (const auto multiplier = equations_.functions().multiplierOf(n)) {
            if (kind_ == Kind::ofMultipliers)
                return linear(*multiplier, equations_.multipliers().size());
            return Polynomial::constant(equations_.multiplierValues()[*multiplier]);
        }
        const auto place = equations_.functions().stateOf(n);
        if (kind_ == Kind::linear && place)
            return linear(*place, equations_.states().size());
        if (kind_ == Kind::integrals && place)
            return integral(*place);
        return std::nullopt;
    }

    static Polynomial linear(std::size_t place, std::size_t count) {
        Polynomial p;
        p.states.assign(count, 0.0);
        p.states[place] = 1;
        return p;
    }

    [[nodiscard]] Maybe integral(std::size_t place) const {
        const Polynomial& rate = done_.at(equations_.outputs()[place].index);
        if (rate.degree == maximumDegree)
            return std::nullopt;
        Polynomial p = Polynomial::constant(y_[place]);
        for (std::size_t k = 0; k <= rate.degree; ++k)
            p.c[k + 1] = rate.c[k] * scale_ / static_cast<double>(k + 1);
        p.degree = rate.degree + 1;
        p.trim();
        return p;
    }

    Maybe decided(Node n, Op op, Decision decision) {
        const auto arguments = graph_.arguments(n);
        switch (op) {
        case Op::abs: {
            const Polynomial& p = done_.at(arguments[0].index);
            if (decision == 0 && p.degree > 0)
                return std::nullopt;
            const bool negative = decision < 0 || (decision == 0 && p.c[0] < 0);
            return sum(Polynomial::constant(0), p, negative ? -1 : 1);
        }
        case Op::min:
        case Op::max:
            return done_.at(arguments[takesFirst(op, decision) ? 0 : 1].index);
        case Op::less:
            return Polynomial::constant(decision < 0);
        case Op::lessEqual:
            return Polynomial::constant(decision <= 0);
        case Op::equal:
            return Polynomial::constant(decision == 0);
        case Op::notEqual:
            return Polynomial::constant(decision != 0);
        default: // sign, floor, ceil
            return Polynomial::constant(static_cast<double>(decision));
        }
    }

    Maybe select(Node n) {
        const auto arguments = graph_.arguments(n);
        const Polynomial& condition = done_.at(arguments[0].index);
        if (condition.degree > 0 || !condition.states.empty())
            return std::nullopt;
        const Node taken = arguments[condition.c[0] != 0 ? 1 : 2];
        return done_.at(taken.index);
    }

    Maybe arithmetic(Node n, Op op) {
        const auto arguments = graph_.arguments(n);
        const Polynomial a = done_.at(arguments[0].index);
        const Polynomial b = arguments.size() > 1 ? done_.at(arguments[1].index) : Polynomial{};
        const bool readsStates = !a.states.empty() || !b.states.empty();
        if (a.degree == 0 && b.degree == 0 && !readsStates)
            return Polynomial::constant(expression::compute(op, a.c[0], b.c[0]));
        switch (op) {
        case Op::negate:
            return sum(Polynomial::constant(0), a, -1);
        case Op::add:
            return sum(a, b, 1);
        case Op::subtract:
            return sum(a, b, -1);
        case Op::multiply:
            return product(a, b);
        case Op::divide:
            return b.degree == 0 && b.states.empty() ? quotient(a, b.c[0]) : std::nullopt;
        case Op::power:
            return b.degree == 0 && !readsStates ? wholePower(a, b.c[0]) : std::nullopt;
        default:
            return std::nullopt;
        }
    }

    const expression::Graph& graph_;
    ComponentEquations& equations_;
    std::span<const double> y_;
    double t_, until_ = infinity, scale_ = 1;
    Kind kind_;
    std::unordered_map<std::uint32_t, Polynomial> done_;
    std::unordered_set<std::uint32_t> begun_; // integrals
};

// The forces that keep the conditions at t do so for good; then they are the equations'
// multipliers, and these are the states' rates.
bool areForcesConstant(ComponentEquations& equations, double t, std::span<const double> y,
                       std::vector<double>& rates) {
    if (equations.multipliers().empty())
        return true;
    if (equations.slips() || equations.isComposed())
        return false;
    Evaluation evaluation(equations, t, Evaluation::Kind::ofMultipliers);
    for (std::size_t row = 0; row < equations.multipliers().size(); ++row) {
        if (equations.model().conditions().isTie[row] != 0)
            return false;
        if (equations.mode().kept[row] != complementarity::State::inside)
            continue;
        const Maybe second = evaluation.of(equations.model().secondRate(row));
        if (!second || second->degree > 0)
            return false;
    }
    rates.resize(y.size());
    return equations.rates(t, y, rates);
}

} // namespace

std::optional<ClosedForm> closedForm(ComponentEquations& equations, double t,
                                     std::span<const double> y) {
    std::vector<double> rates; // with multipliers
    if (!areForcesConstant(equations, t, y, rates))
        return std::nullopt;
    Evaluation evaluation(equations, t, Evaluation::Kind::integrals, y);
    if (!rates.empty() && std::ranges::all_of(rates, [](double rate) { return rate == 0; }))
        evaluation.balance(Evaluation(equations, t, Evaluation::Kind::integrals, y),
                           equations.outputs().first(rates.size()));
    ClosedForm result{evaluation.scale(), evaluation.until(), {}};
    const auto outputs = equations.outputs();
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const Maybe p = evaluation.of(outputs[i]);
        const bool state = i < equations.states().size();
        if (!p || (state && p->degree == maximumDegree))
            return std::nullopt;
        Coefficients column = p->c;
        if (state) {
            column = {};
            column[0] = y[i];
            for (std::size_t k = 0; k <= p->degree; ++k)
                column[k + 1] = p->c[k] * result.scale / static_cast<double>(k + 1);
        }
        result.columns.push_back(column);
    }
    return result;
}

std::optional<LinearForm> linearForm(ComponentEquations& equations, double t) {
    if (equations.watches() > 0 || !equations.held().empty() || !equations.multipliers().empty())
        return std::nullopt;
    Evaluation evaluation(equations, t, Evaluation::Kind::linear);
    LinearForm result{evaluation.until(), {}};
    for (const Node output : equations.outputs()) {
        const Maybe p = evaluation.of(output);
        if (!p || p->degree > 0)
            return std::nullopt;
        std::vector<double> row = p->states;
        row.resize(equations.states().size(), 0.0);
        row.push_back(p->c[0]);
        result.matrix.insert(result.matrix.end(), row.begin(), row.end());
    }
    return result;
}

} // namespace solution

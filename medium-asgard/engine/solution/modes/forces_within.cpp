#include "modes/forces_within.h"

#include "complementarity/solve.h"

#include <algorithm>
#include <vector>

namespace solution {

using complementarity::Answer;
using complementarity::Law;
using complementarity::Laws;
using complementarity::State;

namespace {

bool isHeldAtEdge(const Law& disc, const Answer& answer, std::size_t k, double none) {
    return disc.kind == Law::Kind::disc && answer.states[k] == State::edge &&
           answer.rates.segment(disc.first, disc.rows).norm() <= none;
}

} // namespace

void holdWithin(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Laws& laws,
                Answer& answer) {
    constexpr double rounding = 1e-9;
    const double none = rounding * b.cwiseAbs().maxCoeff();
    std::vector<std::size_t> held;
    for (std::size_t k = 0; k < laws.size(); ++k)
        if (isHeldAtEdge(laws[k], answer, k, none))
            held.push_back(k);
    for (const double less : {0.2, 0.02}) {
        if (held.empty())
            return;
        Laws narrow = laws;
        for (const std::size_t k : held)
            narrow[k].coefficient *= 1 - less;
        const auto within = complementarity::solve(a, b, narrow, answer);
        const bool holds = within && std::ranges::all_of(held, [&](std::size_t k) {
                               return within->states[k] == State::inside ||
                                      isHeldAtEdge(narrow[k], *within, k, none);
                           });
        if (!holds)
            continue;
        answer = *within;
        for (const std::size_t k : held)
            answer.states[k] = State::inside;
        return;
    }
}

} // namespace solution

#include "complementarity/solve.h"

#include "complementarity/centres.h"
#include "complementarity/search.h"

namespace complementarity {

std::optional<Answer> solve(const Matrix& a, const Vector& given, const Laws& laws,
                            const Answer& guess, Work* work) {
    Work counted;
    Work& counts = work != nullptr ? *work : counted;
    counts = {};
    if (given.size() == 0)
        return Answer{};
    constexpr double none = 1e-40; // no body moves so slowly: what is left of a motion that fades
    const Vector b = (given.array().abs() <= none).select(0, given);
    if (!haveCentres(laws))
        return solveAtMiddles(a, b, laws, guess, counts);
    return solveFromCentres(a, b, laws, guess, counts);
}

} // namespace complementarity

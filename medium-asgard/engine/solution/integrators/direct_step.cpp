#include "integrators/direct_step.h"

#include "integrators/dop853.h"
#include "integrators/tableau.h"

#include <cmath>
#include <cstring>
#include <string_view>

#if defined(__x86_64__)

#include <immintrin.h>

// All that follows up to the pop is called on processors that have AVX, and nowhere else.
#pragma GCC push_options
#pragma GCC target("avx")

namespace solution {
namespace {

using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));

template <class Value> inline Value at(const double* values) {
    Value value;
    std::memcpy(&value, values, sizeof value);
    return value;
}
template <class Value> inline void put(double* to, Value value) {
    std::memcpy(to, &value, sizeof value);
}

// What was just written one by one is read one by one: read at once it would have to wait until it
// is in the cache.
template <class Value> inline Value fresh(const double* values) {
    const volatile double* const each = values;
    if constexpr (sizeof(Value) == sizeof(Two))
        return Two{each[0], each[1]};
    else
        return at<Value>(values);
}

// Sum of weight * slope, in the order of the terms.
template <class Value, std::size_t Size, const auto& Row, std::size_t... Term>
inline Value sumOf(const double* slopes, std::index_sequence<Term...>) {
    Value sum{};
    ((sum += Row[Term].value * at<Value>(slopes + (Row[Term].stage - 1) * Size)), ...);
    sum += Row.back().value * fresh<Value>(slopes + (Row.back().stage - 1) * Size);
    return sum;
}
template <class Value, std::size_t Size, const auto& Row> inline Value sumOf(const double* slopes) {
    return sumOf<Value, Size, Row>(slopes, std::make_index_sequence<Row.size() - 1>());
}

// Work::of<Value>(n) for all unknowns n, four, two or one at a time.
template <std::size_t Size, class Work> inline void forAll(const Work& work) {
    constexpr std::size_t fours = Size / 4 * 4, twos = Size / 2 * 2;
    for (std::size_t n = 0; n < fours; n += 4)
        work.template of<Four>(n);
    if constexpr (fours < twos)
        work.template of<Two>(fours);
    if constexpr (twos < Size)
        work.template of<double>(twos);
}

template <std::size_t Stage> constexpr auto rowOf = std::get<Stage>(dop853::rows);

template <std::size_t Size, std::size_t Stage> struct Argument {
    const DirectStep::Stages& step;
    double* argument;
    template <class Value> void of(std::size_t n) const {
        const Value y =
            at<Value>(step.start + n) + step.h * sumOf<Value, Size, rowOf<Stage>>(step.slopes + n);
        put(argument + n, y);
        if constexpr (Stage == dop853::stiffStage)
            put(step.stiffAt + n, y);
    }
};

// What rounding loses there is kept.
template <std::size_t Size> struct Argument<Size, dop853::stages> {
    const DirectStep::Stages& step;
    double* argument;
    template <class Value> void of(std::size_t n) const {
        const Value start = at<Value>(step.start + n);
        const Value increment = step.h * sumOf<Value, Size, dop853::weights>(step.slopes + n) +
                                at<Value>(step.lost + n);
        const Value end = start + increment;
        put(argument + n, end);
        put(step.end + n, end);
        put(step.lostNext + n, increment - (end - start));
    }
};

template <std::size_t Size> inline bool areFinite(const double* values) {
    Four four{}; // no numbers as soon as one of them is not finite
    Two two{};
    double one = 0;
    for (std::size_t n = 0; n + 4 <= Size; n += 4)
        four += 0 * at<Four>(values + n);
    if constexpr (Size % 4 >= 2)
        two = 0 * fresh<Two>(values + Size / 4 * 4);
    if constexpr (Size % 2 == 1)
        one = 0 * values[Size - 1];
    if constexpr (Size >= 4)
        two += _mm256_castpd256_pd128(four) + _mm256_extractf128_pd(four, 1);
    return two[0] + two[1] + one == 0;
}

template <std::size_t Size, std::size_t Stage>
inline bool makeStage(const DirectStep::Stages& step, const System::Direct& rates) {
    double* const slopes = step.slopes + Stage * Size;
    rates.arguments[0] = step.t + dop853::nodes[Stage] * step.h;
    forAll<Size>(Argument<Size, Stage>{step, rates.arguments + 1});
    if (rates.reader)
        rates.reader->putInputs(rates.arguments[0]);
    rates.code(rates.arguments, slopes, rates.scratch);
    return areFinite<Size>(slopes);
}

// Stages from First on.
template <std::size_t Size, std::size_t First, std::size_t... After>
inline DirectStep::Made makeStages(const DirectStep::Stages& step, const System::Direct& rates,
                                   std::index_sequence<After...>) {
    DirectStep::Made made;
    made.failed = !((++made.evaluations, makeStage<Size, First + After>(step, rates)) && ...);
    return made;
}

template <std::size_t Size>
DirectStep::Made makeStages(const DirectStep::Stages& step, const System::Direct& rates) {
    return makeStages<Size, 1>(step, rates, std::make_index_sequence<dop853::stages>());
}

template <std::size_t Size>
DirectStep::Made makeExtension(const DirectStep::Stages& step, const System::Direct& rates) {
    constexpr std::size_t first = dop853::stages + 1, all = dop853::nodes.size();
    return makeStages<Size, first>(step, rates, std::make_index_sequence<all - first>());
}

inline double rootOf(double x) { return std::sqrt(x); }
inline Two rootOf(Two x) { return _mm_sqrt_pd(x); }
inline Four rootOf(Four x) { return _mm256_sqrt_pd(x); }

template <std::size_t Size> struct Error {
    double h;
    const double* slopes;
    double* error;
    template <class Value> void of(std::size_t n) const {
        const Value first = sumOf<Value, Size, dop853::error>(slopes + n);
        const Value second = sumOf<Value, Size, dop853::secondError>(slopes + n);
        const Value square = first * first;
        const Value both = square + 0.01 * second * second;
        put(error + n, h * (both > 0 ? square / rootOf(both) : first));
    }
};

template <std::size_t Size> void findErrors(double h, const double* slopes, double* error) {
    forAll<Size>(Error<Size>{h, slopes, error});
}

inline double entryOf(double value, std::size_t /*entry*/) { return value; }
inline double entryOf(Two value, std::size_t entry) { return value[entry]; }
inline double entryOf(Four value, std::size_t entry) { return value[entry]; }

constexpr std::size_t densePowers = 7;

template <std::size_t Size> struct Dense {
    double h;
    const double* slopes;
    const Tableau& tableau;
    Coefficients* columns;
    template <class Value> void of(std::size_t n) const {
        of<Value>(n, std::make_index_sequence<densePowers>());
    }
    template <class Value, std::size_t... Power>
    void of(std::size_t n, std::index_sequence<Power...>) const {
        Value sums[densePowers] = {};
        for (const std::size_t stage : tableau.denseStages) {
            const double* const weights = tableau.dense[stage].data();
            const Value slope = at<Value>(slopes + stage * Size + n);
            ((sums[Power] += weights[Power] * slope), ...);
        }
        constexpr std::size_t entry = sizeof(double);
        for (std::size_t i = 0; i < sizeof(Value) / entry; ++i)
            ((columns[n + i][Power + 1] = h * entryOf(sums[Power], i)), ...);
    }
};

template <std::size_t Size>
void makeColumns(double h, const double* slopes, const Tableau& tableau, Coefficients* columns) {
    forAll<Size>(Dense<Size>{h, slopes, tableau, columns});
}

} // namespace
} // namespace solution

#pragma GCC pop_options

namespace solution {

DirectStep DirectStep::of(const Tableau& tableau, std::size_t size) {
    static const bool isThere = __builtin_cpu_supports("avx") != 0;
    if (!isThere || size == 0 || size > largest || tableau.name != std::string_view("dop853"))
        return {};
    return [size]<std::size_t... Before>(std::index_sequence<Before...>) {
        static constexpr DirectStep all[] = {{.stages = &makeStages<Before + 1>,
                                              .extension = &makeExtension<Before + 1>,
                                              .errors = &findErrors<Before + 1>,
                                              .dense = &makeColumns<Before + 1>}...};
        return all[size - 1];
    }
    (std::make_index_sequence<largest>());
}

} // namespace solution

#else

namespace solution {
DirectStep DirectStep::of(const Tableau& /*tableau*/, std::size_t /*size*/) { return {}; }
} // namespace solution

#endif

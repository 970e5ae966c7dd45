#include "stepping/step_model.h"

#include <algorithm>
#include <cmath>

namespace solution {

std::optional<Violation> StepContext::violationOn(const StateCurves& curves) const {
    if (equations().watches() == 0)
        return std::nullopt;
    std::vector<double> y(curves.columns.size());
    const auto watch = [&](double t, std::span<double> values) {
        curves.at(t, y);
        equations().guards().watch(t, y, values);
    };
    const auto one = [&](double t, std::size_t k) {
        curves.at(t, y);
        return equations().guards().watchOfPlaces(k, t, y);
    };
    // A switch for a moment only is looked at in its middle.
    const ComponentModel::PeakFunctions& peaks = equations().model().guardPeaks();
    std::vector<double> ends;
    if (!peaks.ratios.empty())
        ends = centresOf(equations(), peaks, curves);
    ends.push_back(curves.until);
    double from = curves.origin;
    for (const double end : ends) {
        if (auto found = firstViolation(equations().watches(), watch, from, end, Care::great, one))
            return found;
        from = end;
    }
    return std::nullopt;
}

// The side on which a motion is that has left a surface holds from where it stood on it. Where that
// was tried in vain it stays.
bool StepContext::passesAtOnce(const Violation& found, const StateCurves& curves) const {
    if (found.time <= time())
        return true;
    if (switches.atOnce() > 2 * patience() || switches.staysAt(time()))
        return false;
    std::vector<double> y(curves.columns.size());
    curves.at(found.time, y);
    return equations().solver().looksAhead(found, found.time, y);
}

Ending StepContext::endingWithoutRate(double t, std::span<const double> y) const {
    std::vector<double> slopes(y.size());
    const bool finite = equations().rates(t, y, slopes);
    if (!finite && equations().slidingFailed())
        return {Stop::Reason::decisions, equations().states(),
                "the motion can follow neither branch of the expressions that switch with " +
                    names(equations().states()) + ", nor a mean of the branches"};
    if (equations().isContradictory())
        return endingOf(equations().contradictory());
    auto culprits = equations().notFinite(t, y);
    if (culprits.empty())
        culprits = equations().states();
    const std::string named = names(culprits);
    return {Stop::Reason::notFinite, culprits,
            named + (culprits.size() > 1 ? " have" : " has") + " no finite rate"};
}

Ending StepContext::endingOf(std::vector<std::size_t> contradictory) const {
    if (contradictory.empty())
        contradictory = equations().multipliers();
    const auto nameOf = [&](std::size_t place) { return set->unknowns[unknowns[place]].name; };
    const bool isOne = std::ranges::all_of(contradictory, [&](std::size_t place) {
        return nameOf(place) == nameOf(contradictory[0]);
    });
    return {Stop::Reason::contradiction, contradictory,
            "no forces keep the conditions of " + names(contradictory) +
                (isOne ? ", which contradict how its bodies are held"
                       : ", which contradict each other")};
}

std::string StepContext::names(const std::vector<std::size_t>& places) const {
    std::string text;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (k == 4 && places.size() > 5)
            return text + " and " + std::to_string(places.size() - k) + " others";
        const std::string& name = set->unknowns[unknowns[places[k]]].name;
        if (k == 0 || name != set->unknowns[unknowns[places[k - 1]]].name) // multipliers of one
            text += (k == 0 ? "" : ", ") + name;
    }
    return text;
}

std::optional<double> shortlyBefore(double t, double origin) {
    constexpr double left = 0.01;   // of the step up to t
    constexpr double least = 1e-12; // of the time: it goes on
    const double before = t - left * (t - origin);
    return t - before > least * std::abs(t) ? std::optional(before) : std::nullopt;
}

} // namespace solution

#include "batch/accuracy_line.h"

#include <cstdio>

namespace batch {
namespace {

// As one writes it: 1e-4 and 3e-6, neither 0.0001 nor 3e-06.
std::string number(double value, int digits) {
    constexpr double small = 0.01;
    char text[40];
    const bool isSmall = value > 0 && value < small;
    std::snprintf(text, sizeof text, isSmall ? "%.*e" : "%.*g", isSmall ? digits - 1 : digits,
                  value);
    std::string printed = text;
    const std::size_t e = printed.find('e');
    if (e == std::string::npos)
        return printed;
    std::string mantissa = printed.substr(0, e);
    if (mantissa.find('.') != std::string::npos)
        mantissa.erase(mantissa.find_last_not_of("0.") + 1);
    const std::size_t digit = printed.find_first_not_of("+-0", e + 1);
    return mantissa + (printed[e + 1] == '-' ? "e-" : "e") + printed.substr(digit);
}

std::string seconds(double value) { return number(value, 4) + " s"; }

std::string unknownError(const ToldMotion& motion) {
    return "the error of " + motion.method +
           (motion.fixedStep > 0 ? " at steps of " + number(motion.fixedStep, 6) : "") +
           " is not estimated; only the method auto estimates its error";
}

} // namespace

std::string accuracyLine(const ToldMotion& motion, const simulation::Statistics& statistics) {
    if (!statistics.errorEstimate)
        return motion.method == "auto" ? "" : unknownError(motion);
    const double estimate = *statistics.errorEstimate;
    const std::string asked = number(motion.accuracy, 3);
    const std::string all = seconds(motion.reached - motion.start);
    const std::string size =
        statistics.movingSize ? " of " + number(*statistics.movingSize, 3) + " m" : "";
    if (const auto until = statistics.predictableUntil; until && *until < motion.reached)
        return "accurate to " + asked + size + ", as asked, only for the first " +
               seconds(*until - motion.start) + " of " + all +
               (estimate > simulation::unpredictable ? "; not predictable after that"
                                                     : "; to " + number(estimate, 2) + " after");
    if (estimate == 0)
        return "accurate to rounding over " + all + ", asked " + asked;
    return "accurate to " + number(estimate, 2) + size +
           (estimate <= motion.accuracy ? "" : " only,") + " over " + all + ", asked " + asked;
}

} // namespace batch

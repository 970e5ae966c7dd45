#include "expression/operation.h"

#include <array>
#include <cmath>

namespace expression {
namespace {

struct Description {
    std::string_view name;
    int arguments;
};

// In the order of Op.
constexpr std::array<Description, 38> descriptions{{
    {"constant", 0}, {"symbol", 0}, {"parameter", 0}, {"-", 1},     {"sin", 1},   {"cos", 1},
    {"tan", 1},      {"asin", 1},   {"acos", 1},      {"atan", 1},  {"sinh", 1},  {"cosh", 1},
    {"tanh", 1},     {"exp", 1},    {"log", 1},       {"log10", 1}, {"sqrt", 1},  {"abs", 1},
    {"sign", 1},     {"floor", 1},  {"ceil", 1},      {"!", 1},     {"+", 2},     {"-", 2},
    {"*", 2},        {"/", 2},      {"^", 2},         {"atan2", 2}, {"hypot", 2}, {"min", 2},
    {"max", 2},      {"<", 2},      {"<=", 2},        {"==", 2},    {"!=", 2},    {"&&", 2},
    {"||", 2},       {"?:", 3},
}};
static_assert(static_cast<std::size_t>(Op::select) == 37);

const Description& describe(Op op) { return descriptions[static_cast<std::size_t>(op)]; }

double truth(bool value) { return value ? 1.0 : 0.0; }

double smallWholePower(double x, int n) {
    switch (n) {
    case 0:
        return 1;
    case 1:
        return x;
    case 2:
        return x * x;
    case 3:
        return x * x * x;
    default:
        return (x * x) * (x * x);
    }
}

} // namespace

int argumentCount(Op op) { return describe(op).arguments; }

std::string_view nameOf(Op op) { return describe(op).name; }

bool isCommutative(Op op) {
    switch (op) {
    case Op::add:
    case Op::multiply:
    case Op::equal:
    case Op::notEqual:
    case Op::logicalAnd:
    case Op::logicalOr:
        return true;
    default:
        return false;
    }
}

bool isTruth(Op op) { return op == Op::logicalNot || (op >= Op::less && op <= Op::logicalOr); }

bool isSwitch(Op op) {
    switch (op) {
    case Op::abs:
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::min:
    case Op::max:
    case Op::less:
    case Op::lessEqual:
    case Op::equal:
    case Op::notEqual:
        return true;
    default:
        return false;
    }
}

double signOf(double x) { return x > 0 ? 1 : x < 0 ? -1 : x == 0 ? 0 : x; }

bool isShortPower(double exponent) {
    const double size = std::abs(exponent);
    return size <= 4 && size * 2 == std::floor(size * 2);
}

double powerOf(double base, double exponent) {
    if (!isShortPower(exponent))
        return std::pow(base, exponent);
    const double size = std::abs(exponent);
    const int whole = static_cast<int>(size);
    double result = smallWholePower(base, whole);
    if (whole != size)
        result = whole == 0 ? std::sqrt(base) : result * std::sqrt(base);
    return exponent < 0 ? 1 / result : result;
}

double compute(Op op, double a, double b, double c) {
    switch (op) {
    case Op::constant:
    case Op::symbol:
    case Op::parameter:
        return a;
    case Op::negate:
        return -a;
    case Op::sin:
        return std::sin(a);
    case Op::cos:
        return std::cos(a);
    case Op::tan:
        return std::tan(a);
    case Op::asin:
        return std::asin(a);
    case Op::acos:
        return std::acos(a);
    case Op::atan:
        return std::atan(a);
    case Op::sinh:
        return std::sinh(a);
    case Op::cosh:
        return std::cosh(a);
    case Op::tanh:
        return std::tanh(a);
    case Op::exp:
        return std::exp(a);
    case Op::log:
        return std::log(a);
    case Op::log10:
        return std::log10(a);
    case Op::sqrt:
        return std::sqrt(a);
    case Op::abs:
        return std::abs(a);
    case Op::sign:
        return signOf(a);
    case Op::floor:
        return std::floor(a);
    case Op::ceil:
        return std::ceil(a);
    case Op::logicalNot:
        return truth(a == 0);
    case Op::add:
        return a + b;
    case Op::subtract:
        return a - b;
    case Op::multiply:
        return a * b;
    case Op::divide:
        return a / b;
    case Op::power:
        return powerOf(a, b);
    case Op::atan2:
        return std::atan2(a, b);
    case Op::hypot:
        return std::hypot(a, b);
    case Op::min:
        return a <= b ? a : b < a ? b : a + b;
    case Op::max:
        return a >= b ? a : b > a ? b : a + b;
    case Op::less:
        return truth(a < b);
    case Op::lessEqual:
        return truth(a <= b);
    case Op::equal:
        return truth(a == b);
    case Op::notEqual:
        return truth(a != b);
    case Op::logicalAnd:
        return truth(a != 0 && b != 0);
    case Op::logicalOr:
        return truth(a != 0 || b != 0);
    case Op::select:
        return a != 0 ? b : c;
    }
    return 0;
}

} // namespace expression

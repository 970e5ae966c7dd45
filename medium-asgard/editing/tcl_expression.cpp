#include "editing/tcl_expression.h"

#include "editing/number_text.h"

#include "script/numbers.h"

#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

namespace editing {

namespace {

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

constexpr std::array<std::pair<std::string_view, double (*)(double)>, 8> functions = {
    {{"sin", std::sin},
     {"cos", std::cos},
     {"tan", std::tan},
     {"sqrt", std::sqrt},
     {"exp", std::exp},
     {"log", std::log},
     {"floor", std::floor},
     {"ceil", std::ceil}}};

// One function for each level of precedence; nothing as soon as anything is not understood.
class Evaluation {
public:
    Evaluation(std::string_view text, scene::Range range, const TclNames& names)
        : text_(text.substr(0, range.to)), at_(range.from), names_(names) {}

    std::optional<TclNumber> whole() {
        const auto value = sum();
        skip();
        return at_ == text_.size() ? value : std::nullopt;
    }
    [[nodiscard]] std::vector<scene::Range> literals() const { return literals_; }

private:
    using Value = std::optional<TclNumber>;

    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
    }
    bool take(std::string_view what) {
        skip();
        if (text_.substr(at_, what.size()) != what)
            return false;
        at_ += what.size();
        return true;
    }
    Value sum() {
        Value value = product();
        while (value) {
            const bool plus = take("+");
            if (!plus && !take("-"))
                break;
            const Value next = product();
            if (!next)
                return next;
            value = TclNumber{value->value + (plus ? next->value : -next->value),
                              value->integer && next->integer};
        }
        return value;
    }
    Value product() {
        Value value = power();
        while (value) {
            skip();
            const char op = at_ < text_.size() ? text_[at_] : ' ';
            if ((op != '*' && op != '/' && op != '%') || text_.substr(at_, 2) == "**")
                break;
            ++at_;
            const Value next = power();
            value = next ? combined(*value, op, *next) : std::nullopt;
        }
        return value;
    }
    static Value combined(const TclNumber& a, char op, const TclNumber& b) {
        const bool integer = a.integer && b.integer;
        if (op == '*')
            return TclNumber{a.value * b.value, integer};
        if (b.value == 0 || (op == '%' && !integer))
            return std::nullopt;
        const double whole = std::floor(a.value / b.value); // Tcl rounds downwards
        if (op == '%')
            return TclNumber{a.value - b.value * whole, true};
        return TclNumber{integer ? whole : a.value / b.value, integer};
    }
    Value signedOne() {
        if (++depth_ > 100)
            return std::nullopt;
        Value value;
        if (take("-")) {
            value = signedOne();
            if (value)
                value->value = -value->value;
        } else {
            value = take("+") ? signedOne() : one();
        }
        --depth_;
        return value;
    }
    // From the right; a sign binds before it.
    Value power() {
        const Value base = signedOne();
        if (!base || !take("**") || ++depth_ > 100)
            return base;
        const Value exponent = power();
        --depth_;
        if (!exponent)
            return exponent;
        const bool integer = base->integer && exponent->integer;
        const double power = std::pow(base->value, exponent->value);
        if (integer && base->value == 0 && exponent->value < 0)
            return std::nullopt;
        return TclNumber{integer ? std::trunc(power) : power, integer}; // 2 ** -1 is 0
    }
    Value inParentheses() {
        const Value inner = take("(") ? sum() : std::nullopt;
        return inner && take(")") ? inner : std::nullopt;
    }
    Value one() {
        skip();
        if (at_ == text_.size() || ++depth_ > 100)
            return std::nullopt;
        const char c = text_[at_];
        Value value;
        if (c == '(')
            value = inParentheses();
        else if (c == '$')
            value = variable();
        else if (isDigit(c) || c == '.')
            value = number();
        else
            value = call();
        --depth_;
        return value;
    }
    Value variable() {
        std::size_t from = ++at_;
        const bool braced = at_ < text_.size() && text_[at_] == '{';
        from += braced ? 1 : 0;
        at_ = from;
        while (at_ < text_.size() && (braced ? text_[at_] != '}' : isWord(text_[at_])))
            ++at_;
        const std::string_view name = text_.substr(from, at_ - from);
        at_ += braced ? 1 : 0;
        return name.empty() ? std::nullopt : names_.variable(name);
    }
    Value number() {
        const std::size_t from = at_;
        while (at_ < text_.size() && (isWord(text_[at_]) || text_[at_] == '.' ||
                                      ((text_[at_] == '-' || text_[at_] == '+') &&
                                       (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E'))))
            ++at_;
        const scene::Range range = {from, at_};
        literals_.push_back(range);
        if (const Value given = names_.literal ? names_.literal(range) : std::nullopt)
            return given;
        return tclNumber(text_.substr(from, at_ - from));
    }
    Value call() {
        const std::size_t from = at_;
        while (at_ < text_.size() && isWord(text_[at_]))
            ++at_;
        const std::string_view name = text_.substr(from, at_ - from);
        const Value argument = inParentheses();
        if (!argument || name.empty())
            return std::nullopt;
        if (name == "double")
            return TclNumber{argument->value, false};
        if (name == "int")
            return TclNumber{std::trunc(argument->value), true};
        if (name == "round")
            return TclNumber{std::round(argument->value), true};
        if (name == "abs")
            return TclNumber{std::abs(argument->value), argument->integer};
        for (const auto& [known, function] : functions)
            if (name == known)
                return TclNumber{function(argument->value), false};
        return std::nullopt;
    }

    std::string_view text_;
    std::size_t at_;
    const TclNames& names_;
    std::vector<scene::Range> literals_;
    int depth_ = 0;
};

} // namespace

std::optional<TclNumber> tclNumber(std::string_view text) {
    const auto value = script::decimalNumber(std::string(text));
    const bool integer = text.find_first_of(".eE") == std::string_view::npos;
    const std::size_t digits = text.find_first_of("0123456789");
    if (!value ||
        (integer && text[digits] == '0' && digits + 1 < text.size() && isDigit(text[digits + 1])))
        return std::nullopt;
    return TclNumber{*value, integer};
}

std::optional<TclNumber> tclValue(std::string_view text, scene::Range expression,
                                  const TclNames& names) {
    const auto value = Evaluation(text, expression, names).whole();
    return value && std::isfinite(value->value) ? value : std::nullopt;
}

std::vector<scene::Range> tclLiterals(std::string_view text, scene::Range expression) {
    const TclNames any{[](std::string_view) { return std::optional(TclNumber{1, false}); }, {}};
    Evaluation evaluation(text, expression, any);
    if (!evaluation.whole())
        return {};
    return evaluation.literals();
}

} // namespace editing

#include "expression/parse.h"

#include "expression/nearest_name.h"
#include "expression/operation.h"
#include "expression/tokens.h"

#include <algorithm>
#include <numbers>

namespace expression {
namespace {

constexpr int deepest = 200;
constexpr std::size_t longest = 100'000;

struct Function {
    std::string_view name;
    Op op;
    bool isVariadic = false; // two or more arguments, taken two by two
};

constexpr Function functions[] = {
    {"sin", Op::sin},           {"cos", Op::cos},       {"tan", Op::tan},
    {"asin", Op::asin},         {"acos", Op::acos},     {"atan", Op::atan},
    {"atan2", Op::atan2},       {"sinh", Op::sinh},     {"cosh", Op::cosh},
    {"tanh", Op::tanh},         {"exp", Op::exp},       {"log", Op::log},
    {"log10", Op::log10},       {"sqrt", Op::sqrt},     {"abs", Op::abs},
    {"sign", Op::sign},         {"floor", Op::floor},   {"ceil", Op::ceil},
    {"min", Op::min, true},     {"max", Op::max, true}, {"pow", Op::power},
    {"hypot", Op::hypot, true},
};

const Function* findFunction(std::string_view name) {
    const auto* found = std::ranges::find(functions, name, &Function::name);
    return found == std::end(functions) ? nullptr : found;
}

// An operator between two operands: how tightly it binds, and what it makes of them.
struct Infix {
    std::string_view sign;
    int binding;
    Op op;
    bool isSwapped = false; // a > b is b < a
};

constexpr Infix infixes[] = {
    {"||", 1, Op::logicalOr}, {"&&", 2, Op::logicalAnd}, {"==", 3, Op::equal},
    {"!=", 3, Op::notEqual},  {"<=", 4, Op::lessEqual},  {">=", 4, Op::lessEqual, true},
    {"<", 4, Op::less},       {">", 4, Op::less, true},  {"+", 5, Op::add},
    {"-", 5, Op::subtract},   {"*", 6, Op::multiply},    {"/", 6, Op::divide},
};

const Infix* findInfix(const Token& token) {
    if (token.kind != TokenKind::sign)
        return nullptr;
    const auto* found = std::ranges::find(infixes, token.text, &Infix::sign);
    return found == std::end(infixes) ? nullptr : found;
}

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

std::string counted(std::size_t count) {
    static const std::string words[] = {"no", "one", "two", "three", "four", "five"};
    return count < 6 ? words[count] : std::to_string(count);
}

// Recursive descent; the first fault ends it. A failed rule returns 0 and failed() is true.
class Parser {
public:
    Parser(Graph& graph, std::string_view text, const Names& names)
        : graph_(graph), names_(names), tokens_(text) {}

    std::variant<Node, SyntaxError> parse() {
        const Node node = conditional();
        if (!failed() && tokens_.now().kind != TokenKind::end)
            failAtLeftover();
        if (tokens_.fault() && (!error_ || tokens_.fault()->from <= error_->from))
            return *tokens_.fault();
        if (error_)
            return *error_;
        return node;
    }

private:
    // Counts levels, so that no text exhausts the machine's stack.
    struct Level {
        explicit Level(Parser& parser) : parser_(parser) {
            if (++parser_.depth_ > deepest)
                parser_.fail(parser_.tokens_.now(),
                             "the expression is nested more than 200 levels deep");
        }
        ~Level() { --parser_.depth_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
        Parser& parser_;
    };

    [[nodiscard]] bool failed() const { return error_ || tokens_.fault(); }

    Node fail(std::size_t from, std::size_t to, std::string message, std::string suggestion = "") {
        if (!error_)
            error_ = SyntaxError{from, to, std::move(message), std::move(suggestion)};
        return graph_.constant(0);
    }

    Node fail(const Token& at, std::string message, std::string suggestion = "") {
        return fail(at.from, at.to, std::move(message), std::move(suggestion));
    }

    // At the end of the text, what is wrong is the last thing before it.
    Node failExpecting(std::string_view expected) {
        const Token& now = tokens_.now();
        const std::string wanted = "expected " + std::string(expected);
        if (now.kind == TokenKind::end)
            return fail(lastFrom_, lastTo_,
                        wanted + (lastTo_ > 0 ? ", and the expression ends here"
                                              : ", and the expression is empty"));
        return fail(now, wanted + ", not " + quoted(now.text));
    }

    void failAtLeftover() {
        const Token& now = tokens_.now();
        if (now.kind == TokenKind::sign && (now.text == ")" || now.text == ":" || now.text == ","))
            fail(now,
                 quoted(now.text) + " has no " +
                     (now.text == ")"   ? "\"(\" before it"
                      : now.text == ":" ? "\"?\" before it"
                                        : "function that it belongs to"),
                 now.text == "," ? "numbers are written 1000.5, without commas" : "");
        else
            fail(now, "expected an operator before " + quoted(now.text));
    }

    Token take() {
        const Token taken = tokens_.now();
        lastFrom_ = taken.from;
        lastTo_ = taken.to;
        tokens_.advance();
        return taken;
    }

    bool takeSign(std::string_view sign) {
        if (failed() || !tokens_.isSign(sign))
            return false;
        take();
        return true;
    }

    Node conditional() {
        const Level level(*this);
        if (failed())
            return graph_.constant(0);
        const Node condition = infix(1);
        if (!takeSign("?"))
            return condition;
        const Node yes = conditional();
        if (!failed() && !takeSign(":"))
            return failExpecting("\":\" and the value for when the condition is 0");
        const Node no = conditional();
        return failed() ? condition : graph_.apply(Op::select, condition, yes, no);
    }

    // Operators that bind at least so tightly, all left associative.
    Node infix(int least) {
        Node left = unary();
        while (!failed()) {
            const Infix* found = findInfix(tokens_.now());
            if (!found || found->binding < least)
                break;
            take();
            const Node right = infix(found->binding + 1);
            if (failed())
                break;
            left = found->isSwapped ? graph_.apply(found->op, right, left)
                                    : graph_.apply(found->op, left, right);
        }
        return left;
    }

    Node unary() {
        const Level level(*this);
        if (failed())
            return graph_.constant(0);
        if (takeSign("-"))
            return graph_.negate(unary());
        if (takeSign("+"))
            return unary();
        if (takeSign("!"))
            return graph_.apply(Op::logicalNot, unary());
        const Node base = primary();
        if (!takeSign("^") && !takeSign("**"))
            return base;
        const Node exponent = unary(); // right associative, and 2^-1 needs no parentheses
        return failed() ? base : graph_.apply(Op::power, base, exponent);
    }

    Node primary() {
        if (failed())
            return graph_.constant(0);
        if (tokens_.now().kind == TokenKind::number)
            return graph_.constant(take().value);
        if (tokens_.now().kind == TokenKind::name)
            return named();
        if (!tokens_.isSign("("))
            return failExpecting("a value");
        const Token open = take();
        const Node inside = conditional();
        if (!failed() && !takeSign(")"))
            return failUnclosed(open);
        return inside;
    }

    Node failUnclosed(const Token& open) {
        if (tokens_.now().kind == TokenKind::end)
            return fail(open, "\"(\" is never closed");
        return failExpecting("an operator or \")\"");
    }

    Node named() {
        const Token name = take();
        const Function* function = findFunction(name.text);
        if (!tokens_.isSign("(")) {
            if (function)
                return fail(name, quoted(name.text) + " is a function",
                            "write " + std::string(name.text) + "(...)");
            return name.text == "pi" ? graph_.constant(std::numbers::pi) : meaning(name, {}, false);
        }
        std::vector<Node> arguments = argumentList();
        if (failed())
            return graph_.constant(0);
        return function ? call(*function, name, arguments) : meaning(name, arguments, true);
    }

    std::vector<Node> argumentList() {
        std::vector<Node> arguments;
        const Token open = take();
        if (takeSign(")"))
            return arguments;
        do
            arguments.push_back(conditional());
        while (takeSign(","));
        if (!failed() && !takeSign(")"))
            failUnclosed(open);
        return arguments;
    }

    Node call(const Function& function, const Token& name, std::span<const Node> arguments) {
        const auto wanted = static_cast<std::size_t>(argumentCount(function.op));
        const bool fits = function.isVariadic ? arguments.size() >= 2 : arguments.size() == wanted;
        if (!fits)
            return fail(name.from, lastTo_,
                        std::string(name.text) + " takes " + counted(wanted) +
                            (function.isVariadic ? " or more" : "") +
                            (wanted == 1 ? " argument, not " : " arguments, not ") +
                            counted(arguments.size()));
        if (wanted == 1)
            return graph_.apply(function.op, arguments[0]);
        Node result = arguments[0];
        for (const Node next : arguments.subspan(1))
            result = graph_.apply(function.op, result, next);
        return result;
    }

    Node meaning(const Token& name, std::span<const Node> arguments, bool isCall) {
        Meaning found = names_(graph_, name.text, arguments, isCall);
        if (found.node)
            return *found.node;
        if (found.suggestion.empty() && isCall && (name.text == "mod" || name.text == "fmod"))
            found.suggestion = "the rest of a / b is a - b*floor(a/b)";
        if (found.suggestion.empty()) {
            const std::string near = nearestName(name.text, functionNames());
            if (!near.empty())
                found.suggestion = "did you mean " + quoted(near) + "?";
        }
        return fail(name, std::move(found.message), std::move(found.suggestion));
    }

    Graph& graph_;
    const Names& names_;
    Tokens tokens_;
    std::optional<SyntaxError> error_;
    std::size_t lastFrom_ = 0, lastTo_ = 0; // of the last token taken
    int depth_ = 0;
};

} // namespace

std::variant<Node, SyntaxError> parse(Graph& graph, std::string_view text, const Names& names) {
    if (text.size() > longest)
        return SyntaxError{longest, text.size(), "the expression is longer than 100,000 bytes", ""};
    return Parser(graph, text, names).parse();
}

const std::vector<std::string>& functionNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        std::ranges::transform(functions, std::back_inserter(list),
                               [](const Function& f) { return std::string(f.name); });
        std::ranges::sort(list);
        return list;
    }();
    return names;
}

} // namespace expression

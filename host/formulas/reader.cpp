#include "formulas/reader.h"

#include "text/characters.h"

#include <algorithm>

namespace formulas {

namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
std::string quoted(const Token& token) { return std::string(token.text); }

const char* ordinal(int index) {
    constexpr const char* words[] = {"first", "second", "third"};
    return words[index];
}

} // namespace

Reader::Reader(std::string_view source, const ValueSupply& supply)
    : supply_(supply), source_(source) {
    if (source_.size() > longestSource) {
        const std::size_t cut = text::characterStart(source_, longestSource);
        fault(cut, source_.size(),
              "The formula is longer than " + std::to_string(longestSource) +
                  " bytes; the rest is left out.");
        source_ = source_.substr(0, cut);
    }
    if (!text::isUtf8(source_)) {
        const text::Range bad = text::illFormed(source_);
        fault(bad.from, bad.to, "These bytes are no UTF-8.");
        repaired_ = text::asUtf8(source_);
        source_ = repaired_;
    }
}

Formula Reader::take() {
    formula_.root = list();
    std::ranges::stable_sort(formula_.faults, {}, &Fault::offset);
    return std::move(formula_);
}

Token Reader::peek() {
    while (at_ < source_.size() && isBlank(source_[at_]))
        ++at_;
    const std::string_view rest = source_.substr(at_);
    if (rest.empty())
        return {rest, at_};
    if (rest.front() != '\\' || rest.size() == 1)
        return {rest.substr(0, std::max<std::size_t>(1, text::characterLength(rest))), at_};
    std::size_t end = 1;
    while (end < rest.size() && isLetter(rest[end]))
        ++end;
    if (end == 1)
        end += std::max<std::size_t>(1, text::characterLength(rest.substr(1)));
    return {rest.substr(0, end), at_};
}

Token Reader::next() {
    const Token token = peek();
    at_ = token.end();
    return token;
}

void Reader::fault(std::size_t offset, std::size_t end, std::string message) {
    if (!cut_ && formula_.faults.size() < mostFaults)
        formula_.faults.push_back({offset, end, std::move(message)});
}

void Reader::fault(const Token& token, std::string message) {
    fault(token.offset, token.end(), std::move(message));
}

NodeId Reader::add(Kind kind, const Token& from) {
    Node node;
    node.kind = kind;
    node.offset = from.offset;
    node.end = from.end();
    formula_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(formula_.nodes.size() - 1);
}

NodeId Reader::finish(NodeId id) {
    formula_.nodes[id].end = std::max(formula_.nodes[id].offset, at_);
    return id;
}

NodeId Reader::symbol(const Token& from, char32_t letter, Atom atom) {
    const NodeId id = add(Kind::symbol, from);
    Node& node = formula_.nodes[id];
    node.letter = letter;
    node.alphabet = alphabet_;
    node.code = styled(letter, alphabet_);
    node.atom = atom;
    return id;
}

NodeId Reader::space(const Token& from, double amount) {
    const NodeId id = add(Kind::space, from);
    formula_.nodes[id].amount = amount;
    return id;
}

NodeId Reader::missingPart(const Token& from) {
    const NodeId id = symbol(from, U'□', Atom::ordinary);
    formula_.nodes[id].faulty = true;
    return id;
}

// Does the token end this list? What ends nothing at all is passed over here.
bool Reader::stopped() {
    for (;;) {
        const Token token = peek();
        const std::string_view text = token.text;
        if (text.empty())
            return true;
        if (text == "]" && waiting_.bracket)
            return true;
        if (text == "}") {
            if (waiting_.braces > 0)
                return true;
            fault(token, "This } ends nothing.");
        } else if (text == "&" || token.endsRow()) {
            if (waiting_.cells > 0)
                return true;
            fault(token, quoted(token) + " stands only between \\begin and \\end, as in a matrix.");
        } else if (text == "\\right" || text == "\\middle") {
            if (waiting_.fences > 0)
                return true;
            fault(token, quoted(token) + " has no \\left before it.");
        } else if (text == "\\end") {
            if (waiting_.environments > 0)
                return true;
            fault(token, "\\end has no \\begin before it.");
            at_ = token.end();
            bool there = false;
            (void)raw(token, there);
            continue;
        } else {
            return false;
        }
        at_ = token.end();
    }
}

NodeId Reader::list() {
    const NodeId id = add(Kind::list, {{}, at_});
    readInto(id);
    return finish(id);
}

// Alphabets that are switched on in a list end with it.
void Reader::readInto(NodeId list) {
    const Alphabet outer = alphabet_;
    readList(list);
    alphabet_ = outer;
}

void Reader::readList(NodeId list) {
    Script current;
    while (!stopped()) {
        const Token token = peek();
        if (isScript(token)) {
            script(list, current);
        } else if (token.text == "\\limits" || token.text == "\\nolimits") {
            setLimits(list, next());
        } else {
            current = {};
            if (const NodeId id = item(); id != none)
                formula_.nodes[list].children.push_back(id);
        }
    }
}

void Reader::setLimits(NodeId list, const Token& token) {
    const auto& children = formula_.nodes[list].children;
    if (children.empty() || formula_.nodes[children.back()].atom != Atom::operation)
        return fault(token, quoted(token) + " stands behind an operator such as \\sum.");
    formula_.nodes[children.back()].limits =
        token.text == "\\limits" ? Limits::always : Limits::never;
}

// A group of one ordinary sign is that sign.
NodeId Reader::unwrapped(NodeId list) const {
    const Node& node = formula_.nodes[list];
    if (node.children.size() != 1)
        return list;
    const Node& child = formula_.nodes[node.children.front()];
    return child.kind == Kind::symbol && child.atom == Atom::ordinary ? node.children.front()
                                                                      : list;
}

NodeId Reader::item() {
    const Token token = next();
    if (++depth_ > deepestNesting) {
        fault(token, "The formula nests more than " + std::to_string(deepestNesting) +
                         " parts in each other; the rest is left out.");
        cut_ = true;
        at_ = source_.size();
        --depth_;
        return missingPart(token);
    }
    NodeId id = none;
    if (token.text == "{")
        id = group(token);
    else if (token.isCommand())
        id = command(token);
    else
        id = character(token);
    --depth_;
    return id == none ? none : finish(id);
}

NodeId Reader::group(const Token& open) {
    const Waiting outer = waiting_;
    ++waiting_.braces;
    waiting_.bracket = false;
    const NodeId id = list();
    waiting_ = outer;
    formula_.nodes[id].offset = open.offset;
    if (peek().text == "}")
        (void)next();
    else
        fault(open, "This { has no } that ends it.");
    return unwrapped(id);
}

NodeId Reader::character(const Token& token) {
    const char32_t code = text::codePoint(token.text);
    switch (code) {
    case U'-':
        return symbol(token, U'−', Atom::binary);
    case U'*':
        return symbol(token, U'∗', Atom::binary);
    case U'~':
    case 0xA0:
        return space(token, 0.25);
    case U'\u2009':
    case U'\u202F':
        return space(token, 3.0 / 18);
    case U'$':
        fault(token, "A formula needs no $ around it; the sign itself is \\$.");
        return none;
    case U'%':
    case U'#':
        fault(token, "For the sign write \\" + quoted(token) + ".");
        return symbol(token, code, Atom::ordinary);
    case U'\\':
        fault(token, "This \\ has no command behind it.");
        return none;
    default:
        break;
    }
    if (code < 0x20 || code == 0x7F) {
        fault(token, "This control character has no place in a formula.");
        return none;
    }
    const Symbol* known = symbolOf(code);
    const NodeId id = symbol(token, code, known != nullptr ? known->atom : Atom::ordinary);
    if (known != nullptr)
        formula_.nodes[id].limits = known->limits;
    return id;
}

NodeId Reader::command(const Token& token) {
    if (const auto handler = handlers().find(token.name()); handler != handlers().end())
        return (this->*handler->second)(token);
    if (accentNamed(token.name()) != 0)
        return accent(token);
    if (functionNamed(token.name()) != nullptr)
        return function(token);
    if (const Symbol* known = symbolNamed(token.name()); known != nullptr) {
        const NodeId id = symbol(token, known->code, known->atom);
        formula_.nodes[id].limits = known->limits;
        return id;
    }
    return unknown(token);
}

NodeId Reader::unknown(const Token& token) {
    std::string message = "There is no command " + quoted(token) + ".";
    if (token.text == "\\over")
        message = "Instead of \\over write \\frac{above}{below}.";
    else if (const std::string_view other = alike(token.name()); !other.empty())
        message += " Is \\" + std::string(other) + " meant?";
    fault(token, message);
    const NodeId id = add(Kind::text, token);
    formula_.nodes[id].text = token.text;
    formula_.nodes[id].faulty = true;
    return id;
}

// A part of a command: a group, or one sign.
NodeId Reader::argument(const Token& command, int index, int count) {
    const Token token = peek();
    const bool missing = token.text.empty() || token.text == "}" || token.text == "&" ||
                         token.text == "^" || token.text == "_" || token.endsRow() ||
                         token.text == "\\right" || token.text == "\\middle" ||
                         token.text == "\\end" || (token.text == "]" && waiting_.bracket);
    if (!missing) {
        const NodeId id = item();
        return id != none ? id : missingPart(token);
    }
    std::string message = quoted(command);
    if (command.text == "^" || command.text == "_")
        message += " has nothing behind it.";
    else if (count == 1)
        message += " needs a part in braces; it is missing.";
    else
        message += " needs two parts; the " + std::string(ordinal(index)) + " is missing.";
    fault(command, message);
    return missingPart({{}, at_});
}

std::string_view Reader::raw(const Token& command, bool& there) {
    there = peek().text == "{";
    if (!there)
        return {};
    const Token open = next();
    int braces = 1;
    const std::size_t from = at_;
    for (; at_ < source_.size(); ++at_) {
        if (source_[at_] == '\\' && at_ + 1 < source_.size())
            ++at_;
        else if (source_[at_] == '{')
            ++braces;
        else if (source_[at_] == '}' && --braces == 0)
            break;
    }
    at_ = std::min(at_, source_.size());
    const std::string_view inside = source_.substr(from, at_ - from);
    if (at_ < source_.size())
        ++at_;
    else
        fault(open, "The { of " + quoted(command) + " has no } that ends it.");
    return inside;
}

Formula read(std::string_view source, const ValueSupply& supply) {
    return Reader(source, supply).take();
}

} // namespace formulas

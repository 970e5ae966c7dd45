// Numbers from elsewhere: \value[2 decimals]{pendulum}{bob.y}.
#include "formulas/reader.h"

namespace formulas {

namespace {

// A supplied number is short; what is no number is not grafted at length.
constexpr std::size_t longestValue = 200; // bytes

// An expression as words: signs that formulas know are shown as they are.
std::string asWords(const std::string& expression) {
    std::string words = "\\text{[";
    for (const char c : expression.substr(0, longestValue / 2))
        words += c == '\\' || c == '{' || c == '}' || c == '$' ? std::string("\\") + c
                                                               : std::string(1, c);
    return words + "]}";
}

} // namespace

NodeId Reader::value(const Token& token) {
    ValueCall call;
    call.offset = token.offset;
    if (peek().text == "[") {
        const Token open = next();
        const std::size_t close = source_.find(']', at_);
        if (close == std::string_view::npos)
            fault(open, "The [ of \\value has no ] that ends it.");
        const std::size_t end = std::min(close, source_.size());
        call.options = source_.substr(at_, end - at_);
        at_ = std::min(end + 1, source_.size());
    }
    for (std::string* part : {&call.of, &call.expression}) {
        bool there = false;
        *part = raw(token, there);
        if (there)
            continue;
        fault(token, "\\value needs the ID of a figure and an expression, each in braces: "
                     "\\value{pendulum}{bob.y}.");
        return missingPart(token);
    }
    call.end = at_;
    formula_.values.push_back(call);
    SuppliedValue supplied = supply_ ? supply_(call) : SuppliedValue{};
    if (supplied.source.empty())
        supplied.source = asWords(call.expression);
    return grafted(supplied, token);
}

// The number is one sign of the formula: no line ends in it.
NodeId Reader::grafted(const SuppliedValue& supplied, const Token& from) {
    const NodeId number = grafted(supplied.source, supplied.isFaulty, from);
    if (supplied.room.empty())
        return number;
    const NodeId room = grafted(supplied.room, false, from);
    const NodeId id = add(Kind::room, from);
    formula_.nodes[id].children = {number, room};
    return id;
}

NodeId Reader::grafted(const std::string& source, bool isFaulty, const Token& from) {
    const Formula part = read(std::string_view(source).substr(0, longestValue));
    const auto first = static_cast<NodeId>(formula_.nodes.size());
    const auto moved = [first](NodeId id) { return id == none ? none : id + first; };
    for (const Node& node : part.nodes) {
        formula_.nodes.push_back(node);
        Node& made = formula_.nodes.back();
        made.offset = from.offset;
        made.end = from.end();
        made.faulty = made.faulty || isFaulty;
        for (NodeId& child : made.children)
            child = moved(child);
    }
    return moved(part.root);
}

} // namespace formulas

// The attributes of a start tag: NAME="value".
#include "sgml/parser.h"

namespace sgml {

namespace {

bool endsTag(char c) { return c == '>' || c == '<'; }

} // namespace

void Parser::readAttributes(NodeId element) {
    for (;;) {
        skipBlanks();
        if (atEnd() || endsTag(here()))
            return;
        if (here() == '/' && at_ + 1 < text_.size() && text_[at_ + 1] == '>') {
            ++at_;
            return;
        }
        if (!readAttribute(element))
            return;
    }
}

// False: the tag cannot be read further.
bool Parser::readAttribute(NodeId element) {
    const std::size_t from = at_;
    const text::Range name = readName();
    if (name.empty()) {
        const std::size_t end = text_.find_first_of(" \t\r\n<>", at_ + 1);
        at_ = end == std::string_view::npos ? text_.size() : end;
        fault(FaultKind::badAttribute, {from, at_}, "an attribute's name begins with a letter");
        return true;
    }
    const std::string attribute(tree_.text(name));
    skipBlanks();
    if (atEnd() || here() != '=') {
        fault(FaultKind::badAttribute, name,
              "attribute " + attribute + " has no value; write " + attribute + "=\"...\"");
        return true;
    }
    ++at_;
    skipBlanks();
    const text::Range value = readAttributeValue(name);
    keepAttribute(element, {.name = name, .value = value, .whole = {from, at_}});
    return !atEnd();
}

text::Range Parser::readAttributeValue(text::Range name) {
    if (atEnd() || here() != '"')
        return unquotedValue(name);
    const std::size_t from = at_ + 1;
    const std::size_t quote = noMoreQuotes_ ? std::string_view::npos : text_.find('"', from);
    if (quote != std::string_view::npos) {
        at_ = quote + 1;
        return {from, quote};
    }
    noMoreQuotes_ = true;
    const std::size_t end = text_.find_first_of("<>\r\n", from);
    fault(FaultKind::badAttribute, {at_, from},
          "the value of attribute " + std::string(tree_.text(name)) +
              " is not closed with a quote");
    at_ = end == std::string_view::npos ? text_.size() : end;
    return {from, at_};
}

text::Range Parser::unquotedValue(text::Range name) {
    const std::size_t from = at_;
    const std::size_t end = text_.find_first_of(" \t\r\n<>\"", at_);
    at_ = end == std::string_view::npos ? text_.size() : end;
    fault(FaultKind::badAttribute, {from < at_ ? from : name.from, at_},
          "the value of attribute " + std::string(tree_.text(name)) + " is not in double quotes");
    return {from, at_};
}

void Parser::keepAttribute(NodeId element, const Attribute& attribute) {
    Node& node = tree_.nodes_[element];
    if (node.attributeCount >= limits_.attributes) {
        if (node.attributeCount == limits_.attributes)
            fault(FaultKind::limit, attribute.whole,
                  "more than " + std::to_string(limits_.attributes) +
                      " attributes; the others are kept but not read");
        return;
    }
    const std::string_view name = tree_.text(attribute.name);
    for (std::size_t i = node.firstAttribute; i < tree_.attributes_.size(); ++i)
        if (tree_.text(tree_.attributes_[i].name) == name) {
            fault(FaultKind::duplicateAttribute, attribute.whole,
                  "attribute " + std::string(name) + " is given twice; the first counts");
            break;
        }
    tree_.attributes_.push_back(attribute);
    ++node.attributeCount;
}

} // namespace sgml

#include "schemas/structure.h"

#include <algorithm>
#include <set>

namespace schemas {

using sgml::NodeId;
using sgml::noNode;

// --- reading the file -----------------------------------------------------------------------

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t from = text.find_first_not_of(blanks);
    return from == std::string_view::npos
               ? std::string_view{}
               : text.substr(from, text.find_last_not_of(blanks) + 1 - from);
}

bool isName(std::string_view text) {
    const auto isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    return !text.empty() && isLetter(text.front()) &&
           std::all_of(text.begin(), text.end(), [&](char c) {
               return isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' ||
                      c == ':';
           });
}

std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> result;
    for (std::size_t at = 0; (at = text.find_first_not_of(" \t", at)) != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
        result.emplace_back(text.substr(at, end - at));
        at = end;
    }
    return result;
}

} // namespace

class StructureParser {
public:
    StructureParser(std::string_view text, StructureSchema& schema,
                    std::vector<sgml::Fault>& faults)
        : text_(text), schema_(schema), faults_(faults) {}

    void parse() {
        for (std::size_t at = 0; at < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', at), text_.size());
            line_ = at;
            readLine(text_.substr(at, end - at));
            at = end + 1;
        }
    }

private:
    void readLine(std::string_view line) {
        line = trimmed(line.substr(0, line.find('#')));
        if (line.empty())
            return;
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos)
            return fail("a rule is NAME = what it may hold");
        const std::string_view left = trimmed(line.substr(0, equals));
        std::string right;
        if (!substitute(trimmed(line.substr(equals + 1)), right))
            return;
        if (left.starts_with('$'))
            keepPart(left, right);
        else
            keepRule(left, right);
    }

    // Puts the `$names` in, each as a group of its own. LIMIT: what comes out is at most 20,000
    // bytes.
    bool substitute(std::string_view text, std::string& result) {
        for (std::size_t at = 0; at < text.size();) {
            if (text[at] != '$') {
                result += text[at++];
                continue;
            }
            std::size_t end = at + 1;
            while (end < text.size() && isName(text.substr(at + 1, end + 1 - at - 1)))
                ++end;
            const auto part = parts_.find(text.substr(at, end - at));
            if (part == parts_.end()) {
                fail(std::string(text.substr(at, end - at)) + " is not defined before this line");
                return false;
            }
            result += "(" + part->second + ")";
            at = end;
            if (result.size() > 20'000) {
                fail("the rule is too long");
                return false;
            }
        }
        return true;
    }

    void keepPart(std::string_view name, const std::string& text) {
        std::string fault;
        (void)ContentModel::parse(text, fault);
        if (!isName(name.substr(1)))
            fault = "\"" + std::string(name) + "\" is not a name";
        if (!fault.empty())
            return fail(fault);
        parts_[std::string(name)] = text;
    }

    void keepRule(std::string_view left, const std::string& text) {
        StructureSchema::Rule rule;
        const std::size_t bracket = left.find('[');
        if (bracket != std::string_view::npos) {
            if (left.back() != ']')
                return fail("\"]\" is missing behind the attributes");
            rule.attributes = words(left.substr(bracket + 1, left.size() - bracket - 2));
        }
        const std::string name(trimmed(left.substr(0, bracket)));
        std::string fault;
        rule.model = ContentModel::parse(text, fault);
        if (!isName(name))
            fault = "\"" + name + "\" is not a name";
        else if (schema_.rules_.contains(name))
            fault = "a second rule for " + name;
        if (!fault.empty())
            return fail(fault);
        schema_.rules_[name] = std::move(rule);
    }

    void fail(const std::string& message) {
        sgml::Fault fault;
        fault.range = {line_, line_};
        fault.position = text::Places(text_).at(line_);
        fault.message = message;
        faults_.push_back(std::move(fault));
    }

    std::string_view text_;
    StructureSchema& schema_;
    std::vector<sgml::Fault>& faults_;
    std::map<std::string, std::string, std::less<>> parts_;
    std::size_t line_ = 0;
};

StructureSchema StructureSchema::parse(std::string_view text, std::vector<sgml::Fault>& faults) {
    StructureSchema schema;
    StructureParser(text, schema, faults).parse();
    return schema;
}

std::vector<std::string> StructureSchema::names() const {
    std::vector<std::string> names;
    names.reserve(rules_.size());
    for (const auto& [name, rule] : rules_)
        names.push_back(name);
    return names;
}

const ContentModel* StructureSchema::model(std::string_view element) const {
    const auto rule = rules_.find(element);
    return rule == rules_.end() ? nullptr : &rule->second.model;
}

bool StructureSchema::hasAttribute(std::string_view element, std::string_view attribute) const {
    const auto rule = rules_.find(element);
    return rule != rules_.end() &&
           std::find(rule->second.attributes.begin(), rule->second.attributes.end(), attribute) !=
               rule->second.attributes.end();
}

// --- checking a document --------------------------------------------------------------------

namespace {

std::string tag(std::string_view name) { return "<" + std::string(name) + ">"; }

} // namespace

sgml::Fault Finding::fault(const sgml::Tree& tree) const {
    const sgml::Node& at = tree.node(node);
    const std::size_t from = at.startTag.from;
    sgml::Fault fault;
    fault.severity = sgml::Severity::warning;
    fault.message = message;
    fault.range = at.startTag;
    if (where == Where::attribute)
        fault.range = {from + attribute.from, from + attribute.to};
    else if (where == Where::endTag && !at.endTag.empty())
        fault.range = at.endTag;
    return fault;
}

Finding atAttribute(const sgml::Tree& tree, NodeId element, const sgml::Attribute& attribute,
                    std::string message) {
    const std::size_t from = tree.node(element).startTag.from;
    return {.node = element,
            .where = Finding::Where::attribute,
            .attribute = {attribute.whole.from - from, attribute.whole.to - from},
            .message = std::move(message)};
}

std::vector<sgml::Fault> StructureSchema::check(const sgml::Tree& tree, NodeId documentNode) const {
    std::vector<sgml::Fault> warnings;
    for (NodeId id = tree.following(documentNode, documentNode); id != noNode;) {
        const bool isElement = tree.isElement(id);
        const bool nested = isElement && tree.name(id) == "DOCUMENT";
        if (isElement && !nested)
            for (const Finding& finding : judge(tree, id))
                warnings.push_back(finding.fault(tree));
        id = nested ? tree.followingSkippingChildren(id, documentNode)
                    : tree.following(id, documentNode);
    }
    return warnings;
}

std::vector<Finding> StructureSchema::judge(const sgml::Tree& tree, NodeId element) const {
    std::vector<Finding> findings;
    const auto rule = rules_.find(tree.name(element));
    if (rule == rules_.end()) {
        findings.push_back(
            {.node = element,
             .message = tag(tree.name(element)) + " is not known to this class of documents"});
        return findings;
    }
    judgeAttributes(tree, element, rule->second, findings);
    std::vector<NodeId> nodes;
    std::vector<std::string_view> names;
    for (NodeId child = tree.node(element).firstChild; child != noNode;
         child = tree.node(child).next) {
        const bool content = tree.node(child).kind == sgml::NodeKind::content;
        const bool known = tree.isElement(child) &&
                           (tree.name(child) == "DOCUMENT" || rules_.contains(tree.name(child)));
        if (!content && !known)
            continue; // an unknown one gets its own warning
        nodes.push_back(child);
        names.push_back(content ? std::string_view{} : tree.name(child));
    }
    const ContentModel::Verdict verdict = rule->second.model.check(names);
    if (verdict.wrong < nodes.size()) {
        const std::string_view name = names[verdict.wrong];
        findings.push_back({.node = nodes[verdict.wrong],
                            .message = (name.empty() ? "text" : tag(name)) +
                                       " does not belong here in " + tag(tree.name(element)) +
                                       "; expected " +
                                       (verdict.expected.empty() ? "nothing" : verdict.expected)});
    } else if (verdict.incomplete) {
        findings.push_back(
            {.node = element,
             .where = Finding::Where::endTag,
             .message = tag(tree.name(element)) + " ends too early; expected " + verdict.expected});
    }
    return findings;
}

void StructureSchema::judgeAttributes(const sgml::Tree& tree, NodeId element, const Rule& rule,
                                      std::vector<Finding>& findings) const {
    static const std::set<std::string_view> ofClassElements = {"WIDTH", "HEIGHT", "ALIGN", "POSTER",
                                                               "ALT"};
    if (tree.node(element).attributeCount == 0)
        return;
    const bool isClassElement =
        tree.node(tree.node(element).parent).kind == sgml::NodeKind::document;
    for (const sgml::Attribute& attribute : tree.attributes(element)) {
        const std::string_view name = tree.text(attribute.name);
        const bool listed = std::find(rule.attributes.begin(), rule.attributes.end(), name) !=
                            rule.attributes.end();
        if (name != "ID" && name != "LANG" && !listed &&
            !(isClassElement && ofClassElements.contains(name)))
            findings.push_back(atAttribute(tree, element, attribute,
                                           "attribute " + std::string(name) + " is not known for " +
                                               tag(tree.name(element))));
    }
}

} // namespace schemas

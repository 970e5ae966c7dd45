// The allowed content of elements of one class: `CLASS.structure`, one rule per line.
//
//     # a comment
//     $text = (TEXT | EMPH | LINK)*            a name for part of a rule, defined before its use
//     SECTION = HEADING (PARAGRAPH | SECTION)*
//     LINK [TO] = TEXT                         with the attributes that it may have besides ID
//
// TEXT is content in braces, or an element named TEXT; ANY is anything; an element without a rule
// may hold anything, but is a warning where no rule names it. Checking never refuses anything.
//
// Method: each rule becomes the automaton of its positions (Glushkov 1961); a set of positions
// walks over the children, so that no rule and no document makes it exponential.
#pragma once

#include "sgml/tree.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace schemas {

// The automaton of one rule.
class ContentModel {
public:
    struct Symbol {
        std::string name;                // an element's; "TEXT"; "ANY"
        std::vector<std::uint16_t> next; // positions that may follow
    };
    // LIMIT: symbols of one rule, after its `$names` are put in.
    static constexpr std::size_t longest = 500;
    // LIMIT: nested parentheses.
    static constexpr int deepest = 50;

    [[nodiscard]] static ContentModel parse(std::string_view rule, std::string& fault);

    struct Verdict {
        std::size_t wrong; // index of the first child that does not belong; children.size(): none
        bool incomplete;   // all belong, but something more must follow
        std::string expected; // "HEADING, PARAGRAPH or the end"
    };
    // Children are names of elements; "" stands for content in braces.
    [[nodiscard]] Verdict check(const std::vector<std::string_view>& children) const;
    // The names that may come in before the child at `index`, so that all of them belong; in the
    // rule's order, each once. Nothing where the children before it do not belong.
    [[nodiscard]] std::vector<std::string> allowedAt(const std::vector<std::string_view>& children,
                                                     std::size_t index) const;
    [[nodiscard]] const std::vector<Symbol>& symbols() const { return symbols_; }

private:
    friend class ContentModelParser;
    // The positions after the first `count` children.
    [[nodiscard]] std::vector<std::uint16_t> reached(const std::vector<std::string_view>& children,
                                                     std::size_t count) const;
    // For each position: do the children from `index` on belong behind it, up to an end?
    [[nodiscard]] std::vector<bool> goesOn(const std::vector<std::string_view>& children,
                                           std::size_t index) const;
    [[nodiscard]] std::string expectedAfter(const std::vector<std::uint16_t>& positions,
                                            bool mayEnd) const;
    std::vector<Symbol> symbols_; // 0 is the start
    std::vector<bool> final_;
};

// A fault of an element, by a node and a place in it, which moves with the node.
struct Finding {
    enum class Where { startTag, endTag, attribute };
    sgml::NodeId node = sgml::noNode; // the element, or a child of it
    Where where = Where::startTag;
    text::Range attribute{}; // counted from the start of the start tag
    std::string message;
    // A warning without line and column.
    [[nodiscard]] sgml::Fault fault(const sgml::Tree& tree) const;
};
// Of an attribute as the tree gives it.
[[nodiscard]] Finding atAttribute(const sgml::Tree& tree, sgml::NodeId element,
                                  const sgml::Attribute& attribute, std::string message);

class StructureSchema {
public:
    // Rules with faults are left out; each fault has the line of the file.
    [[nodiscard]] static StructureSchema parse(std::string_view text,
                                               std::vector<sgml::Fault>& faults);
    [[nodiscard]] bool saysSomething() const { return !rules_.empty(); }
    // The elements that have a rule, in the order of their names.
    [[nodiscard]] std::vector<std::string> names() const;
    // The content that an element may hold; null without a rule.
    [[nodiscard]] const ContentModel* model(std::string_view element) const;
    // Does the element's rule list the attribute? ID is not listed.
    [[nodiscard]] bool hasAttribute(std::string_view element, std::string_view attribute) const;

    // The violations of the schema by the nested or whole document at `documentNode`, as warnings
    // in order of place. Nested documents of its own are left to their own class's schema.
    [[nodiscard]] std::vector<sgml::Fault> check(const sgml::Tree& tree,
                                                 sgml::NodeId documentNode) const;
    // Of one element, which is no DOCUMENT. It depends on the names of its children and on its own
    // start tag and on nothing else.
    [[nodiscard]] std::vector<Finding> judge(const sgml::Tree& tree, sgml::NodeId element) const;

private:
    struct Rule {
        ContentModel model;
        std::vector<std::string> attributes;
    };
    friend class StructureParser;
    void judgeAttributes(const sgml::Tree& tree, sgml::NodeId element, const Rule& rule,
                         std::vector<Finding>& findings) const;
    std::map<std::string, Rule, std::less<>> rules_;
};

} // namespace schemas

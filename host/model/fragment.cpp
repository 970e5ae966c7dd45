#include "model/fragment.h"

#include <set>

namespace model {

using sgml::NodeId;
using sgml::noNode;

namespace {

class Fragment {
public:
    explicit Fragment(const sgml::Tree& tree) : tree_(tree) {}

    std::string of(text::Range interval) const {
        const NodeId first = contentAt(interval.from), last = contentAt(interval.to);
        if (first == noNode || last == noNode)
            return {};
        const NodeId around = commonElement(first, last);
        if (!tree_.isElement(around))
            return {};
        std::string inside;
        if (first == last) {
            inside = braced(first, interval);
        } else {
            NodeId left = first, right = last;
            const std::string begin =
                upwards(left, around, braced(first, {interval.from, contentEnd(first)}), true);
            const std::string end =
                upwards(right, around, braced(last, {contentBegin(last), interval.to}), false);
            inside = begin + bytes(tree_.node(left).range.to, tree_.node(right).range.from) + end;
        }
        return startTag(around) + inside + endTag(around);
    }

private:
    [[nodiscard]] NodeId contentAt(std::size_t place) const {
        const NodeId node = tree_.innermostAt(place);
        return node != noNode && tree_.node(node).kind == sgml::NodeKind::content ? node : noNode;
    }
    [[nodiscard]] std::size_t contentBegin(NodeId content) const {
        return tree_.contentRange(content).from;
    }
    [[nodiscard]] std::size_t contentEnd(NodeId content) const {
        return tree_.contentRange(content).to;
    }
    [[nodiscard]] std::string bytes(std::size_t from, std::size_t to) const {
        return std::string(tree_.text({from, to}));
    }
    [[nodiscard]] std::string startTag(NodeId element) const {
        return std::string(tree_.text(tree_.node(element).startTag));
    }
    [[nodiscard]] std::string endTag(NodeId element) const {
        return "</" + std::string(tree_.name(element)) + ">";
    }

    // A cut between bare braces would leave one of them without its partner.
    [[nodiscard]] std::string braced(NodeId content, text::Range part) const {
        const sgml::Unescaped of = tree_.unescaped(content);
        const std::size_t from = of.textOffset(part.from);
        const std::size_t to =
            part.to >= contentEnd(content) ? of.text().size() : of.textOffset(part.to);
        return "{" + sgml::escaped(std::string_view(of.text()).substr(from, to - from)) + "}";
    }

    [[nodiscard]] NodeId commonElement(NodeId a, NodeId b) const {
        std::set<NodeId> around;
        for (NodeId node = tree_.node(a).parent; node != noNode; node = tree_.node(node).parent)
            around.insert(node);
        NodeId node = tree_.node(b).parent;
        while (node != noNode && !around.contains(node))
            node = tree_.node(node).parent;
        return node;
    }

    // What is behind the node (or before it) in the elements around it, up to a child of `around`,
    // which `node` becomes.
    [[nodiscard]] std::string upwards(NodeId& node, NodeId around, std::string part,
                                      bool behind) const {
        for (NodeId parent = tree_.node(node).parent; parent != around;
             parent = tree_.node(node).parent) {
            const text::Range own = tree_.node(node).range, outer = tree_.node(parent).range;
            part = behind ? startTag(parent) + part + bytes(own.to, outer.to)
                          : bytes(outer.from, own.from) + part + endTag(parent);
            node = parent;
        }
        return part;
    }

    const sgml::Tree& tree_;
};

} // namespace

std::string fragment(const sgml::Tree& tree, text::Range interval) {
    return Fragment(tree).of(interval);
}

} // namespace model

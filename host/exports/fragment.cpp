#include "exports/fragment.h"

#include <set>

namespace exports {

using sgml::NodeId;
using sgml::noNode;

namespace {

// An element in which the interval ends: its part of the content there, and the place from which
// on, or up to which, the element's bytes are taken whole.
struct End {
    NodeId parent = noNode;
    std::size_t at = 0;
    std::string part{};
};

class Fragment {
public:
    explicit Fragment(const sgml::Tree& tree) : tree_(tree) {}

    std::string of(text::Range interval) const {
        const NodeId first = contentAt(interval.from), last = contentAt(interval.to);
        End begin = endIn(first, interval.from), end = endIn(last, interval.to);
        const NodeId around = commonElement(begin.parent, end.parent);
        if (!tree_.isElement(around))
            return {};
        if (first != noNode && first == last)
            return startTag(around) + braced(first, interval) + endTag(around);
        if (first != noNode) {
            begin.at = tree_.node(first).range.to;
            begin.part = braced(first, {interval.from, contentEnd(first)});
        }
        if (last != noNode) {
            end.at = tree_.node(last).range.from;
            end.part = braced(last, {contentBegin(last), interval.to});
        }
        for (; begin.parent != around; begin.parent = tree_.node(begin.parent).parent) {
            const std::size_t to = tree_.node(begin.parent).range.to;
            begin.part = startTag(begin.parent) + begin.part + bytes(begin.at, to);
            begin.at = to;
        }
        for (; end.parent != around; end.parent = tree_.node(end.parent).parent) {
            const std::size_t from = tree_.node(end.parent).range.from;
            end.part = bytes(from, end.at) + end.part + endTag(end.parent);
            end.at = from;
        }
        return startTag(around) + begin.part + bytes(begin.at, end.at) + end.part + endTag(around);
    }

private:
    // The content that a place is in, its ends included.
    [[nodiscard]] NodeId contentAt(std::size_t place) const {
        const NodeId node = tree_.innermostAt(place);
        const bool isContent = node != noNode && tree_.node(node).kind == sgml::NodeKind::content;
        return isContent && contentBegin(node) <= place ? node : noNode;
    }
    // A place beside a figure, say, is between two tags.
    [[nodiscard]] End endIn(NodeId content, std::size_t place) const {
        if (content != noNode)
            return {tree_.node(content).parent, place};
        NodeId node = tree_.innermostAt(place);
        const auto holds = [&](NodeId id) {
            return tree_.isElement(id) && tree_.node(id).startTag.to <= place &&
                   place <= tree_.node(id).endTag.from;
        };
        while (node != noNode && !holds(node))
            node = tree_.node(node).parent;
        return {node, place};
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

    // The innermost of those that are around both, themselves included.
    [[nodiscard]] NodeId commonElement(NodeId a, NodeId b) const {
        std::set<NodeId> around;
        for (NodeId node = a; node != noNode; node = tree_.node(node).parent)
            around.insert(node);
        NodeId node = b;
        while (node != noNode && !around.contains(node))
            node = tree_.node(node).parent;
        return node;
    }

    const sgml::Tree& tree_;
};

} // namespace

std::string fragment(const sgml::Tree& tree, text::Range interval) {
    return Fragment(tree).of(interval);
}

} // namespace exports

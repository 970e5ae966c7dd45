#include "source/marks.h"

#include <algorithm>

namespace source {

using sgml::NodeId, sgml::noNode, sgml::NodeKind;

namespace {

class TreeMarker {
public:
    TreeMarker(const sgml::Tree& tree, text::Range range,
               const std::function<bool(std::string_view)>& isText)
        : tree_(tree), range_(range), isText_(isText) {}

    std::vector<Mark> marks() {
        const NodeId first = tree_.innermostAt(range_.from);
        for (NodeId node = first; node != noNode; node = parentOf(node))
            mark(node);
        for (NodeId node = tree_.following(first);
             node != noNode && tree_.node(node).range.from < range_.to;
             node = tree_.following(node))
            mark(node);
        const auto isBefore = [](const Mark& a, const Mark& b) {
            return a.range.from < b.range.from;
        };
        std::ranges::stable_sort(marks_, isBefore);
        return std::move(marks_);
    }

private:
    [[nodiscard]] NodeId parentOf(NodeId node) const {
        return node == tree_.root() ? noNode : tree_.node(node).parent;
    }

    void add(text::Range range, Kind kind) {
        if (!range.empty() && range.from < range_.to && range.to > range_.from)
            marks_.push_back({range, kind});
    }

    void mark(NodeId id) {
        const sgml::Node& node = tree_.node(id);
        switch (node.kind) {
        case NodeKind::document:
            if (!node.name.empty())
                add({node.range.from, node.name.to}, Kind::word);
            break;
        case NodeKind::element:
            markStartTag(id);
            add(node.endTag, Kind::tag);
            break;
        case NodeKind::content:
            if (isScene(id))
                add(node.range, Kind::scene);
            break;
        case NodeKind::stray:
            add(node.range, Kind::stray);
            break;
        }
    }

    void markStartTag(NodeId id) {
        const text::Range tag = tree_.node(id).startTag;
        std::size_t at = tag.from;
        for (const sgml::Attribute& attribute : tree_.attributes(id)) {
            add({at, attribute.name.from}, Kind::tag);
            // With its quotes.
            const std::size_t value =
                std::clamp(attribute.value.from, attribute.name.to + 1, attribute.whole.to + 1) - 1;
            add({attribute.name.from, value}, Kind::attribute);
            add({value, attribute.whole.to}, Kind::value);
            at = attribute.whole.to;
        }
        add({std::min(at, tag.to), tag.to}, Kind::tag);
    }

    [[nodiscard]] bool isScene(NodeId content) const {
        NodeId node = tree_.node(content).parent;
        while (node != noNode && tree_.node(node).kind != NodeKind::document)
            node = parentOf(node);
        return node != noNode && !isText_(tree_.name(node));
    }

    const sgml::Tree& tree_;
    text::Range range_;
    const std::function<bool(std::string_view)>& isText_;
    std::vector<Mark> marks_;
};

} // namespace

std::vector<Mark> marksOf(const sgml::Tree& tree, text::Range range,
                          const std::function<bool(std::string_view)>& isText) {
    return TreeMarker(tree, range, isText).marks();
}

QColor colorOf(Kind kind, bool isDark) {
    switch (kind) {
    case Kind::word:
    case Kind::tag:
        return isDark ? QColor(138, 180, 248) : QColor(28, 78, 156);
    case Kind::attribute:
        return isDark ? QColor(215, 174, 251) : QColor(116, 56, 150);
    case Kind::value:
        return isDark ? QColor(246, 194, 139) : QColor(138, 70, 6);
    case Kind::scene:
        return isDark ? QColor(129, 216, 160) : QColor(10, 98, 52);
    case Kind::stray:
        return isDark ? QColor(255, 148, 138) : QColor(176, 32, 28);
    case Kind::comment:
        return isDark ? QColor(176, 181, 188) : QColor(86, 91, 98);
    }
    return {};
}

QColor bandColor(bool isDark) { return isDark ? QColor(48, 58, 74) : QColor(232, 240, 252); }
QColor numberColor(bool isDark) { return isDark ? QColor(170, 174, 182) : QColor(92, 97, 106); }

} // namespace source

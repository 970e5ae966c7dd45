// Sections are moved as wholes, found by their headings.
#include "authoring/commands.h"
#include "manuscript/places.h"

namespace authoring {

using schemas::ContainerRole;
using sgml::NodeId, sgml::noNode;

namespace {

class Sections {
public:
    explicit Sections(const Manuscript& manuscript)
        : manuscript_(manuscript), tree_(manuscript.document.tree()) {}

    [[nodiscard]] bool isSection(NodeId id) const { return roleOf(id) == ContainerRole::section; }

    // The section that a heading begins, or noNode.
    [[nodiscard]] NodeId of(NodeId heading) const {
        if (!tree_.holds(heading) || roleOf(heading) != ContainerRole::heading)
            return noNode;
        const NodeId parent = tree_.node(heading).parent;
        return isSection(parent) ? parent : noNode;
    }
    // The section beside it in what holds both, or noNode.
    [[nodiscard]] NodeId beside(NodeId section, Direction direction) const {
        NodeId before = noNode;
        const NodeId parent = tree_.node(section).parent;
        bool isBehind = false;
        for (NodeId id = tree_.childElement(parent); id != noNode; id = tree_.nextElement(id)) {
            if (id == section) {
                if (direction == Direction::backward)
                    return before;
                isBehind = true;
            } else if (isSection(id)) {
                if (isBehind)
                    return id;
                before = id;
            }
        }
        return noNode;
    }
    [[nodiscard]] NodeId firstSectionIn(NodeId section) const {
        for (NodeId id = tree_.childElement(section); id != noNode; id = tree_.nextElement(id))
            if (isSection(id))
                return id;
        return noNode;
    }
    [[nodiscard]] NodeId lastElementIn(NodeId section) const {
        NodeId last = noNode;
        for (NodeId id = tree_.childElement(section); id != noNode; id = tree_.nextElement(id))
            last = id;
        return last;
    }
    [[nodiscard]] int depthOf(NodeId section) const {
        int depth = 0;
        for (NodeId id = section; id != noNode; id = tree_.node(id).parent)
            depth += isSection(id) ? 1 : 0;
        return depth;
    }

private:
    [[nodiscard]] ContainerRole roleOf(NodeId id) const {
        if (!tree_.isElement(id))
            return ContainerRole::none;
        NodeId of = id;
        while (of != noNode && tree_.node(of).kind != sgml::NodeKind::document)
            of = tree_.node(of).parent;
        if (of == noNode)
            return ContainerRole::none;
        const Grammar* grammar = manuscript_.grammars.of(tree_.name(of));
        return grammar ? grammar->of(tree_.name(id)).role : ContainerRole::none;
    }

    const Manuscript& manuscript_;
    const sgml::Tree& tree_;
};

Refusal withoutSection() {
    return refused(QStringLiteral("This heading has no section that could be moved."));
}

} // namespace

Result moveSection(const Manuscript& manuscript, NodeId heading, Direction direction) {
    const Sections sections(manuscript);
    const NodeId section = sections.of(heading);
    if (section == noNode)
        return withoutSection();
    if (const NodeId beside = sections.beside(section, direction); beside != noNode)
        return moveElement(manuscript, section, beside, direction);
    const NodeId around = manuscript.document.tree().node(section).parent;
    const NodeId next = sections.isSection(around) ? sections.beside(around, direction) : noNode;
    if (next == noNode)
        return refused(direction == Direction::backward
                           ? QStringLiteral("This is the first section already.")
                           : QStringLiteral("This is the last section already."));
    const NodeId first = sections.firstSectionIn(next);
    return direction == Direction::forward && first != noNode
               ? moveElement(manuscript, section, first, Direction::backward)
               : moveElement(manuscript, section, sections.lastElementIn(next), Direction::forward);
}

Result moveSection(const Manuscript& manuscript, NodeId heading, NodeId other, Beside where) {
    const Sections sections(manuscript);
    const NodeId section = sections.of(heading), to = sections.of(other);
    if (section == noNode || to == noNode)
        return withoutSection();
    if (where == Beside::inside)
        return moveElement(manuscript, section, sections.lastElementIn(to), Direction::forward);
    return moveElement(manuscript, section, to,
                       where == Beside::before ? Direction::backward : Direction::forward);
}

Result changeLevel(const Manuscript& manuscript, NodeId heading, int by) {
    const Sections sections(manuscript);
    const NodeId section = sections.of(heading);
    if (section == noNode)
        return withoutSection();
    const int level = sections.depthOf(section) + by;
    if (level < 1)
        return refused(QStringLiteral("This section is at the outermost level already."));
    const std::size_t at = manuscript.document.tree().node(heading).startTag.to;
    const std::size_t place = manuscript::place(manuscript, at, Direction::forward).value_or(at);
    return makeHeading(manuscript, {place, place}, level);
}

} // namespace authoring

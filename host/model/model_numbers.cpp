// Which elements count, their numbers, and the names by which one refers to them.
#include "model/model_walk.h"

#include <algorithm>

namespace model {

using sgml::NodeId;
using sgml::NodeKind;
using sgml::noNode;

// A line with nothing in it but empty words. LIMIT: what has many parts counts as more than that.
bool ModelWalk::isWithoutText(NodeId line, const Frame& frame) const {
    constexpr std::size_t most = 40;
    std::vector<std::string_view> names; // of elements in it
    std::size_t parts = 0;
    for (NodeId id = tree_.node(line).firstChild; id != noNode;) {
        const sgml::Node& node = tree_.node(id);
        const bool isContent = node.kind == NodeKind::content;
        if (++parts > most ||
            (isContent ? !tree_.unescaped(id).text().empty() : !tree_.isElement(id)))
            return false;
        if (!isContent)
            names.push_back(tree_.name(id));
        NodeId next = node.firstChild != noNode ? node.firstChild : node.next;
        for (NodeId up = id; next == noNode && tree_.node(up).parent != line;) {
            up = tree_.node(up).parent;
            next = tree_.node(up).next;
        }
        id = next;
    }
    return std::ranges::all_of(names, [&](std::string_view name) {
        return frame.presentation->styleNamed(name).display == schemas::Display::inlined;
    });
}

// A section counts from the first letter of its heading on. Until then, sections in it count as
// those of the section around it do.
bool ModelWalk::waitsForHeading(const Frame& section) const {
    if (section.style.role != schemas::ContainerRole::section || section.style.counter.empty())
        return false;
    const NodeId first = tree_.childElement(section.node);
    return first != noNode && isWithoutText(first, section) &&
           section.presentation->styleNamed(tree_.name(first)).role ==
               schemas::ContainerRole::heading;
}

void ModelWalk::beginNumbering(Frame& frame) {
    const schemas::ElementStyle& style = frame.style;
    frame.asked.isUncounted = waitsForHeading(frame);
    if (frame.asked.isUncounted) {
        frame.numbering.reference.clear();
    } else if (!style.counter.empty()) {
        frame.numbering.path = state_.counters.step(style.counter);
        const std::string& pattern = style.reference.empty() ? style.number : style.reference;
        frame.numbering.reference = withoutPunctuation(numbered(pattern, frame.numbering.path));
    }
    for (const std::string& counter : style.restart)
        state_.counters.restart(counter);
    // A heading has its section's number; an equation beside it has its own.
    const bool borrows = style.counter.empty() && state_.frames.back().asked.isUncounted;
    const bool isNumbered = !style.number.empty() && !borrows;
    frame.numbering.marker =
        isNumbered ? numbered(style.number, frame.numbering.path) : style.marker;
    const std::string id =
        tree_.isElement(frame.node) ? attribute(frame.node, "ID") : std::string{};
    if (id.empty())
        return;
    trail_.back().names.push_back({id, frame.numbering.reference});
    if (style.show)
        state_.anchors.push_back(id);
}

void ModelWalk::endNumbering(const Frame& frame) {
    for (const std::string& counter : frame.style.restart)
        state_.counters.leaveRestart(counter);
    if (!frame.style.counter.empty() && !frame.asked.isUncounted)
        state_.counters.leaveStep(frame.style.counter);
}

} // namespace model

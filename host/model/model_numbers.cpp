// Which elements count, their numbers, and the names by which one refers to them.
#include "model/model_walk.h"

#include "schemas/number_pattern.h"
#include "text/characters.h"

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

namespace {

// In one line, of a length that a sentence takes.
std::string asReference(const std::string& words) {
    constexpr std::size_t longest = 80; // bytes
    std::string line;
    for (const char c : words) {
        const bool isBlank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!isBlank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (line.ends_with(' '))
        line.pop_back();
    if (line.size() <= longest)
        return line;
    return line.substr(0, text::characterStart(line, longest)) + "\u2026";
}

// "Figure 1" is not broken between its words.
std::string unbroken(std::string number) {
    for (std::size_t at = number.find(' '); at != number.npos; at = number.find(' ', at))
        number.replace(at, 1, "\u00A0");
    return number;
}

Reference referenceTo(const schemas::ElementStyle& style, const std::vector<int>& path) {
    const std::string& named = style.reference.empty() ? style.number : style.reference;
    const std::string name = schemas::withoutPunctuation(schemas::numbered(named, path));
    if (!style.referenceNumber.empty())
        return {unbroken(name), unbroken(schemas::numbered(style.referenceNumber, path))};
    const std::string number =
        schemas::withoutPunctuation(schemas::numbered(schemas::withoutWords(named), path));
    return {unbroken(name), unbroken(number.empty() ? name : number)};
}

} // namespace

// A reference to a section whose heading shows no number has the heading's words.
std::string ModelWalk::referringHeading(const Frame& section) const {
    const bool isCounted =
        section.style.role == schemas::ContainerRole::section && !section.style.counter.empty();
    const NodeId first = isCounted ? tree_.childElement(section.node) : noNode;
    if (first == noNode)
        return {};
    schemas::Presentation::Progress progress = section.progress;
    const schemas::ElementStyle style =
        section.presentation->style({.name = tree_.name(first)}, section.style, progress);
    if (style.role != schemas::ContainerRole::heading || !style.number.empty())
        return {};
    std::string words;
    for (NodeId id = tree_.node(first).firstChild; id != noNode;) {
        const bool isShown =
            !tree_.isElement(id) ||
            section.presentation->styleNamed(tree_.name(id)).display == schemas::Display::inlined;
        if (tree_.node(id).kind == NodeKind::content)
            words += tree_.unescaped(id).text();
        id = isShown ? tree_.following(id, first) : tree_.followingSkippingChildren(id, first);
    }
    return asReference(words);
}

void ModelWalk::beginNumbering(Frame& frame) {
    const schemas::ElementStyle& style = frame.style;
    frame.asked.isUncounted = waitsForHeading(frame);
    frame.asked.heading = referringHeading(frame);
    if (frame.asked.isUncounted) {
        frame.numbering.reference = {};
    } else if (!style.counter.empty()) {
        frame.numbering.path = state_.counters.step(style.counter);
        frame.numbering.reference = frame.asked.heading.empty()
                                        ? referenceTo(style, frame.numbering.path)
                                        : Reference{frame.asked.heading, frame.asked.heading};
    }
    for (const std::string& counter : style.restart)
        state_.counters.restart(counter);
    // A heading has its section's number; an equation beside it has its own.
    const bool borrows = style.counter.empty() && state_.frames.back().asked.isUncounted;
    const bool isNumbered = !style.number.empty() && !borrows;
    frame.numbering.marker =
        isNumbered ? schemas::numbered(style.number, frame.numbering.path) : style.marker;
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

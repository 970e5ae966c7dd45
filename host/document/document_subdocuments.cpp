// The subdocuments of a Document: found in the tree, known by number, described by attributes.
#include "document/document.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace document {

using sgml::NodeId;
using sgml::noNode;

std::optional<double> numberIn(std::optional<std::string_view> attribute, double least,
                               double most) {
    double number = 0;
    if (!attribute)
        return std::nullopt;
    const char* const last = attribute->data() + attribute->size();
    const auto [end, error] = std::from_chars(attribute->data(), last, number);
    const bool sound = error == std::errc{} && end == last && std::isfinite(number);
    return sound && number >= least && number <= most ? std::optional(number) : std::nullopt;
}

namespace {

Placement placementOf(std::string_view text) {
    if (text == "left")
        return Placement::left;
    if (text == "center")
        return Placement::center;
    if (text == "right")
        return Placement::right;
    return text == "inline" ? Placement::inlined : Placement::unspecified;
}

} // namespace

std::vector<SubdocumentId> Document::subdocuments() const { return order_; }

const Subdocument* Document::subdocument(SubdocumentId id) const {
    const auto found = subdocuments_.find(id);
    return found == subdocuments_.end() ? nullptr : &found->second;
}

SubdocumentId Document::subdocumentOf(NodeId documentElement) const {
    const auto found = byElement_.find(documentElement);
    return found == byElement_.end() ? noSubdocument : found->second;
}

SubdocumentId Document::subdocumentNamed(const std::string& name) const {
    for (const SubdocumentId id : order_)
        if (!name.empty() && subdocuments_.at(id).name == name)
            return id;
    return noSubdocument;
}

std::string Document::text(SubdocumentId id) const {
    const Subdocument* found = subdocument(id);
    return found == nullptr || found->content == noNode ? std::string{}
                                                        : tree_.unescaped(found->content).text();
}

bool Document::isBlank(SubdocumentId id) const {
    const Subdocument* found = subdocument(id);
    return found != nullptr && found->content != noNode &&
           tree_.text(tree_.contentRange(found->content)).find_first_not_of(" \t\r\n") ==
               std::string_view::npos;
}

text::Position Document::filePosition(SubdocumentId id, text::Position inText) const {
    return subdocument(id) == nullptr ? text::Position{}
                                      : tree_.position(fileOffsets(id, {inText}).front());
}

std::vector<std::size_t> Document::fileOffsets(SubdocumentId id,
                                               const std::vector<text::Position>& inText) const {
    const Subdocument* found = subdocument(id);
    if (found == nullptr || found->content == noNode)
        return std::vector<std::size_t>(
            inText.size(), found == nullptr ? 0 : tree_.node(found->element).range.from);
    const sgml::Unescaped unescaped = tree_.unescaped(found->content);
    const text::Places places(unescaped.text());
    std::vector<std::size_t> result;
    result.reserve(inText.size());
    for (const text::Position& position : inText)
        result.push_back(unescaped.fileOffset(places.offset(position)));
    return result;
}

// --- following a change ---------------------------------------------------------------------

std::vector<Document::Remembered> Document::rememberSubdocuments(const text::Edits& edits) const {
    std::vector<Remembered> all;
    all.reserve(order_.size());
    for (const SubdocumentId id : order_) {
        const Subdocument& subdocument = subdocuments_.at(id);
        Remembered one{.id = id, .at = tree_.node(subdocument.element).range.from};
        if (subdocument.content != noNode)
            one.spelled = tree_.contentRange(subdocument.content);
        const auto next =
            std::partition_point(edits.begin(), edits.end(), [&](const text::Edit& edit) {
                return edit.range.to < one.spelled.from;
            });
        one.isEdited = next != edits.end() && next->range.from <= one.spelled.to;
        if (one.isEdited)
            one.text = text(id);
        all.push_back(std::move(one));
    }
    return all;
}

std::string Document::textBefore(const Remembered& was, const text::Edits& edits) const {
    if (was.isEdited || was.spelled.empty())
        return was.text;
    const std::size_t from = text::movedByte(was.spelled.from, edits).value_or(0);
    return sgml::Unescaped(tree_.text({from, from + was.spelled.size()})).text();
}

std::set<SubdocumentId> Document::ownersOf(const std::vector<NodeId>& nodes) const {
    std::set<SubdocumentId> owners;
    for (NodeId id : nodes) {
        while (id != noNode && !byElement_.contains(id))
            id = tree_.node(id).parent;
        if (id != noNode)
            owners.insert(byElement_.at(id));
    }
    return owners;
}

// Subdocuments that the change takes away are kept for the way back, at their places.
std::set<SubdocumentId> Document::followStructure(const sgml::Change& told,
                                                  const std::vector<Remembered>& before,
                                                  Change& change, Direction direction) {
    const bool forward = direction == Direction::forward;
    const text::Edits& edits = forward ? change.forward : change.backward;
    auto& lost = forward ? change.lost : change.found;
    std::map<std::size_t, SubdocumentId> known = forward ? change.found : change.lost;
    const std::set<SubdocumentId> displaced = forgetSubdocuments(told);
    for (const Remembered& was : before)
        if (displaced.contains(was.id))
            if (const auto now = text::movedByte(was.at, edits))
                known[*now] = was.id;
    const std::size_t left = subdocuments_.size();
    if (told.everything)
        readSubdocuments(tree_.root(), known);
    std::vector<NodeId> nodes = told.texts;
    nodes.insert(nodes.end(), told.tags.begin(), told.tags.end());
    for (const sgml::Change::Children& children : told.children) {
        nodes.push_back(children.parent);
        for (const NodeId top : children.added)
            readSubdocuments(top, known);
    }
    if (!displaced.empty() || subdocuments_.size() != left)
        orderSubdocuments();
    for (const Remembered& was : before)
        if (!subdocuments_.contains(was.id))
            lost[was.at] = was.id;
    std::set<SubdocumentId> touched = ownersOf(nodes);
    for (const SubdocumentId id : touched)
        describe(id, subdocuments_.at(id).element);
    touched.insert(displaced.begin(), displaced.end());
    return touched;
}

// Those whose element is gone.
std::set<SubdocumentId> Document::forgetSubdocuments(const sgml::Change& told) {
    std::set<SubdocumentId> displaced;
    if (told.everything) {
        displaced.insert(order_.begin(), order_.end());
        byElement_.clear();
    }
    for (const NodeId id : told.gone)
        if (const auto found = byElement_.find(id); found != byElement_.end()) {
            displaced.insert(found->second);
            byElement_.erase(found);
        }
    for (const SubdocumentId id : displaced)
        subdocuments_.erase(id);
    return displaced;
}

// Those at or below `top` that stand where a known one must be keep its number and revision.
void Document::readSubdocuments(NodeId top, std::map<std::size_t, SubdocumentId>& known) {
    for (NodeId node = top; node != noNode; node = tree_.following(node, top)) {
        if (!tree_.isElement(node) || tree_.name(node) != "DOCUMENT")
            continue;
        const auto before = known.find(tree_.node(node).range.from);
        const bool isKnown = before != known.end() && !subdocuments_.contains(before->second);
        const SubdocumentId id = isKnown ? before->second : ++lastId_;
        byElement_[node] = id;
        describe(id, node);
    }
}

void Document::describe(SubdocumentId id, NodeId element) {
    Subdocument now = described(element);
    now.id = id;
    now.revision = revisions_[id];
    subdocuments_[id] = std::move(now);
}

void Document::orderSubdocuments() {
    order_.clear();
    for (const auto& [id, subdocument] : subdocuments_)
        order_.push_back(id);
    std::sort(order_.begin(), order_.end(), [&](SubdocumentId a, SubdocumentId b) {
        return tree_.isBefore(subdocuments_.at(a).element, subdocuments_.at(b).element);
    });
}

int Document::nextRevision(SubdocumentId id) {
    return subdocuments_.at(id).revision = ++revisions_[id];
}

Subdocument Document::described(NodeId element) const {
    Subdocument result;
    result.element = element;
    const NodeId document = tree_.node(element).firstChild;
    if (document == noNode || tree_.node(document).kind != sgml::NodeKind::document)
        return result;
    result.className = tree_.name(document);
    result.classElement = tree_.classElement(document);
    if (result.classElement == noNode)
        return result;
    const auto attribute = [&](std::string_view name) {
        return tree_.attribute(result.classElement, name);
    };
    result.name = attribute("ID").value_or("");
    result.width = numberIn(attribute("WIDTH"), 1, longestLength);
    result.height = numberIn(attribute("HEIGHT"), 1, longestLength);
    result.placement = placementOf(attribute("ALIGN").value_or(""));
    result.poster = numberIn(attribute("POSTER"), -1e12, 1e12);
    result.alternative = attribute("ALT").value_or("");
    result.presentation = attribute("PRESENTATION").value_or("");
    const NodeId storage = tree_.childElement(result.classElement);
    if (storage != noNode) {
        result.storage = tree_.name(storage);
        result.content = tree_.content(storage);
        // Behind a tag that is not closed there is no place for a text.
        result.hasText =
            result.content != noNode || (tree_.node(storage).firstChild == noNode &&
                                         tree_.text(tree_.node(storage).startTag).ends_with('>'));
    }
    return result;
}

} // namespace document

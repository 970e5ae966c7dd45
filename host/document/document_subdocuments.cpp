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
    for (const text::Position& position : inText)
        result.push_back(unescaped.fileOffset(places.offset(position)));
    return result;
}

// Those that stand where a known one must be keep its number and revision.
void Document::readSubdocuments(const std::map<std::size_t, SubdocumentId>& known) {
    std::map<SubdocumentId, Subdocument> now;
    order_.clear();
    byElement_.clear();
    for (NodeId node = tree_.root(); node != noNode; node = tree_.following(node)) {
        if (!tree_.isElement(node) || tree_.name(node) != "DOCUMENT")
            continue;
        const auto before = known.find(tree_.node(node).range.from);
        const SubdocumentId id = before != known.end() ? before->second : ++lastId_;
        Subdocument subdocument = describe(node);
        subdocument.id = id;
        subdocument.revision = revisions_[id];
        order_.push_back(id);
        byElement_.emplace(node, id);
        now.emplace(id, std::move(subdocument));
    }
    subdocuments_ = std::move(now);
}

int Document::nextRevision(SubdocumentId id) {
    return subdocuments_.at(id).revision = ++revisions_[id];
}

Subdocument Document::describe(NodeId element) const {
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

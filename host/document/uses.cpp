#include "document/uses.h"

#include <algorithm>

namespace document {

using sgml::NodeId;
using sgml::noNode;

Uses::Uses(const Document& document, const schemas::Schemas& schemas)
    : ElementFollower(document), schemas_(schemas) {
    lookAtAll();
}

const Uses::Shown& Uses::shownIn(NodeId document) {
    static const Shown nothing;
    if (document == noNode)
        return nothing;
    const std::string_view name = tree().name(document);
    const auto known = classes_.find(name);
    if (known != classes_.end())
        return known->second;
    Shown& shown = classes_[std::string(name)];
    if (!schemas_.isText(name))
        return shown;
    shown = {.images = schemas_.presentation(name).namesShownAs("image"),
             .sliders = schemas_.presentation(name).namesShownAs("slider"),
             .formulas = schemas_.presentation(name).namesShownAs("formula"),
             .values = schemas_.presentation(name).namesShownAs("value")};
    shown.formulas.merge(schemas_.presentation(name).namesShownAs("equation"));
    return shown;
}

void Uses::look(NodeId element, NodeId in) {
    const Shown& shown = shownIn(in);
    if (shown.images.contains(tree().name(element)))
        images_.insert(element);
    else if (shown.sliders.contains(tree().name(element)))
        sliders_.insert(element);
    else if (shown.formulas.contains(tree().name(element)))
        formulas_.insert(element);
    else if (shown.values.contains(tree().name(element)))
        values_.insert(element);
    else
        forget(element);
}

void Uses::forget(NodeId node) {
    images_.erase(node);
    sliders_.erase(node);
    formulas_.erase(node);
    values_.erase(node);
}

void Uses::forgetAll() {
    images_.clear();
    sliders_.clear();
    formulas_.clear();
    values_.clear();
}

std::vector<NodeId> Uses::inOrder(const std::set<NodeId>& nodes) const {
    std::vector<NodeId> result(nodes.begin(), nodes.end());
    std::sort(result.begin(), result.end(), [&](NodeId a, NodeId b) {
        return tree().node(a).range.from < tree().node(b).range.from;
    });
    return result;
}

std::vector<ImageUse> Uses::images() const {
    std::vector<ImageUse> uses;
    for (const NodeId id : inOrder(images_)) {
        std::string file(tree().attribute(id, "FILE").value_or(""));
        uses.push_back({tree().node(id).startTag, file.empty() ? tree().contentText(id) : file});
    }
    return uses;
}

std::vector<SliderUse> Uses::sliders() const {
    std::vector<SliderUse> uses;
    if (sliders_.empty())
        return uses;
    std::map<std::string_view, SubdocumentId> named;
    for (const SubdocumentId id : document().subdocuments())
        named.try_emplace(document().subdocument(id)->name, id);
    for (const NodeId id : inOrder(sliders_)) {
        const auto of = named.find(tree().attribute(id, "OF").value_or(""));
        if (of != named.end() && !of->first.empty())
            uses.push_back({tree().node(id).startTag, of->second,
                            std::string(tree().attribute(id, "NAME").value_or(""))});
    }
    return uses;
}

std::vector<NodeId> Uses::formulas() const {
    std::vector<NodeId> contents;
    for (const NodeId id : inOrder(formulas_))
        if (tree().content(id) != noNode)
            contents.push_back(tree().content(id));
    return contents;
}

std::vector<NodeId> Uses::values() const { return inOrder(values_); }

} // namespace document

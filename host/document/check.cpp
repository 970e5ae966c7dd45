#include "document/check.h"

#include <algorithm>
#include <functional>

namespace document {

using sgml::NodeId;
using sgml::noNode;

std::vector<sgml::Fault> documentFaults(const Document& document, const schemas::Schemas& schemas,
                                        const QStringList& media) {
    std::vector<sgml::Fault> faults = document.faults();
    const std::vector<sgml::Fault> structure = structureFaults(document, schemas, media);
    faults.insert(faults.end(), structure.begin(), structure.end());
    std::stable_sort(faults.begin(), faults.end(), [](const sgml::Fault& a, const sgml::Fault& b) {
        return a.position < b.position;
    });
    return faults;
}

namespace {

// Of elements in texts that their class's presentation shows as `display`.
void eachShownAs(std::string_view display, const sgml::Tree& tree, const schemas::Schemas& schemas,
                 const std::function<void(NodeId)>& tell) {
    std::set<std::string, std::less<>> names;
    std::set<std::string_view> classes;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id)) {
        const std::string_view name = tree.name(id);
        if (tree.node(id).kind == sgml::NodeKind::document && classes.insert(name).second &&
            schemas.isText(name))
            names.merge(schemas.presentation(name).namesShownAs(display));
        if (tree.isElement(id) && names.contains(name))
            tell(id);
    }
}

} // namespace

std::vector<ImageUse> imageUses(const Document& document, const schemas::Schemas& schemas) {
    std::vector<ImageUse> uses;
    const sgml::Tree& tree = document.tree();
    eachShownAs("image", tree, schemas, [&](NodeId id) {
        std::string file(tree.attribute(id, "FILE").value_or(""));
        uses.push_back({tree.node(id).startTag, file.empty() ? tree.contentText(id) : file});
    });
    return uses;
}

std::vector<SliderUse> sliderUses(const Document& document, const schemas::Schemas& schemas) {
    std::vector<SliderUse> uses;
    const sgml::Tree& tree = document.tree();
    std::map<std::string, SubdocumentId> named;
    for (const SubdocumentId id : document.subdocuments())
        named.try_emplace(document.subdocument(id)->name, id);
    eachShownAs("slider", tree, schemas, [&](NodeId id) {
        const auto of = named.find(std::string(tree.attribute(id, "OF").value_or("")));
        if (of != named.end() && !of->first.empty())
            uses.push_back({tree.node(id).startTag, of->second,
                            std::string(tree.attribute(id, "NAME").value_or(""))});
    });
    return uses;
}

void placeFaults(std::vector<sgml::Fault>& faults, std::string_view bytes) {
    std::stable_sort(faults.begin(), faults.end(), [](const sgml::Fault& a, const sgml::Fault& b) {
        return a.range.from < b.range.from;
    });
    const text::Places places(bytes);
    for (sgml::Fault& fault : faults)
        fault.position = places.at(fault.range.from);
}

} // namespace document

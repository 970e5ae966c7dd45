#include "authoring/ids.h"

#include "sgml/edit.h"

#include <algorithm>
#include <map>

namespace authoring {

using sgml::NodeId;
using sgml::noNode;

Ids idsOf(const sgml::Tree& tree) {
    Ids ids;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id))
        if (tree.isElement(id))
            if (const auto name = tree.attribute(id, "ID"))
                ids.emplace(*name);
    return ids;
}

std::string freeId(const Ids& taken, std::string_view stem) {
    std::string name(stem);
    std::transform(name.begin(), name.end(), name.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    for (int number = 1;; ++number)
        if (std::string id = name + "-" + std::to_string(number); !taken.contains(id))
            return id;
}

namespace {

// The attributes that name the ID of another element: `TO="a"`, `TO="#a"`, `OF="a"`.
using References = std::multimap<std::string, std::pair<NodeId, std::string_view>, std::less<>>;

References referencesIn(const sgml::Tree& tree) {
    References found;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id))
        for (const std::string_view name : {"TO", "OF"})
            if (const auto value = tree.isElement(id) ? tree.attribute(id, name) : std::nullopt)
                found.emplace(value->substr(value->starts_with('#') ? 1 : 0), std::pair(id, name));
    return found;
}

// "pendulum" of "pendulum-2".
std::string_view stemOf(std::string_view id) {
    const std::size_t last = id.find_last_not_of("0123456789");
    const bool isNumbered = last != id.npos && last > 0 && last + 1 < id.size() && id[last] == '-';
    return isNumbered ? id.substr(0, last) : id;
}

} // namespace

std::string withFreeIds(const sgml::Tree& into, const std::string& bytes) {
    Ids taken = idsOf(into);
    const sgml::Tree tree = sgml::Tree::parse(bytes);
    References references = referencesIn(tree);
    text::Edits edits;
    const auto add = [&edits](const text::Edits& more) {
        edits.insert(edits.end(), more.begin(), more.end());
    };
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id)) {
        const auto name = tree.isElement(id) ? tree.attribute(id, "ID") : std::nullopt;
        if (!name || taken.emplace(*name).second)
            continue;
        const auto [first, last] = references.equal_range(*name);
        if (first == last) {
            add(sgml::attributeRemoval(tree, id, "ID"));
            continue;
        }
        const std::string fresh = freeId(taken, stemOf(*name));
        taken.insert(fresh);
        add(sgml::attributeEdit(tree, id, "ID", fresh));
        for (auto one = first; one != last; ++one) {
            const auto& [element, attribute] = one->second;
            const bool isLink = tree.attribute(element, attribute)->starts_with('#');
            add(sgml::attributeEdit(tree, element, attribute, (isLink ? "#" : "") + fresh));
        }
        references.erase(first, last);
    }
    text::putInOrder(edits);
    return text::applied(bytes, edits);
}

} // namespace authoring

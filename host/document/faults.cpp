#include "document/faults.h"

#include <algorithm>
#include <tuple>

namespace document {

using schemas::Finding;
using sgml::NodeId;
using sgml::noNode;

void NamedNodes::set(NodeId node, std::string_view name) {
    const auto known = names_.find(node);
    if (known != names_.end() && known->second == name)
        return;
    forget(node);
    Nodes& nodes = nodes_[std::string(name)];
    nodes.insert(node);
    names_[node] = name;
    if (nodes.size() == 2)
        several_.emplace(name);
}

void NamedNodes::forget(NodeId node) {
    const auto known = names_.find(node);
    if (known == names_.end())
        return;
    const auto nodes = nodes_.find(known->second);
    nodes->second.erase(node);
    if (nodes->second.size() < 2)
        several_.erase(known->second);
    if (nodes->second.empty())
        nodes_.erase(nodes);
    names_.erase(known);
}

// --- judging --------------------------------------------------------------------------------

Faults::Faults(const Document& document, const schemas::Schemas& schemas, QStringList media)
    : ElementFollower(document), schemas_(schemas), media_(std::move(media)) {
    lookAtAll();
}

const Faults::Class& Faults::classOf(NodeId document) {
    static const Class none;
    if (document == noNode)
        return none;
    const std::string_view name = tree().name(document);
    const auto known = classes_.find(name);
    if (known != classes_.end())
        return known->second;
    Class& made = classes_[std::string(name)];
    made.structure = schemas_.structure(name);
    if (schemas_.isText(name)) {
        made.references = schemas_.presentation(name).namesShownAs("reference");
        made.links = schemas_.presentation(name).namesShownAs("link");
    }
    return made;
}

void Faults::keep(NodeId node, std::vector<Finding> findings) {
    if (findings.empty())
        findings_.erase(node);
    else
        findings_[node] = std::move(findings);
}

void Faults::forget(NodeId node) {
    findings_.erase(node);
    for (NamedNodes* named : {&ids_, &referring_, &living_})
        named->forget(node);
}

void Faults::forgetAll() {
    findings_.clear();
    for (NamedNodes* named : {&ids_, &referring_, &living_})
        named->clear();
}

void Faults::look(NodeId element, NodeId in) {
    const Class& of = classOf(in);
    const bool isNested = tree().name(element) == "DOCUMENT";
    keep(element, of.structure != nullptr && !isNested ? of.structure->judge(tree(), element)
                                                       : std::vector<Finding>{});
    judgeIdentity(element, of);
}

// IDs name one element each; OF names a subdocument; TO, an element that has an ID.
void Faults::judgeIdentity(NodeId element, const Class& in) {
    const std::string_view name = tree().name(element);
    const auto set = [&](NamedNodes& named, std::optional<std::string_view> value) {
        if (value)
            named.set(element, *value);
        else
            named.forget(element);
    };
    set(ids_, tree().attribute(element, "ID"));
    const bool lives = name == "SLIDER" || name == "VALUE" || name == "CHART";
    set(living_, lives ? tree().attribute(element, "OF") : std::nullopt);
    std::optional<std::string_view> to = tree().attribute(element, "TO");
    if (to && !in.references.contains(name)) {
        if (to->starts_with('#') && in.links.contains(name))
            to->remove_prefix(1);
        else
            to.reset();
    }
    set(referring_, to);
}

void Faults::lookAtDocument(NodeId node) {
    std::vector<Finding> findings;
    const std::string name(tree().name(node));
    const NodeId element = tree().classElement(node);
    if (element != noNode) { // else: a fault of the format
        if (classOf(node).structure == nullptr && !schemas_.isText(name) &&
            !media_.contains(QString::fromStdString(name)))
            findings.push_back(
                {.node = element,
                 .message =
                     node == tree().root()
                         ? "documents of class " + name + " are not known; it is shown as it is"
                         : "no medium is known for class " + name + "; it is kept as it is"});
        judgeSizes(element, findings);
    }
    keep(node, std::move(findings));
}

void Faults::judgeSizes(NodeId classElement, std::vector<Finding>& findings) const {
    for (const sgml::Attribute& attribute : tree().attributes(classElement)) {
        const std::string_view name = tree().text(attribute.name),
                               value = tree().text(attribute.value);
        const auto add = [&](std::string message) {
            findings.push_back(
                schemas::atAttribute(tree(), classElement, attribute, std::move(message)));
        };
        const bool length = name == "WIDTH" || name == "HEIGHT";
        if (length && !numberIn(value, 1, longestLength))
            add(std::string(name) + " wants a number from 1 to 20000 (1/96 inch)");
        if (name == "POSTER" && !numberIn(value, -1e12, 1e12))
            add("POSTER wants a time in seconds");
        if (name == "ALIGN" && value != "left" && value != "center" && value != "right" &&
            value != "inline")
            add("ALIGN wants left, center, right or inline");
    }
}

// --- the list -------------------------------------------------------------------------------

void Faults::addRepeatedIds(std::vector<sgml::Fault>& faults) const {
    const auto place = [&](NodeId id) { return tree().node(id).range.from; };
    for (const std::string& name : ids_.severalTimes()) {
        const NamedNodes::Nodes& nodes = ids_.nodes().at(name);
        const NodeId first = *std::min_element(
            nodes.begin(), nodes.end(), [&](NodeId a, NodeId b) { return place(a) < place(b); });
        for (const NodeId node : nodes)
            if (node != first)
                faults.push_back(Finding{
                    .node = node, .message = "the ID " + name + " is given twice; the first counts"}
                                     .fault(tree()));
    }
}

void Faults::addBrokenReferences(std::vector<sgml::Fault>& faults) const {
    const auto add = [&](const NamedNodes::Nodes& nodes, const std::string& message) {
        for (const NodeId node : nodes)
            faults.push_back(Finding{.node = node, .message = message}.fault(tree()));
    };
    for (const auto& [id, nodes] : referring_.nodes())
        if (!ids_.has(id))
            add(nodes, "nothing has the ID " + id + " that this refers to");
    if (living_.nodes().empty())
        return;
    std::set<std::string_view> names;
    for (const SubdocumentId id : document().subdocuments())
        names.insert(document().subdocument(id)->name);
    for (const auto& [name, nodes] : living_.nodes())
        if (name.empty() || !names.contains(name))
            add(nodes, "no subdocument has the ID " + name);
}

std::vector<sgml::Fault> Faults::list() const {
    std::vector<sgml::Fault> faults;
    for (const auto& [node, findings] : findings_)
        for (const Finding& finding : findings)
            faults.push_back(finding.fault(tree()));
    addRepeatedIds(faults);
    addBrokenReferences(faults);
    const auto key = [](const sgml::Fault& fault) {
        return std::tie(fault.range.from, fault.range.to, fault.message);
    };
    std::sort(faults.begin(), faults.end(),
              [&](const sgml::Fault& a, const sgml::Fault& b) { return key(a) < key(b); });
    faults.resize(std::min(faults.size(), std::size_t{1000}));
    const std::vector<sgml::Fault>& ofFormat = document().faults();
    faults.insert(faults.begin(), ofFormat.begin(), ofFormat.end());
    std::inplace_merge(
        faults.begin(), faults.begin() + static_cast<std::ptrdiff_t>(ofFormat.size()), faults.end(),
        [](const sgml::Fault& a, const sgml::Fault& b) { return a.range.from < b.range.from; });
    placeFaults(faults, tree());
    return faults;
}

std::vector<sgml::Fault> documentFaults(const Document& document, const schemas::Schemas& schemas,
                                        const QStringList& media) {
    return Faults(document, schemas, media).list();
}

} // namespace document

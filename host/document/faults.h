// Everything that is wrong with a document itself, in step with it. session::OpenDocument adds
// faults that media find in their texts, and faults of named files.
#pragma once

#include "document/element_follower.h"
#include "schemas/schemas.h"

#include <QStringList>

#include <set>

namespace document {

// The nodes that have a name, and the names that nodes have.
class NamedNodes {
public:
    void set(sgml::NodeId node, std::string_view name);
    void forget(sgml::NodeId node);
    void clear() { *this = {}; }
    [[nodiscard]] bool has(const std::string& name) const { return nodes_.contains(name); }
    using Nodes = std::set<sgml::NodeId>;
    [[nodiscard]] const std::unordered_map<std::string, Nodes>& nodes() const { return nodes_; }
    [[nodiscard]] const std::set<std::string>& severalTimes() const { return several_; }

private:
    std::unordered_map<std::string, Nodes> nodes_;
    std::unordered_map<sgml::NodeId, std::string> names_;
    std::set<std::string> several_; // names of two nodes or more
};

// Faults of the format, what its schemas do not allow, references to nothing. Elements that a
// change did not reach are not judged again.
class Faults final : public ElementFollower {
public:
    // `media`: classes that some installed medium serves; what is wrong inside their texts, only
    // the media know.
    Faults(const Document& document, const schemas::Schemas& schemas, QStringList media);

    // In order of place, each with its line and column. LIMIT: the first 1,000 that are not of the
    // format.
    [[nodiscard]] std::vector<sgml::Fault> list() const;

private:
    struct Class {
        const schemas::StructureSchema* structure = nullptr;
        std::set<std::string, std::less<>> references, links; // elements that are shown so
    };
    void look(sgml::NodeId element, sgml::NodeId in) override;
    void lookAtDocument(sgml::NodeId node) override;
    void forget(sgml::NodeId node) override;
    void forgetAll() override;
    [[nodiscard]] const Class& classOf(sgml::NodeId document);
    void judgeIdentity(sgml::NodeId element, const Class& in);
    void judgeSizes(sgml::NodeId classElement, std::vector<schemas::Finding>& findings) const;
    void keep(sgml::NodeId node, std::vector<schemas::Finding> findings);
    void addRepeatedIds(std::vector<sgml::Fault>& faults) const;
    void addBrokenReferences(std::vector<sgml::Fault>& faults) const;

    const schemas::Schemas& schemas_;
    QStringList media_;
    std::map<std::string, Class, std::less<>> classes_;
    std::unordered_map<sgml::NodeId, std::vector<schemas::Finding>> findings_;
    NamedNodes ids_, referring_, living_; // by ID, by the ID they lead to, by their subdocument's
};

[[nodiscard]] std::vector<sgml::Fault>
documentFaults(const Document& document, const schemas::Schemas& schemas, const QStringList& media);

} // namespace document

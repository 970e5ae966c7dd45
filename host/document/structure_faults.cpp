// What schemas do not allow in a document and in its nested ones, and what its attributes mean.
#include "document/check.h"
#include "document/document.h"
#include "schemas/schemas.h"

#include <algorithm>
#include <set>

namespace document {

using sgml::NodeId;
using sgml::noNode;

namespace {

class Checker {
public:
    Checker(const Document& document, const schemas::Schemas& schemas, const QStringList& media)
        : tree_(document.tree()), schemas_(schemas), media_(media) {
        for (const SubdocumentId id : document.subdocuments())
            if (const Subdocument* known = document.subdocument(id); !known->name.empty())
                subdocuments_.insert(known->name);
    }

    std::vector<sgml::Fault> check() {
        for (NodeId id = tree_.root(); id != noNode; id = tree_.following(id)) {
            if (tree_.node(id).kind == sgml::NodeKind::document)
                checkDocument(id);
            if (tree_.isElement(id))
                checkIdentity(id);
        }
        checkReferences();
        place();
        return std::move(faults_);
    }

private:
    void checkDocument(NodeId id) {
        const std::string name(tree_.name(id));
        if (classes_.insert(name).second && schemas_.isText(name)) {
            references_.merge(schemas_.presentation(name).namesShownAs("reference"));
            links_.merge(schemas_.presentation(name).namesShownAs("link"));
        }
        const NodeId element = tree_.classElement(id);
        if (element == noNode)
            return; // a fault of the format
        const schemas::StructureSchema* schema = schemas_.structure(name);
        if (schema != nullptr) {
            const std::vector<sgml::Fault> faults = schema->check(tree_, id);
            faults_.insert(faults_.end(), faults.begin(), faults.end());
        } else if (!schemas_.isText(name) && !media_.contains(QString::fromStdString(name))) {
            warn(tree_.node(element).startTag,
                 id == tree_.root()
                     ? "documents of class " + name + " are not known; it is shown as it is"
                     : "no medium is known for class " + name + "; it is kept as it is");
        }
        checkSizes(element);
    }

    void checkSizes(NodeId element) {
        for (const sgml::Attribute& attribute : tree_.attributes(element)) {
            const std::string_view name = tree_.text(attribute.name),
                                   value = tree_.text(attribute.value);
            const bool length = name == "WIDTH" || name == "HEIGHT";
            if (length && !numberIn(value, 1, longestLength))
                warn(attribute.whole,
                     std::string(name) + " wants a number from 1 to 20000 (1/96 inch)");
            if (name == "POSTER" && !numberIn(value, -1e12, 1e12))
                warn(attribute.whole, "POSTER wants a time in seconds");
            if (name == "ALIGN" && value != "left" && value != "center" && value != "right" &&
                value != "inline")
                warn(attribute.whole, "ALIGN wants left, center, right or inline");
        }
    }

    // IDs name one element each; OF names a subdocument; TO, an element that has an ID, perhaps
    // further below.
    void checkIdentity(NodeId element) {
        const auto id = tree_.attribute(element, "ID");
        if (id && !ids_.insert(*id).second)
            warn(tree_.node(element).startTag,
                 "the ID " + std::string(*id) + " is given twice; the first counts");
        const std::string_view name = tree_.name(element);
        const auto of = tree_.attribute(element, "OF");
        const bool living = name == "SLIDER" || name == "VALUE" || name == "CHART";
        if (living && of && !subdocuments_.contains(*of))
            warn(tree_.node(element).startTag, "no subdocument has the ID " + std::string(*of));
        const auto to = tree_.attribute(element, "TO");
        if (to && references_.contains(name))
            referring_.emplace_back(element, *to);
        else if (to && to->starts_with('#') && links_.contains(name))
            referring_.emplace_back(element, to->substr(1));
    }

    void checkReferences() {
        for (const auto& [element, id] : referring_)
            if (!ids_.contains(id))
                warn(tree_.node(element).startTag,
                     "nothing has the ID " + std::string(id) + " that this refers to");
    }

    void warn(text::Range range, std::string message) {
        sgml::Fault fault;
        fault.severity = sgml::Severity::warning;
        fault.range = range;
        fault.message = std::move(message);
        faults_.push_back(std::move(fault));
    }

    // LIMIT: the first 1,000 are listed.
    void place() {
        placeFaults(faults_, tree_.bytes());
        faults_.resize(std::min(faults_.size(), std::size_t{1000}));
    }

    const sgml::Tree& tree_;
    const schemas::Schemas& schemas_;
    const QStringList& media_;
    std::set<std::string, std::less<>> subdocuments_; // their IDs
    std::set<std::string> classes_;
    std::set<std::string, std::less<>> references_, links_; // elements that are shown so
    std::set<std::string_view> ids_;
    std::vector<std::pair<NodeId, std::string_view>> referring_; // and to which ID
    std::vector<sgml::Fault> faults_;
};

} // namespace

std::vector<sgml::Fault> structureFaults(const Document& document, const schemas::Schemas& schemas,
                                         const QStringList& media) {
    return Checker(document, schemas, media).check();
}

} // namespace document

// What schemas do not allow in a document and in its nested ones, and what its attributes mean.
#include "document/document.h"
#include "document/schemas.h"

#include <algorithm>
#include <set>

namespace document {

using sgml::NodeId;
using sgml::noNode;

namespace {

class Checker {
public:
    Checker(const Document& document, const Schemas& schemas, const QStringList& media)
        : document_(document), tree_(document.tree()), schemas_(schemas), media_(media) {}

    std::vector<sgml::Fault> check() {
        for (NodeId id = tree_.root(); id != noNode; id = tree_.following(id)) {
            if (tree_.node(id).kind == sgml::NodeKind::document)
                checkDocument(id);
            if (tree_.isElement(id))
                checkIdentity(id);
        }
        place();
        return std::move(faults_);
    }

private:
    void checkDocument(NodeId id) {
        const std::string name(tree_.name(id));
        const NodeId element = tree_.classElement(id);
        if (element == noNode)
            return; // a fault of the format
        const StructureSchema* schema = schemas_.structure(name);
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

    // IDs name one element each; OF names a subdocument.
    void checkIdentity(NodeId element) {
        const auto id = tree_.attribute(element, "ID");
        if (id && !ids_.insert(*id).second)
            warn(tree_.node(element).startTag,
                 "the ID " + std::string(*id) + " is given twice; the first counts");
        const std::string_view name = tree_.name(element);
        const auto of = tree_.attribute(element, "OF");
        const bool living = name == "SLIDER" || name == "VALUE" || name == "CHART";
        if (living && of && document_.subdocumentNamed(std::string(*of)) == noSubdocument)
            warn(tree_.node(element).startTag, "no subdocument has the ID " + std::string(*of));
    }

    void warn(sgml::Range range, std::string message) {
        sgml::Fault fault;
        fault.severity = sgml::Severity::warning;
        fault.range = range;
        fault.message = std::move(message);
        faults_.push_back(std::move(fault));
    }

    // LIMIT: the first 1,000 are listed.
    void place() {
        std::stable_sort(
            faults_.begin(), faults_.end(),
            [](const sgml::Fault& a, const sgml::Fault& b) { return a.range.from < b.range.from; });
        faults_.resize(std::min(faults_.size(), std::size_t{1000}));
        std::vector<std::size_t> offsets;
        for (const sgml::Fault& fault : faults_)
            offsets.push_back(fault.range.from);
        const std::vector<sgml::Position> positions = sgml::positionsOf(tree_.bytes(), offsets);
        for (std::size_t i = 0; i < faults_.size(); ++i)
            faults_[i].position = positions[i];
    }

    const Document& document_;
    const sgml::Tree& tree_;
    const Schemas& schemas_;
    const QStringList& media_;
    std::set<std::string_view> ids_;
    std::vector<sgml::Fault> faults_;
};

} // namespace

std::vector<sgml::Fault> structureFaults(const Document& document, const Schemas& schemas,
                                         const QStringList& media) {
    return Checker(document, schemas, media).check();
}

} // namespace document

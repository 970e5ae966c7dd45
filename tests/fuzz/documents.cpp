// Any bytes are a document: read, checked, modelled and exported as text.
#include "require.h"

#include "document/document.h"
#include "document/faults.h"
#include "exports/text_export.h"
#include "model/model.h"
#include "schemas/schemas.h"

#include <cstdint>

namespace {

// Within the text and within its parent, after what comes before it.
void checkTree(const sgml::Tree& tree) {
    const std::size_t size = tree.bytes().size();
    for (sgml::NodeId id = 0; id < tree.size(); ++id) {
        const sgml::Node& node = tree.node(id);
        FUZZ_REQUIRE(node.range.from <= node.range.to && node.range.to <= size);
        if (node.parent != sgml::noNode) {
            const text::Range outer = tree.node(node.parent).range;
            FUZZ_REQUIRE(node.parent < id);
            FUZZ_REQUIRE(outer.from <= node.range.from && node.range.to <= outer.to);
        }
        if (node.next != sgml::noNode)
            FUZZ_REQUIRE(node.range.to <= tree.node(node.next).range.from);
        if (node.kind == sgml::NodeKind::content)
            FUZZ_REQUIRE(tree.unescaped(id).text().size() <= node.range.to - node.range.from);
    }
    for (const sgml::Fault& fault : tree.faults())
        FUZZ_REQUIRE(fault.range.from <= fault.range.to && fault.range.to <= size);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const schemas::Schemas schemas = schemas::Schemas::builtIn();
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    const document::Document document(bytes);
    FUZZ_REQUIRE(document.bytes() == bytes);
    checkTree(document.tree());
    for (const sgml::Fault& fault :
         document::documentFaults(document, schemas, {QStringLiteral("ANIMATION")}))
        FUZZ_REQUIRE(fault.range.to <= size && !fault.message.empty());
    const model::Model model =
        model::buildModel(document, schemas.presentation(document.className()), schemas);
    (void)exports::exportText(document, model);
    return 0;
}

// Any bytes are a document that is edited: after every edit, undo and redo the tree is the one that
// reading the bytes anew gives, and all undone gives the first bytes.
#include "input.h"
#include "require.h"

#include "document/document.h"

#include <vector>

namespace {

using document::Document;
using document::EditResult;

void checkTree(const Document& document) {
    FUZZ_REQUIRE(document.tree() == sgml::Tree::parse(document.bytes()));
}

text::Edits editsOf(fuzz::Input& input, std::size_t size) {
    text::Edits edits;
    const std::size_t count = 1 + input.below(3);
    std::size_t from = 0;
    for (std::size_t i = 0; i < count && from <= size; ++i) {
        const std::size_t start = from + input.below(size - from + 1);
        const std::size_t end = start + input.below(std::min<std::size_t>(size - start, 40) + 1);
        edits.push_back({{start, end}, std::string(input.last(input.below(12)))});
        from = end + 1;
    }
    return edits;
}

void editText(Document& document, fuzz::Input& input) {
    const std::vector<document::SubdocumentId> ids = document.subdocuments();
    if (ids.empty())
        return;
    const document::SubdocumentId id = ids[input.below(ids.size())];
    const std::string before = document.text(id);
    const text::Edits edits = editsOf(input, before.size());
    const int revision = document.subdocument(id)->revision;
    if (document.editText(id, revision, edits, QStringLiteral("text")) == EditResult::applied)
        FUZZ_REQUIRE(document.text(id) == text::applied(before, edits));
    FUZZ_REQUIRE(document.editText(id, revision - 1, edits, {}) != EditResult::applied);
}

void editContent(Document& document, fuzz::Input& input) {
    const auto node = static_cast<sgml::NodeId>(input.below(document.tree().size()));
    if (document.tree().node(node).kind != sgml::NodeKind::content)
        return;
    const std::string before = document.tree().unescaped(node).text();
    const std::size_t from = input.below(before.size() + 1);
    const text::Range range{from, from + input.below(before.size() - from + 1)};
    (void)document.edit(sgml::contentEdit(document.tree(), node, range, input.last(8)),
                        QStringLiteral("content"));
}

void change(Document& document, fuzz::Input& input) {
    switch (input.below(6)) {
    case 0:
        document.undo();
        break;
    case 1:
        document.redo();
        break;
    case 2:
        editContent(document, input);
        break;
    case 3:
        (void)document.edit(editsOf(input, document.bytes().size()), QStringLiteral("bytes"),
                            QStringLiteral("group"));
        break;
    default:
        editText(document, input);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    // The last tenth says what is done with what stands before it.
    const std::string_view script = input.last(size / 10 + 8);
    const std::string first(input.rest());
    fuzz::Input steps(reinterpret_cast<const std::uint8_t*>(script.data()), script.size());
    Document document(first);
    for (int i = 0; i < 30 && !steps.atEnd(); ++i) {
        change(document, steps);
        checkTree(document);
    }
    const std::string last = document.bytes();
    std::size_t undone = 0;
    for (; document.canUndo(); ++undone)
        document.undo();
    FUZZ_REQUIRE(document.bytes() == first);
    checkTree(document);
    for (; undone > 0; --undone)
        document.redo();
    FUZZ_REQUIRE(document.bytes() == last);
    checkTree(document);
    return 0;
}

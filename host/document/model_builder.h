// Builds a Model: one walk over the tree, with what is open on a stack of frames.
#pragma once

#include "document/document.h"
#include "document/model.h"
#include "document/numbering.h"
#include "document/presentation.h"
#include "document/schemas.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace document {

class ModelBuilder {
public:
    ModelBuilder(const Document& document, const Presentation& presentation,
                 const Schemas& schemas);
    // Walks over some more nodes; false: there are no more.
    [[nodiscard]] bool step(int nodes);
    // When all are walked over.
    [[nodiscard]] Model take();

private:
    // The block that runs are added to, the space before the next one, and where both go.
    struct Flow {
        Blocks* out = nullptr;
        std::shared_ptr<Block> last;      // of out
        std::vector<Row>* rows = nullptr; // inside a row but outside a cell: its table's
        bool open = false;                // the last block takes more runs
        bool pageBreak = false;
        double space = 0, padding = 0;
    };
    enum class Role { inlined, block, table, row, cell, footnote };
    struct Frame {
        sgml::NodeId node = sgml::noNode;
        Role role = Role::block;
        ElementStyle style;
        const Presentation* presentation = nullptr;
        Presentation::Progress progress;
        double indentLeft = 0, indentRight = 0; // from the text area's edges
        std::string target;                     // of the link that this is in
        std::string marker;                     // not yet shown
        std::vector<int> path;                  // of the innermost counter
        std::string reference;                  // what refers to its element
        std::size_t blockFrame = 0;             // index of the innermost one that is no inline
        std::size_t emitted = 0;                // blocks and runs before it was entered
        std::size_t firstBlock = 0;             // of those that it put into flow_.out
        std::size_t together = noBlock;         // the first block of what is kept together here
        std::size_t table = noBlock;            // role table: its block in flow_.out
        std::set<std::string_view> seen;        // names of the children so far
        Flow outer;                             // roles row, cell, footnote: to go back to
    };
    static constexpr std::size_t noBlock = static_cast<std::size_t>(-1);

    // the walk
    void walkOne();
    bool enter(sgml::NodeId node);
    bool enterElement(sgml::NodeId node);
    bool enterNested(sgml::NodeId node);
    [[nodiscard]] Frame frameInside(sgml::NodeId node) const;
    bool begin(Frame frame);
    void leave();

    // numbers and names
    void beginNumbering(Frame& frame);
    void endNumbering(const Frame& frame);
    void resolveReferences();

    // what elements become; true: their children are walked
    bool beginDisplay(Frame& frame);
    bool beginBlock(Frame& frame);
    void endBlock(Frame& frame);
    bool beginVerbatim(Frame& frame);
    void endVerbatim();
    bool beginTable(Frame& frame);
    bool beginRow(Frame& frame);
    bool beginCell(Frame& frame);
    bool beginFootnote(Frame& frame);
    bool beginUnknown(Frame& frame);
    bool beginReference(Frame& frame);
    bool addLiving(const Frame& frame);
    bool addChart(const Frame& frame);
    bool addImage(const Frame& frame);
    bool addLeaf(const Frame& frame, BlockKind kind);
    bool addSubdocument(sgml::NodeId node);
    void addGenerated(const Frame& frame, std::string_view name, const std::string& text);
    void addContent(sgml::NodeId content);
    void addFlowing(const sgml::Unescaped& text, sgml::NodeId content);
    void addLines(const sgml::Unescaped& text, sgml::NodeId content);
    void addStray(sgml::NodeId node);

    // blocks and runs
    Block& addBlock(BlockKind kind);
    void openText();
    void closeText() { flow_.open = false; }
    void enterCell(const BlockStyle& style, sgml::NodeId node);
    void takeMarker(Block& block);
    void dropMarker(Frame& frame);
    void addRun(Run run);
    void addText(std::string text, sgml::NodeId content = sgml::noNode, std::size_t offset = 0);
    [[nodiscard]] bool atLineStart() const;
    [[nodiscard]] std::uint32_t textStyle(const TextStyle& style) {
        return styles_->numberOf(style);
    }
    [[nodiscard]] const Frame& blockFrame() const;
    [[nodiscard]] std::string attribute(sgml::NodeId node, std::string_view name) const;
    [[nodiscard]] std::optional<double> lengthAttribute(sgml::NodeId node,
                                                        std::string_view name) const;
    bool isFirst(sgml::NodeId node);

    const Document& document_;
    const sgml::Tree& tree_;
    const Presentation& presentation_;
    const Schemas& schemas_;
    Model model_;
    std::vector<Frame> frames_;
    sgml::NodeId at_ = sgml::noNode; // the next one
    Flow flow_;
    Counters counters_;
    std::map<std::string, std::string> references_; // by ID
    std::vector<std::shared_ptr<Block>> referring_; // blocks with runs that wait for these
    std::shared_ptr<TextStyles> styles_;
    std::map<sgml::NodeId, SubdocumentId> subdocuments_;
    std::vector<std::string> anchors_; // of the next block
    std::size_t emitted_ = 0;
    std::size_t markers_ = 0; // that wait for a block
    int tables_ = 0;          // that are open
    int notes_ = 0;           // footnotes that are open
    int titles_ = 0;
    bool titled_ = false;
};

} // namespace document

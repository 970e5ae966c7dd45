// One walk over the tree, with what is open on a stack of frames: it makes the blocks of a model.
//
// A walk may rest where no block is open, in the outermost flow. There all that the rest of the
// walk depends on is a value, its State: from a state that was kept the walk can be taken up again,
// and two walks that meet with equal states before the same node go on equally.
#pragma once

#include "document/document.h"
#include "model/model.h"
#include "model/numbering.h"
#include "schemas/presentation.h"
#include "schemas/schemas.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace model {

// By which one refers to something: its number with its kind, or its name; and its number alone.
// "": by its ID.
struct Reference {
    std::string name, number;
    bool operator==(const Reference&) const = default;
};
// An ID, and how one refers to its element.
struct Name {
    std::string id;
    Reference reference;
    bool operator==(const Name&) const = default;
};

// Nothing: the author says none.
[[nodiscard]] std::optional<schemas::Align> alignOf(document::Placement placement);

class ModelWalk {
public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    // Space that waits for the next block.
    struct Gap {
        double space = 0, padding = 0;
        bool pageBreak = false;
        bool operator==(const Gap&) const = default;
    };
    // The block that runs are added to, the space before the next one, and where both go.
    struct Flow {
        Blocks* out = nullptr;
        Containers* containers = nullptr; // of these blocks
        std::shared_ptr<Block> last;      // of out
        std::vector<Row>* rows = nullptr; // inside a row but outside a cell: its table's
        bool open = false;                // the last block takes more runs
        Gap gap;
        bool operator==(const Flow&) const = default;
    };
    enum class Role { inlined, block, table, row, cell, footnote };
    struct Frame {
        // Answers about nodes behind the place of the walk, which an edit there may change.
        struct Asked {
            bool nested = false;             // a nested document of text
            bool holdsElements = false;      // of an unknown one
            bool isUncounted = false;        // a section whose heading waits for text
            std::string heading{};           // of a section by which one refers to it
            document::Placement placement{}; // of a figure: its subdocument's
            bool operator==(const Asked&) const = default;
        };
        struct Numbering {
            std::string marker;    // not yet shown
            std::vector<int> path; // of the innermost counter
            Reference reference;   // what refers to its element
            bool operator==(const Numbering&) const = default;
        };
        struct Indent { // from the text area's edges
            double left = 0, right = 0;
            bool operator==(const Indent&) const = default;
        };
        struct Content {
            bool empty = true;           // neither a block nor a run was made in it
            bool filled = false;         // it has a block in its flow
            bool boxed = false;          // its blocks have a frame or a background
            std::size_t together = none; // the first block of what is kept together here
            bool operator==(const Content&) const = default;
        };
        struct Table {
            std::size_t block = none; // in the flow
            std::vector<double> widths{};
            bool operator==(const Table&) const = default;
        };
        sgml::NodeId node = sgml::noNode;
        Role role = Role::block;
        schemas::ElementStyle style;
        const schemas::Presentation* presentation = nullptr;
        schemas::Presentation::Progress progress;
        Asked asked;
        Numbering numbering;
        Indent indent;
        Content content;
        Table table;                             // role table
        std::string target;                      // of the link that this is in
        std::size_t blockFrame = 0;              // index of the innermost one that is no inline
        std::array<int, 8> levels{};             // of each ContainerRole, here
        std::set<std::string, std::less<>> seen; // names of the children so far
        Flow outer;                              // roles row, cell, footnote: to go back to
        bool operator==(const Frame&) const = default;
    };
    struct State {
        std::vector<Frame> frames; // the document, and the elements from there to the one at hand
        sgml::NodeId at = sgml::noNode; // the next one
        Gap gap;
        Counters counters;
        std::vector<std::string> anchors; // of the next block
        std::size_t markers = 0;          // that wait for a block
        std::size_t footnotes = 0;        // so far
        bool titled = false;
        bool operator==(const State&) const = default;
    };
    // Of a frame, or none.
    struct Opened {
        std::size_t box = none, container = none;
    };
    // A place where a walk rested, and how much it had made.
    struct Checkpoint {
        State state;
        std::vector<Opened> opened; // by each frame
        std::size_t offset = 0;     // in the file, of the next node
        std::size_t blocksBefore = 0, boxesBefore = 0, containersBefore = 0;
    };
    // From a checkpoint to the next one.
    struct Segment {
        Checkpoint begin;
        std::vector<Name> names;            // of its elements, in their order
        std::vector<std::size_t> referring; // its blocks with references, counted from its first
        std::vector<std::size_t> valued;    // and those with values
    };
    using Trail = std::vector<Segment>;

    ModelWalk(const document::Document& document, const schemas::Presentation& presentation,
              const schemas::Schemas& schemas, std::shared_ptr<schemas::TextStyles> styles,
              int spacing);
    ModelWalk(const ModelWalk&) = delete;
    ModelWalk& operator=(const ModelWalk&) = delete;

    // Goes on from a checkpoint; `model` is what was made before it.
    void resume(const Checkpoint& from, Model model);
    // The assumptions that a checkpoint's frames made about nodes behind it still hold.
    [[nodiscard]] bool stillHolds(const Checkpoint& checkpoint) const;

    [[nodiscard]] bool isAtEnd() const { return state_.at == sgml::noNode; }
    [[nodiscard]] sgml::NodeId at() const { return state_.at; }
    // Walks over the next node.
    void next();
    [[nodiscard]] bool mayRest() const;
    [[nodiscard]] bool isAt(const Checkpoint& checkpoint) const;
    [[nodiscard]] Checkpoint checkpoint() const;

    // The model so far, and the segments of this walk alone. References are without their text.
    [[nodiscard]] Model& model() { return model_; }
    [[nodiscard]] Trail& trail() { return trail_; }

    // LIMIT: no checkpoint is made inside so many elements.
    static constexpr std::size_t deepestRest = 48;
    // LIMIT: of a table's columns so many have widths of their own.
    static constexpr std::size_t mostWidths = 1000;

private:
    // the walk
    bool enter(sgml::NodeId node);
    bool enterElement(sgml::NodeId node);
    bool enterNested(sgml::NodeId node);
    [[nodiscard]] const schemas::Presentation* presentationOf(sgml::NodeId nested) const;
    [[nodiscard]] Frame frameInside(sgml::NodeId node) const;
    void takeLanguage(Frame& frame, const Frame& outer) const;
    void takePlacement(Frame& frame) const;
    [[nodiscard]] document::Placement placementIn(const Frame& figure) const;
    bool begin(Frame frame);
    void leave();
    void push(Frame frame);
    void pop();

    // numbers and names
    [[nodiscard]] bool waitsForHeading(const Frame& section) const;
    [[nodiscard]] std::string referringHeading(const Frame& section) const;
    [[nodiscard]] bool isWithoutText(sgml::NodeId line, const Frame& frame) const;
    void beginNumbering(Frame& frame);
    void endNumbering(const Frame& frame);

    // what elements become; true: their children are walked
    bool beginDisplay(Frame& frame);
    bool beginBlock(Frame& frame);
    void endBlock(Frame& frame);
    bool beginVerbatim(Frame& frame);
    void endVerbatim();
    bool beginTable(Frame& frame);
    bool beginRow(Frame& frame);
    [[nodiscard]] std::vector<double> columnWidths(sgml::NodeId table) const;
    bool beginCell(Frame& frame);
    bool beginFootnote(Frame& frame);
    bool beginUnknown(Frame& frame);
    bool beginReference(Frame& frame);
    bool addLiving(const Frame& frame);
    bool addChart(const Frame& frame);
    bool addFormula(const Frame& frame);
    bool addEquation(const Frame& frame);
    [[nodiscard]] Run formulaRun(const Frame& frame, bool isAlone);
    [[nodiscard]] ValueLooks valueLooks(const Frame& frame);
    bool addContents();
    bool addImage(const Frame& frame);
    [[nodiscard]] Picture pictureOf(sgml::NodeId node) const; // but its source
    bool addLeaf(BlockKind kind);
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
    void enterCell(const schemas::BlockStyle& style, sgml::NodeId node);
    void takeMarker(Block& block);
    void dropMarker(Frame& frame);
    void addRun(Run run);
    void addText(std::string text, sgml::NodeId content = sgml::noNode, std::size_t offset = 0);
    void markFrames();
    void markReferring();
    void markValued(const Run& run);
    void mark(std::vector<std::size_t>& blocks) const; // the last block, in the segment's list
    void open(std::size_t frame);
    void close();
    [[nodiscard]] bool atLineStart() const;
    [[nodiscard]] std::uint32_t textStyle(const schemas::TextStyle& style) {
        return styles_->numberOf(style);
    }
    [[nodiscard]] const Frame& blockFrame() const;
    [[nodiscard]] std::string attribute(sgml::NodeId node, std::string_view name) const;
    [[nodiscard]] std::optional<double> lengthAttribute(sgml::NodeId node,
                                                        std::string_view name) const;
    bool isFirst(sgml::NodeId node);

    const document::Document& document_;
    const sgml::Tree& tree_;
    const schemas::Presentation& presentation_;
    const schemas::Schemas& schemas_;
    std::shared_ptr<schemas::TextStyles> styles_;
    Model model_;
    Trail trail_;
    State state_;                // its gap is that of the flow
    std::vector<Opened> opened_; // by each frame
    Flow flow_;
    const int spacing_;
    int sinceRest_ = 0; // nodes
    int tables_ = 0;    // that are open
    int notes_ = 0;     // footnotes that are open
    int titles_ = 0;
};

} // namespace model

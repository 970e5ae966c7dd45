// The content of a document as shown, in order: blocks of text with resolved styles, numbers and
// references, and the places of subdocuments; neither lines nor pages yet. The host's layout and
// the export as text both read it.
//
// Method: one walk over the tree with an explicit stack. A presentation says for each element what
// it is (its `display` and its `role`) and how it looks; what holds blocks is a range of them. An
// element that the presentation does not know is shown with `<TAG>` before its content. So the
// whole document is visible unless the presentation says `show: no`.
#pragma once

#include "document/subdocument.h"
#include "document/table_grid.h"
#include "document/value_use.h"
#include "formulas/formula.h"
#include "schemas/style.h"

#include <memory>
#include <string>
#include <vector>

namespace document {
class Document;
}
namespace schemas {
class Presentation;
class Schemas;
} // namespace schemas

namespace model {

enum class RunKind {
    text,
    subdocument, // inline, with ALIGN="inline"
    image,       // in the line
    footnote,    // the mark; `text` is its number
    slider,      // `text` stands for it
    value,       // `text` is its number as it is known now, and generated
    lineBreak,
    formula, // in the line or alone: `text` is it as plain text, and generated
};

struct Footnote;

// How a value looks: a number, one that is out of date, and what stands where there is none.
struct ValueLooks {
    std::uint32_t usual = 0, outdated = 0, faulty = 0; // in Model::textStyles
    std::string language{};                            // of the text around it
    bool operator==(const ValueLooks&) const = default;
};

// A value of a subdocument, in the line.
struct Value {
    document::ValueUse use{};
    ValueLooks looks{};
    std::string room{}; // while it plays: the widest number so far, each digit a 0; "": it does not
    bool operator==(const Value&) const = default;
};

struct Formula {
    std::string source; // TeX's mathematics
    formulas::Formula read;
    std::string spoken;                            // for who hears it
    bool isAlone = false;                          // set as a display
    ValueLooks looks{};                            // of its values
    std::vector<formulas::SuppliedValue> values{}; // of its calls
};

// An image's file, and how its author wants it.
struct Picture {
    std::string source{};                    // as written
    std::optional<double> width{}, height{}; // 1/96 inch
    std::string alternative{};               // ALT
    bool operator==(const Picture&) const = default;
};

// How a reference looks: usually, and where nothing has the ID that it names.
struct ReferenceLooks {
    std::uint32_t usual = 0, broken = 0; // in Model::textStyles
    bool operator==(const ReferenceLooks&) const = default;
};

// A piece of a line. Its letters are the bytes of `content` from `offset` on, unless content is
// noNode: then they are generated (a number, a reference, a mark) and cannot be edited.
// A line end in flowing text becomes one blank; what is left out there begins a new run.
struct Run {
    RunKind kind = RunKind::text;
    std::string text{};                  // UTF-8
    std::uint32_t style = 0;             // in Model::textStyles
    sgml::NodeId element = sgml::noNode; // the innermost element
    sgml::NodeId content = sgml::noNode;
    std::size_t offset = 0; // unescaped, of the text's first byte
    std::string target{};   // LINK: its address; REF: "#" and the ID
    bool refers = false;    // the text is the number or the name of what has that ID
    bool byNumber = false;  // of what refers: the number alone
    ReferenceLooks looks{}; // of what refers
    document::SubdocumentId subdocument = document::noSubdocument;
    std::shared_ptr<const Footnote> footnote{}; // never null in a mark
    std::shared_ptr<const Formula> formula{};   // never null in a formula
    std::shared_ptr<const Picture> picture{};   // never null in an image
    std::shared_ptr<const Value> value{};       // never null in a value
};

enum class BlockKind {
    text,
    verbatim,    // lines as they are, in runs; blanks and line ends (LF in Run::text) count
    subdocument, // a rendition's place
    image,
    chart, // living: runs hold what stands for it
    table,
    rule, // a horizontal line: the style's border
    pageBreak,
    formula,  // one run; the marker is its number, on its right
    contents, // entries; runs hold what stands for them where there are none
};

struct Cell;
using Row = std::vector<Cell>;

// The blocks first..last of those beside it, which one element holds. Containers come in order of
// their first blocks, outer ones before those inside. Rows and cells of a table are in its block.
struct Container {
    schemas::ContainerRole role = schemas::ContainerRole::none;
    int level = 1; // 2: a section in a section, a list in a list
    sgml::NodeId element = sgml::noNode;
    std::size_t first = 0, last = 0; // inclusive
    bool operator==(const Container&) const = default;
};
using Containers = std::vector<Container>;

// A block that a model holds never changes. A model made after an edit holds the same block again
// where nothing has changed: equal pointers are equal blocks.
struct Block;
using Blocks = std::vector<std::shared_ptr<const Block>>;

// A plain record: what is said of a block of some kind is empty in those of other kinds, as they
// are compared, copied and followed alike.
struct Block {
    BlockKind kind = BlockKind::text;
    sgml::NodeId element = sgml::noNode;
    schemas::BlockStyle style;
    std::string marker; // number, bullet or label; "" without one
    std::uint32_t markerStyle = 0;
    std::vector<Run> runs;
    std::uint32_t textStyle = 0;      // of an empty block, and of what has no run
    int headingLevel = 0;             // 1..: an entry of the outline; 0: none
    std::vector<std::string> anchors; // IDs that references lead to, "#" not included
    document::SubdocumentId subdocument = document::noSubdocument;
    Picture picture;                  // image; chart: without a source
    std::vector<Row> rows;            // table
    std::size_t headerRows = 0;       // so many of the first rows stand on each of its pages
    std::vector<double> columnWidths; // in points, as the author wants them; 0: by the content
    schemas::ContainerRole lists = schemas::ContainerRole::none; // contents: of what
    Blocks entries; // contents: a block each; its run's target is what the entry leads to
};

struct Cell {
    sgml::NodeId element = sgml::noNode;
    schemas::BlockStyle style; // border, background, padding, align
    Blocks blocks;
    Containers containers{};
    document::Span span{};
};

struct Footnote {
    std::string number;
    sgml::NodeId element = sgml::noNode;
    Blocks blocks; // the first one has the number as its marker
    Containers containers;
};

// A frame or a background around the blocks first..last of Model::blocks, from the outermost to the
// innermost. Blocks draw none of their own: style.border, background and padding of a Block are
// those of a rule only, and of a Cell those of the cell.
struct Box {
    std::size_t first = 0, last = 0; // inclusive; the padding above and below is in the spaceBefore
                                     // of the first block and of the one after the last
    double indentLeft = 0, indentRight = 0;
    double padding = 0;
    std::optional<schemas::Color> background{};
    schemas::Border border{};
};

// LIMIT: tables nested deeper are shown as the text of their cells.
inline constexpr int deepestTable = 8;
// LIMIT: footnotes nested deeper stand in the text of the footnote around them.
inline constexpr int deepestFootnote = 8;

struct Model {
    schemas::PageStyle page;
    // Shared by the models of one document by one presentation.
    std::shared_ptr<const schemas::TextStyles> textStyles;
    Blocks blocks;
    Containers containers;
    std::vector<Box> boxes;
    std::vector<std::shared_ptr<const Footnote>> footnotes; // in order of their marks
    std::string title;                                      // of the window and of the PDF
};

// The places of a table's cells.
[[nodiscard]] document::TableGrid gridOf(const Block& table);

class ValueSource;
// Without a source the expression stands for each value.
[[nodiscard]] Model buildModel(const document::Document& document,
                               const schemas::Presentation& presentation,
                               const schemas::Schemas& schemas,
                               const ValueSource* values = nullptr);

// One line per block, indented by nesting, with styles that differ from the default (for tests).
[[nodiscard]] std::string printed(const Model& model);

} // namespace model

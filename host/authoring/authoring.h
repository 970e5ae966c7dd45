// Commands of writing: what a command would change in a document, or why it may not.
//
// Each command takes a document and a selection and gives a Step: edits of the document's bytes and
// the selection after them. Nothing is changed here; Document::edit() does that, as one step of
// undo. The structure after a step is as valid as before by the class's schema. A command that
// would not leave it so is refused with a sentence. A step changes no byte of what it does not
// edit: the rest keeps its spelling, and the inverse of the edits gives the bytes back.
#pragma once

#include "document/value_use.h"
#include "manuscript/manuscript.h"
#include "text/edit.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace authoring {

using manuscript::Direction, manuscript::Unit, manuscript::Manuscript, manuscript::Selection;
using manuscript::Element, manuscript::Grammar, manuscript::Grammars, manuscript::Kind;

struct Step {
    text::Edits edits{};   // ordered; may be empty: then only the selection moves
    Selection after{};     // in offsets of the bytes after the edits
    QString label{};       // of the step of undo: "Typing", "Emphasis"
    bool isTyping = false; // may join the step of typing before it
};

struct Refusal {
    QString why; // a sentence
};

using Result = std::variant<Step, Refusal>;

// --- writing

// In the place of the selection. The text is plain; what the format needs is escaped here. Line
// ends are kept in preformatted text and become blanks elsewhere.
[[nodiscard]] Result type(const Manuscript& manuscript, Selection selection, std::string_view text);
// The letter that was typed before a caret, and those before it, become a quote or an apostrophe of
// their language, a dash, a minus sign, an ellipsis (typography/typed_signs.h). Nothing: they stay,
// as in most cases, and always in code and preformatted text.
[[nodiscard]] std::optional<Step> signTyped(const Manuscript& manuscript, std::size_t caret);
// The selection; without one, the character or word beside the caret. At the end of a paragraph
// the next one joins it. Going backward from the start of a list, its first item leaves it.
[[nodiscard]] Result erase(const Manuscript& manuscript, Selection selection, Direction direction,
                           Unit unit = Unit::character);
// Enter: a new paragraph or item begins; a paragraph follows a heading; an empty item leaves its
// list; preformatted text gets a line end. Behind what is one line only, as a heading or a field of
// a form, the caret goes on to the next line where that is empty, or where no paragraph may stand
// between them: a step without edits.
[[nodiscard]] Result breakParagraph(const Manuscript& manuscript, Selection selection);
// A paragraph behind the last block of the flow around the caret, where Enter makes none: a table,
// preformatted text, a figure, a rule. Refused where the flow ends with another line of text.
[[nodiscard]] Result goBehindEnd(const Manuscript& manuscript, Selection selection);
// Tab in what is one line only, and in the empty line behind it: to the next such field, or the
// next empty line; a step without edits. LIMIT: 100 lines on.
[[nodiscard]] Result goToField(const Manuscript& manuscript, Selection selection,
                               Direction direction);

// Shift+Enter: a line end in preformatted text; other text has no line breaks of its own.
[[nodiscard]] Result breakLine(const Manuscript& manuscript, Selection selection);

// --- in a line

// Puts the selected text, or the word around the caret, into the element with that role: emphasis,
// strong, code. Takes it out when all of it is in one.
[[nodiscard]] Result toggle(const Manuscript& manuscript, Selection selection,
                            schemas::ContainerRole role);
// Text is typed that is in such an element where the caret is in none, and in none where it is in
// one.
[[nodiscard]] Result typeToggled(const Manuscript& manuscript, Selection selection,
                                 std::string_view text, schemas::ContainerRole role);
// Is all of the selected text in one, or the caret?
[[nodiscard]] bool isMarked(const Manuscript& manuscript, Selection selection,
                            schemas::ContainerRole role);
// The selected text, or the word around the caret, becomes a link, or none: "". If there is
// neither, the address comes in as the text of a link.
[[nodiscard]] Result link(const Manuscript& manuscript, Selection selection,
                          std::string_view target);
struct LinkAround {
    std::string target;
    Selection text;
};
// The link that the selection is in.
[[nodiscard]] std::optional<LinkAround> linkAround(const Manuscript& manuscript,
                                                   Selection selection);
// A footnote behind the selection; the caret goes into it.
[[nodiscard]] Result insertFootnote(const Manuscript& manuscript, Selection selection);

// --- language

// The LANG of the element at a place, or of the nearest one around it; "": none says it.
[[nodiscard]] std::string languageAt(const Manuscript& manuscript, std::size_t place);
// Of the selected letters of a line; else of the paragraphs, headings and items of the selection.
[[nodiscard]] Result setLanguage(const Manuscript& manuscript, Selection selection,
                                 std::string_view language);
[[nodiscard]] Result setDocumentLanguage(const Manuscript& manuscript, Selection selection,
                                         std::string_view language);

// --- blocks

// The paragraphs of the selection become headings of that level (1 is the outermost), each with a
// section of what follows it; a heading with its section goes to that level.
[[nodiscard]] Result makeHeading(const Manuscript& manuscript, Selection selection, int level);
// Headings and preformatted text become paragraphs. The content of a heading's section is in the
// section before it then.
[[nodiscard]] Result makeParagraph(const Manuscript& manuscript, Selection selection);
// The paragraphs of the selection become one piece of preformatted text, a line each, without
// emphasis and links.
[[nodiscard]] Result makeVerbatim(const Manuscript& manuscript, Selection selection);
// The paragraphs of the selection become the items of a list, which has the attribute: those that
// the class's presentation tells apart are in Grammar::variants().
[[nodiscard]] Result makeList(const Manuscript& manuscript, Selection selection,
                              std::string_view attribute = {}, std::string_view value = {});
// The items of the selection go into the item before them, or out of their list.
[[nodiscard]] Result indentItems(const Manuscript& manuscript, Selection selection);
[[nodiscard]] Result outdentItems(const Manuscript& manuscript, Selection selection);

// --- insertion

// A block of that name at the caret, between the halves of its paragraph, or beside what is around
// it where it may stand. The caret goes into it; beside a unit it stays in the text, and
// behind a page break it goes on, at the end of a paragraph in a new one.
[[nodiscard]] Result insertBlock(const Manuscript& manuscript, Selection selection,
                                 std::string_view name, std::string_view attributes = {});
// A formula of that source in the line; with `kind`, one of Grammar::variants() as it is spelled in
// a tag (` KIND="display"`), a block of its own.
[[nodiscard]] Result insertFormula(const Manuscript& manuscript, Selection selection,
                                   std::string_view source, std::string_view kind = {});
// The whole text of an element that holds nothing but text, such as a formula.
[[nodiscard]] Result setText(const Manuscript& manuscript, sgml::NodeId element,
                             std::string_view text);
// Into the caption of the figure or table around the caret, which gets one.
[[nodiscard]] Result insertCaption(const Manuscript& manuscript, Selection selection);
// How a reference names its target: "Equation 1", or "(1)".
enum class ReferBy { kindAndNumber, number };
// A reference to an element, which gets an ID when it has none.
[[nodiscard]] Result insertReference(const Manuscript& manuscript, Selection selection,
                                     sgml::NodeId target, ReferBy by = ReferBy::kindAndNumber);
// The reference leads there from now on, and names it so.
[[nodiscard]] Result changeReference(const Manuscript& manuscript, Selection selection,
                                     sgml::NodeId reference, sgml::NodeId target, ReferBy by);
[[nodiscard]] ReferBy refersBy(const Manuscript& manuscript, sgml::NodeId reference);
// The word for an element in references to it: "Equation"; "": none, or the class has no references
// that show the number alone.
[[nodiscard]] std::string referredAs(const Manuscript& manuscript, sgml::NodeId target);
// By the number where that word, or a beginning of it ("eq.", "Figs."), stands before the place.
[[nodiscard]] ReferBy fittingAt(const Manuscript& manuscript, std::size_t place,
                                sgml::NodeId target);
// The elements that a reference may name, in order: those that are numbered, or have an ID.
[[nodiscard]] std::vector<sgml::NodeId> targets(const Manuscript& manuscript);
// The names of elements that may come in behind a place, or behind what is around it.
[[nodiscard]] std::vector<std::string> allowedAt(const Manuscript& manuscript, std::size_t place);

// --- figures

// Of one element.
using Attributes = std::vector<std::pair<std::string, std::string>>;
// A nested document, as its medium's manifest says.
struct EmbeddedText {
    std::string className, storage;
    std::string text{};      // plain
    Attributes attributes{}; // of the class element
};
// In a figure with an empty caption, which gets the caret, where the class has these.
[[nodiscard]] Result insertFigure(const Manuscript& manuscript, Selection selection,
                                  const EmbeddedText& embedded);
// The element that is copied and erased as a whole with a nested document or a picture: the figure
// around it that shows nothing else, else the document or picture itself, which is there.
[[nodiscard]] sgml::NodeId wholeFigure(const Manuscript& manuscript, sgml::NodeId element);
[[nodiscard]] Result removeElement(const Manuscript& manuscript, sgml::NodeId element,
                                   const QString& label);
// As one step; "" removes one. Nothing else changes.
[[nodiscard]] Result setAttributes(const Manuscript& manuscript, Selection selection,
                                   sgml::NodeId element, const Attributes& attributes,
                                   const QString& label);

// --- values

// A value of a nested document in the line, as its medium tells it. The document gets an ID when it
// has none; `use.of` does not count.
[[nodiscard]] Result insertValue(const Manuscript& manuscript, Selection selection,
                                 sgml::NodeId figure, const document::ValueUse& use);
// The element shows this value from now on.
[[nodiscard]] Result changeValue(const Manuscript& manuscript, Selection selection,
                                 sgml::NodeId element, sgml::NodeId figure,
                                 const document::ValueUse& use);
// The ID of a nested document, or the one that it would get; "": it is not there.
[[nodiscard]] std::string idOf(const Manuscript& manuscript, sgml::NodeId figure);
// A step that gives it that ID, too, where it has none.
[[nodiscard]] Result withIdOf(const Manuscript& manuscript, sgml::NodeId figure, Result result);

// --- tables

struct NewTable {
    int rows = 2, columns = 2;
    bool hasHeader = false; // its first row stands again on each of its pages
    bool hasCaption = false;
    std::string caption{}; // plain
};
// With empty cells, the caret in the first one.
[[nodiscard]] Result insertTable(const Manuscript& manuscript, Selection selection,
                                 const NewTable& table);

// Places in two cells of a table select all cells of the rectangle between them
// (table_nodes.h). Commands take the rows or columns of the selected cells.
// Beside them.
[[nodiscard]] Result insertRow(const Manuscript& manuscript, Selection selection, Direction side);
[[nodiscard]] Result insertColumn(const Manuscript& manuscript, Selection selection,
                                  Direction side);
[[nodiscard]] Result removeRow(const Manuscript& manuscript, Selection selection);
[[nodiscard]] Result removeColumn(const Manuscript& manuscript, Selection selection);
// With a figure that holds nothing else.
[[nodiscard]] Result removeTable(const Manuscript& manuscript, Selection selection);
// Past the row or column beside them.
[[nodiscard]] Result moveRow(const Manuscript& manuscript, Selection selection,
                             Direction direction);
[[nodiscard]] Result moveColumn(const Manuscript& manuscript, Selection selection,
                                Direction direction);
// One cell with the content of all; and a cell for each place that such a one covers.
[[nodiscard]] Result joinCells(const Manuscript& manuscript, Selection selection);
[[nodiscard]] Result splitCell(const Manuscript& manuscript, Selection selection);
// The rows from the first one to these are the table's header, or no longer.
[[nodiscard]] Result toggleHeader(const Manuscript& manuscript, Selection selection);
// How wide the selected columns are, in points; 0: as wide as their content wants.
[[nodiscard]] Result setColumnWidth(const Manuscript& manuscript, Selection selection,
                                    double width);
// Of the columns of a table from the first one on; less than 0: it stays.
[[nodiscard]] Result setColumnWidths(const Manuscript& manuscript, Selection selection,
                                     sgml::NodeId table, const std::vector<double>& widths);
// The letters of the selected cells: "left", "center", "right"; "": as the presentation says, where
// numbers of a column stand with their points one below the other.
[[nodiscard]] Result alignCells(const Manuscript& manuscript, Selection selection,
                                std::string_view align);
// That of all selected cells; nothing: they differ, or there is no table.
[[nodiscard]] std::optional<std::string> alignmentOfCells(const Manuscript& manuscript,
                                                          Selection selection);
enum class TablePart { cell, row, column, table };
[[nodiscard]] Result selectInTable(const Manuscript& manuscript, Selection selection,
                                   TablePart part);
// Tab and Shift+Tab: to the next cell, which behind the last one is the first of a new row.
[[nodiscard]] Result goToCell(const Manuscript& manuscript, Selection selection,
                              Direction direction);

// --- pasting and moving

// Plain text; blank lines end paragraphs.
[[nodiscard]] Result pasteText(const Manuscript& manuscript, Selection selection,
                               std::string_view text);
// Elements as they are spelled in documents (exports::fragment()). A single line goes into the line
// at the caret. Elements and attributes that the class does not know are left out, their text
// stays. An element with an ID that the document has gets another one if references from within the
// fragment need it, else none.
[[nodiscard]] Result paste(const Manuscript& manuscript, Selection selection,
                           std::string_view fragment);
// An element with all in it, such as a section, goes before or behind another one.
[[nodiscard]] Result moveElement(const Manuscript& manuscript, sgml::NodeId element,
                                 sgml::NodeId beside, Direction side);

// The section of a heading changes places with the one before or behind it; the first and the last
// of a section go into the section before or behind that.
[[nodiscard]] Result moveSection(const Manuscript& manuscript, sgml::NodeId heading,
                                 Direction direction);
// The section of a heading goes before or behind that of another one, or to the end of it.
enum class Beside { before, behind, inside };
[[nodiscard]] Result moveSection(const Manuscript& manuscript, sgml::NodeId heading,
                                 sgml::NodeId other, Beside where);
// A heading with its section goes one level in (1) or out (-1).
[[nodiscard]] Result changeLevel(const Manuscript& manuscript, sgml::NodeId heading, int by);

// --- replacing

// Every one of these places, which are in order and apart, gets the text; one step.
struct Replacement {
    Result result;
    std::size_t replaced = 0, left = 0; // left: where it is not allowed
};
[[nodiscard]] Replacement replaceAll(const Manuscript& manuscript,
                                     const std::vector<text::Range>& places, std::string_view text);

} // namespace authoring

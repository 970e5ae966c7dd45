#include "authors/random_author.h"

#include "authoring/authoring_testing.h"
#include "authoring/table_nodes.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace authors {

using sgml::NodeId;
using sgml::noNode;

// --- documents ------------------------------------------------------------------------------

std::string RandomAuthor::gap() {
    constexpr std::array<std::string_view, 5> kinds = {"\n", "\n", "", "\n  ", " "};
    return std::string(kinds[below(kinds.size())]);
}

std::string RandomAuthor::element(const std::string& name, const std::string& inside) {
    const std::string id = below(8) == 0 ? " ID=\"i" + std::to_string(++ids_) + "\"" : "";
    return "<" + name + id + ">" + inside + "</" + name + ">";
}

std::string RandomAuthor::text() {
    if (below(3) == 0)
        return "{" + random_.spelling(2) + "}";
    std::string words = "{";
    for (std::size_t count = below(5); count > 0; --count)
        words += (words.size() > 1 ? " " : "") + std::string(1 + below(6), char('a' + below(26)));
    return words + "}";
}

std::string RandomAuthor::inlined(int depth) {
    switch (below(10)) {
    case 0:
        return element("EMPH", line(depth - 1));
    case 1:
        return element("STRONG", line(depth - 1));
    case 2:
        return "<LINK TO=\"http://x\">" + line(depth - 1) + "</LINK>";
    case 3:
        return "<REF TO=\"i1\"></REF>";
    case 4:
        return element("FOOTNOTE", below(2) == 0 ? text() : element("PARAGRAPH", line(depth - 1)));
    case 5:
        return "<IMAGE FILE=\"a.png\"></IMAGE>";
    default:
        return element("TEXT", below(9) == 0 ? "" : text());
    }
}

std::string RandomAuthor::line(int depth) {
    if (depth <= 0 || below(2) == 0)
        return below(9) == 0 ? "" : text();
    std::string all;
    for (std::size_t count = below(5); count > 0; --count)
        all += inlined(depth);
    return all;
}

std::string RandomAuthor::animation() {
    return "<DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED ALT=\"a\"><SCRIPT>{x \\{1\\}}</SCRIPT>\n"
           "</SCRIPTED>\n</DOCUMENT>";
}

std::string RandomAuthor::list(int depth) {
    std::string items;
    for (std::size_t count = below(4); count > 0; --count) {
        const std::string first = below(2) == 0 ? text() : element("TEXT", text());
        const bool nests = depth > 0 && below(3) == 0;
        items += gap() + element("ITEM", nests           ? element("TEXT", text()) + list(depth - 1)
                                         : below(3) == 0 ? element("PARAGRAPH", line(depth))
                                                         : first);
    }
    return (below(2) == 0 ? "<LIST KIND=\"number\">" : "<LIST>") + items + gap() + "</LIST>";
}

std::string RandomAuthor::cell(const std::string& inside) {
    if (below(4) != 0)
        return element("CELL", inside);
    return "<CELL COLUMNS=\"" + std::to_string(below(4)) + "\" ROWS=\"" +
           std::to_string(1 + below(3)) + "\">" + inside + "</CELL>";
}

std::string RandomAuthor::table(int depth) {
    std::string rows = below(3) == 0 ? element("CAPTION", line(1)) : "";
    for (std::size_t count = 1 + below(3); count > 0; --count)
        rows += gap() + (below(4) == 0 ? "<ROW KIND=\"header\">" : "<ROW>") +
                element("CELL", line(1)) + cell(below(3) == 0 ? blocks(depth - 2) : text()) +
                (below(3) == 0 ? cell(text()) : "") + "</ROW>";
    return element("TABLE", rows);
}

std::string RandomAuthor::block(int depth) {
    switch (below(14)) {
    case 0:
    case 1:
        return list(depth - 1);
    case 2:
        return depth > 1 ? table(depth) : element("PARAGRAPH", "");
    case 3:
        return element("FIGURE", animation() + (below(2) == 0 ? element("CAPTION", line(1)) : ""));
    case 4:
        return element("VERBATIM", below(5) == 0 ? "" : text());
    case 5:
        return below(2) == 0 ? "<RULE></RULE>" : "<PAGEBREAK></PAGEBREAK>";
    case 6:
        return animation();
    case 7:
        return element("PARAGRAPH", animation());
    default:
        return element("PARAGRAPH", line(depth));
    }
}

std::string RandomAuthor::blocks(int depth) {
    std::string all;
    for (std::size_t count = below(6); count > 0 && depth >= 0; --count)
        all += gap() + block(depth);
    return all + gap();
}

std::string RandomAuthor::section(int depth) {
    std::string all = element("HEADING", line(1)) + blocks(depth);
    for (std::size_t count = depth > 0 ? below(3) : 0; count > 0; --count)
        all += gap() + section(depth - 1);
    return element("SECTION", gap() + all + gap());
}

std::string RandomAuthor::document() {
    if (below(2) == 0)
        return "DOCUMENT CMEMO\n<CMEMO>" + element("TO", line(1)) + gap() +
               element("SUBJECT", line(1)) + gap() + element("BODY", blocks(3)) + "</CMEMO>\n";
    std::string sections;
    for (std::size_t count = below(4); count > 0; --count)
        sections += gap() + section(2);
    return "DOCUMENT REPORT\n<REPORT>" + element("TITLE", line(1)) +
           (below(2) == 0 ? element("ABSTRACT", below(2) == 0 ? text() : blocks(1)) : "") +
           blocks(2) + sections + "</REPORT>";
}

// --- writing --------------------------------------------------------------------------------

namespace {

// The letters of all contents in [from, to), and how many elements are figures.
std::string lettersOf(const sgml::Tree& tree, std::size_t from, std::size_t to) {
    std::string letters;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id)) {
        if (tree.node(id).kind != sgml::NodeKind::content)
            continue;
        const text::Range range = tree.contentRange(id);
        for (std::size_t at = std::max(range.from, from); at < std::min(range.to, to); ++at)
            if (std::isalpha(static_cast<unsigned char>(tree.bytes()[at])) != 0)
                letters += tree.bytes()[at];
    }
    return letters;
}

// The letters that are in none of the elements.
std::string lettersBeside(const sgml::Tree& tree, const std::vector<NodeId>& elements) {
    std::string letters;
    std::size_t from = 0;
    std::vector<text::Range> ranges;
    ranges.reserve(elements.size());
    for (const NodeId id : elements)
        ranges.push_back(tree.node(id).range);
    std::sort(ranges.begin(), ranges.end(),
              [](text::Range a, text::Range b) { return a.from < b.from; });
    for (const text::Range& range : ranges) {
        letters += lettersOf(tree, from, range.from);
        from = range.to;
    }
    return letters + lettersOf(tree, from, tree.bytes().size());
}

// Do the letters come in that order, perhaps with others between them?
bool isPartOf(std::string_view letters, std::string_view all) {
    std::size_t found = 0;
    for (const char letter : all)
        found += found < letters.size() && letters[found] == letter ? 1 : 0;
    return found == letters.size();
}

// What was erased may have stood between a CR and an LF, which are one character now.
bool isInLineEnd(std::string_view bytes, std::size_t at) {
    return at > 0 && at < bytes.size() && bytes[at - 1] == '\r' && bytes[at] == '\n';
}

std::size_t figuresOf(const sgml::Tree& tree) {
    std::size_t count = 0;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id))
        count += tree.isElement(id) && tree.name(id) == "FIGURE" ? 1 : 0;
    return count;
}

std::string faultsOf(const document::Document& document) {
    std::string all;
    for (const sgml::Fault& fault : document.faults())
        all += fault.message + "; ";
    const schemas::StructureSchema* schema = testSchemas().structure(document.className());
    if (schema == nullptr)
        return all + "no schema";
    for (const sgml::Fault& fault : schema->check(document.tree(), document.tree().root()))
        all += fault.message + "; ";
    return all;
}

} // namespace

Selection RandomAuthor::randomSelection(const Manuscript& manuscript, Selection last) {
    if (below(3) != 0 && last.caret <= manuscript.document.bytes().size())
        return {last.caret, last.caret};
    const auto anywhere = [&] {
        const std::size_t size = manuscript.document.bytes().size();
        const std::optional<std::size_t> found =
            place(manuscript, below(size + 1), Direction::forward);
        return found.value_or(place(manuscript, size, Direction::backward).value_or(0));
    };
    const std::size_t caret = anywhere();
    if (below(2) == 0)
        return {caret, caret};
    if (below(2) == 0)
        return {anywhere(), caret};
    std::size_t anchor = caret; // near it
    for (std::size_t count = 1 + below(12); count > 0; --count)
        anchor =
            placeBeside(manuscript, anchor, Direction::forward, Unit::character).value_or(anchor);
    return below(2) == 0 ? Selection{anchor, caret} : Selection{caret, anchor};
}

RandomAuthor::Try RandomAuthor::tryTable(const Manuscript& manuscript, Selection selection) {
    const Direction side = below(2) == 0 ? Direction::forward : Direction::backward;
    switch (below(13)) {
    case 0:
        return {"row", insertRow(manuscript, selection, side), false, true};
    case 1:
        return {"column", insertColumn(manuscript, selection, side), false, true};
    case 2:
        return below(2) == 0 ? Try{"remove row", removeRow(manuscript, selection), false}
                             : Try{"remove column", removeColumn(manuscript, selection), false};
    case 3:
        return {"cell", goToCell(manuscript, selection, side), false, true};
    case 4:
        return {"table",
                insertTable(manuscript, selection,
                            {1 + int(below(3)), 1 + int(below(3)), below(2) == 0, below(2) == 0}),
                false, true};
    case 5:
        return {"move row", moveRow(manuscript, selection, side), false};
    case 6:
        return {"move column", moveColumn(manuscript, selection, side), false};
    case 7:
        return {"join cells", joinCells(manuscript, selection), false};
    case 8:
        return {"split cell", splitCell(manuscript, selection), false, true};
    case 9:
        return below(5) == 0 ? Try{"remove table", removeTable(manuscript, selection), false}
                             : Try{"header", toggleHeader(manuscript, selection), false, true};
    case 10:
        return {"width", setColumnWidth(manuscript, selection, double(below(3)) * 50), false, true};
    case 11: {
        constexpr std::array parts = {TablePart::cell, TablePart::row, TablePart::column,
                                      TablePart::table};
        return {"select", selectInTable(manuscript, selection, parts[below(4)]), false, true};
    }
    default:
        return {"verbatim", makeVerbatim(manuscript, selection), false, true};
    }
}

RandomAuthor::Try RandomAuthor::tryCommand(const Manuscript& manuscript, Selection selection) {
    const bool isRange = !selection.isEmpty();
    switch (below(14)) {
    case 0: {
        const Direction direction = below(2) == 0 ? Direction::forward : Direction::backward;
        const Unit unit = below(3) == 0 ? Unit::word : Unit::character;
        return {"erase", erase(manuscript, selection, direction, unit), isRange};
    }
    case 1:
        return {"Enter", breakParagraph(manuscript, selection)};
    case 2: {
        constexpr std::array roles = {schemas::ContainerRole::emphasis,
                                      schemas::ContainerRole::strong, schemas::ContainerRole::code};
        if (below(3) == 0)
            return {"type toggled", typeToggled(manuscript, selection, "a b", roles[below(3)])};
        return {"toggle", toggle(manuscript, selection, roles[below(3)]), false, true};
    }
    case 12:
        return tryTable(manuscript, selection);
    case 13: {
        const std::vector<document::SubdocumentId> all = manuscript.document.subdocuments();
        if (all.empty())
            return {"change figure", Refusal{}};
        const auto* figure = manuscript.document.subdocument(all[below(all.size())]);
        const std::size_t at = place(manuscript, 0, Direction::forward).value_or(0);
        if (below(2) == 0 || figure->classElement == sgml::noNode)
            return {"remove figure",
                    removeElement(manuscript, wholeFigure(manuscript, figure->element), "Delete"),
                    false};
        return {"change figure",
                setAttributes(manuscript, {at, at}, figure->classElement,
                              {{"WIDTH", "10"}, {"ALIGN", "left"}, {"ALT", ""}}, "Align"),
                false, true};
    }
    case 9: {
        const std::vector<std::string> names =
            allowedAt(manuscript, std::max(selection.anchor, selection.caret));
        if (names.empty())
            return {"insert", Refusal{}};
        return {"insert", insertBlock(manuscript, selection, names[below(names.size())]), false,
                true};
    }
    case 10: {
        const std::vector<NodeId> all = targets(manuscript);
        if (all.empty() || below(2) == 0)
            return {"caption", insertCaption(manuscript, selection), false, true};
        const NodeId one = all[below(all.size())], other = all[below(all.size())];
        if (below(2) == 0)
            return {"refer", insertReference(manuscript, selection, one), false, true};
        return {"move", moveElement(manuscript, one, other, Direction::forward), false};
    }
    case 11: {
        constexpr std::array<std::string_view, 5> pasted = {
            "<PARAGRAPH>{a \\{}</PARAGRAPH>", "<LIST><ITEM>{b}</ITEM></LIST>",
            "<BODY><PARAGRAPH ID=\"i1\">{c}</PARAGRAPH><RULE></RULE></BODY>",
            "<TEXT>{d}</TEXT><EMPH>{e}</EMPH>",
            "<DOCUMENT>DOCUMENT X\n<X ID=\"q\"></X></DOCUMENT>"};
        if (below(2) == 0)
            return {"paste", paste(manuscript, selection, pasted[below(pasted.size())])};
        return below(2) == 0
                   ? Try{"paste text", pasteText(manuscript, selection, "a\n\nb {\nc")}
                   : Try{"figure", insertFigure(manuscript, selection, {"SCRIPTED", "SCRIPT", "}"}),
                         false};
    }
    case 7:
        return below(2) == 0 ? Try{"heading", makeHeading(manuscript, selection, 1 + int(below(3))),
                                   false, true}
                             : Try{"paragraph", makeParagraph(manuscript, selection), false, true};
    case 8:
        switch (below(3)) {
        case 0:
            return {"list", makeList(manuscript, selection), false, true};
        case 1:
            return {"indent", indentItems(manuscript, selection), false, true};
        default:
            return {"outdent", outdentItems(manuscript, selection), false, true};
        }
    case 3:
        return below(2) == 0 ? Try{"link", link(manuscript, selection, below(3) == 0 ? "" : "#1"),
                                   false, true}
                             : Try{"footnote", insertFootnote(manuscript, selection), false, true};
    default:
        return {"type", type(manuscript, selection, random_.text(3))};
    }
}

std::string RandomAuthor::write(std::size_t count) {
    const std::string first = document();
    const std::string faults = faultsOf(document::Document(first));
    return faults.empty() ? write(count, first) : "the document: " + faults + "\n" + first;
}

std::string RandomAuthor::anyDocument() {
    std::string any = random_.sound();
    // Of a class that is text, whatever is in it.
    if (const std::size_t at = any.find("ANIMATION"); at != std::string::npos && below(2) == 0)
        any.replace(at, 9, "CMEMO");
    return below(3) == 0 ? random_.mutated(any) : any;
}

std::string RandomAuthor::write(std::size_t count, const std::string& first) {
    document::Document document(first);
    const Manuscript manuscript{document, testGrammars()};
    const bool isSound = faultsOf(document).empty();
    Selection last;
    for (std::size_t i = 0; i < count; ++i) {
        const Selection selection = widened(manuscript, randomSelection(manuscript, last));
        const std::size_t from = std::min(selection.anchor, selection.caret),
                          to = std::max(selection.anchor, selection.caret);
        const std::string before = document.bytes();
        const Try tried = tryCommand(manuscript, selection);
        const auto* step = std::get_if<Step>(&tried.result);
        if (step == nullptr) {
            ++tally_.refusals;
            continue;
        }
        ++tally_.steps;
        const auto wrong = [&](const std::string& what) {
            return tried.what + " " + std::to_string(selection.anchor) + ".." +
                   std::to_string(selection.caret) + ": " + what +
                   "\nbefore: " + withMarks(before, selection) + "\nafter: " + document.bytes();
        };
        const std::vector<NodeId> cells = selectedCells(manuscript, selection);
        const std::string letters =
            cells.empty() ? lettersOf(document.tree(), 0, from) +
                                lettersOf(document.tree(), to, document.bytes().size())
                          : lettersBeside(document.tree(), cells);
        const std::string all = lettersOf(document.tree(), 0, document.bytes().size());
        const std::size_t figures = figuresOf(document.tree());
        if (!step->edits.empty() &&
            document.edit(step->edits, step->label) == document::EditResult::invalid)
            return wrong("the edits are not in order");
        for (const text::Edit& edit : step->edits)
            tally_.replaced += edit.range.size();
        last = step->after;
        if (!isSound)
            continue;
        if (const std::string faults = faultsOf(document); !faults.empty())
            return wrong(faults);
        for (const std::size_t at : {step->after.anchor, step->after.caret})
            if (place(manuscript, at, Direction::forward) != at &&
                !isInLineEnd(document.bytes(), at))
                return wrong("no place: " + std::to_string(at));
        if (tried.keepsAll && lettersOf(document.tree(), 0, document.bytes().size()) != all)
            return wrong("letters are lost or new");
        if (!tried.keepsLetters || figuresOf(document.tree()) < figures)
            continue;
        const std::string now = lettersOf(document.tree(), 0, document.bytes().size());
        if (!isPartOf(letters, now))
            return wrong("letters are lost");
    }
    const std::string written = document.bytes();
    while (document.canUndo())
        document.undo();
    if (document.bytes() != first)
        return "undo gives\n" + document.bytes() + "\nnot\n" + first;
    while (document.canRedo())
        document.redo();
    return document.bytes() == written ? "" : "redo gives\n" + document.bytes();
}

} // namespace authors

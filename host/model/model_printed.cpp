#include "model/contents.h"
#include "model/model.h"

#include <array>
#include <cstdio>

namespace model {

namespace {

std::string shortNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string runPrinted(const Run& run, const Model& model) {
    constexpr std::array<const char*, 8> kinds = {"",       "subdocument", "image", "note",
                                                  "slider", "value",       "break", "formula"};
    std::string text = run.kind == RunKind::text
                           ? ""
                           : std::string(kinds[static_cast<std::size_t>(run.kind)]) + ":";
    if (run.picture)
        text += run.picture->source;
    for (const char c : run.text)
        text += c == '\n' ? std::string("\\n") : std::string(1, c);
    const schemas::TextStyle& style = (*model.textStyles)[run.style];
    std::string marks = style.bold ? "b" : "";
    marks += style.italic ? "i" : "";
    marks += style.family == "mono" ? "m" : "";
    const std::string target = run.target.empty() ? "" : ">" + run.target;
    return "[" + (marks.empty() ? "" : marks + "|") + text + target + "]";
}

void print(const Blocks& blocks, const Model& model, const std::string& indent, std::string& lines);

void print(const Containers& containers, const std::string& indent, std::string& lines) {
    constexpr std::array<const char*, 8> roles = {"",       "section", "list",    "item",
                                                  "figure", "table",   "caption", "quote"};
    for (const Container& container : containers)
        lines += indent + "in " + roles[static_cast<std::size_t>(container.role)] + " " +
                 std::to_string(container.level) + ": " + std::to_string(container.first) + ".." +
                 std::to_string(container.last) + "\n";
}

void print(const Block& block, const Model& model, const std::string& indent, std::string& lines) {
    constexpr std::array<const char*, 10> kinds = {
        "text",  "verbatim", "subdocument", "image",   "chart",
        "table", "rule",     "page-break",  "formula", "contents"};
    constexpr std::array<const char*, 4> aligns = {"left", "center", "right", "justify"};
    const schemas::BlockStyle& style = block.style;
    lines += indent + kinds[static_cast<std::size_t>(block.kind)] + " " +
             aligns[static_cast<std::size_t>(style.align)] + " " +
             shortNumber((*model.textStyles)[block.textStyle].size) + "pt";
    if (style.indentLeft != 0)
        lines += " in " + shortNumber(style.indentLeft);
    if (style.spaceBefore != 0)
        lines += " after " + shortNumber(style.spaceBefore);
    if (block.headingLevel != 0)
        lines += " level " + std::to_string(block.headingLevel);
    lines += style.keepWithNext ? " keep" : "";
    lines += style.pageBreakBefore ? " page" : "";
    for (const std::string& anchor : block.anchors)
        lines += isGeneratedAnchor(anchor) ? "" : " #" + anchor;
    if (!block.marker.empty())
        lines += " (" + block.marker + ")";
    lines += block.picture.source.empty() ? "" : " " + block.picture.source;
    lines += block.runs.empty() ? "" : " ";
    for (const Run& run : block.runs)
        lines += runPrinted(run, model);
    lines += '\n';
    for (const auto& entry : block.entries)
        print(*entry, model, indent + "  ", lines);
    for (const Row& row : block.rows) {
        lines += indent + "  row\n";
        for (const Cell& cell : row) {
            lines += indent + "    cell";
            if (cell.span != document::Span{})
                lines +=
                    " " + std::to_string(cell.span.columns) + "x" + std::to_string(cell.span.rows);
            lines += '\n';
            print(cell.blocks, model, indent + "      ", lines);
            print(cell.containers, indent + "      ", lines);
        }
    }
}

void print(const Blocks& blocks, const Model& model, const std::string& indent,
           std::string& lines) {
    for (const std::shared_ptr<const Block>& block : blocks)
        print(*block, model, indent, lines);
}

} // namespace

std::string printed(const Model& model) {
    std::string lines = "title " + model.title + "\n";
    print(model.blocks, model, "", lines);
    print(model.containers, "", lines);
    for (const Box& box : model.boxes)
        lines += "box " + std::to_string(box.first) + ".." + std::to_string(box.last) + "\n";
    for (const std::shared_ptr<const Footnote>& footnote : model.footnotes) {
        lines += "footnote " + footnote->number + "\n";
        print(footnote->blocks, model, "  ", lines);
        print(footnote->containers, "  ", lines);
    }
    return lines;
}

} // namespace model

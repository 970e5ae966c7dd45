#include "exports/copy_export.h"

#include "model/value_text.h"

#include <algorithm>

namespace exports {

using model::Block, model::Blocks, model::Run, model::RunKind, model::BlockKind, model::Footnote,
    model::Cell, model::Containers, model::Row, model::Picture, model::plainText;

namespace {

using schemas::ContainerRole;

// The words for a picture where only text can stand.
std::string copiedWords(const Picture& picture) {
    return picture.alternative.empty() ? picture.source : picture.alternative;
}

// The same for a figure or picture.
std::string copiedWords(const document::Document& document, const Block& block) {
    if (const document::Subdocument* of = document.subdocument(block.subdocument))
        return of->alternative.empty() ? of->className : of->alternative;
    return copiedWords(block.picture);
}

std::string copiedWords(const document::Document& document, const Run& run) {
    if (run.picture)
        return copiedWords(*run.picture);
    const document::Subdocument* of = document.subdocument(run.subdocument);
    return of == nullptr ? std::string() : of->alternative;
}

bool isPicture(const Run& run) {
    return run.kind == RunKind::subdocument || run.kind == RunKind::image;
}

// The innermost container of that role around each block, as an index; nothing: -1.
std::vector<std::size_t> innermost(const Blocks& blocks, const Containers& containers,
                                   ContainerRole role) {
    std::vector<std::size_t> result(blocks.size(), static_cast<std::size_t>(-1));
    for (std::size_t c = 0; c < containers.size(); ++c)
        if (containers[c].role == role)
            for (std::size_t i = containers[c].first; i <= containers[c].last; ++i)
                result[i] = c;
    return result;
}

// --- plain text --------------------------------------------------------------------------------

class TextCopy {
public:
    explicit TextCopy(const document::Document& document) : document_(document) {}

    std::string of(const Model& model) {
        std::string result = blocks(model.blocks, model.containers);
        for (const std::shared_ptr<const Footnote>& note : model.footnotes)
            result += (result.empty() ? "" : "\n\n") + blocks(note->blocks, note->containers);
        return result;
    }

private:
    std::string blocks(const Blocks& all, const Containers& containers) {
        const std::vector<std::size_t> lists = innermost(all, containers, ContainerRole::list);
        std::string result;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i]->kind == BlockKind::pageBreak)
                continue;
            const bool sameList = i > 0 && lists[i] == lists[i - 1] && lists[i] < containers.size();
            if (!result.empty())
                result += sameList ? "\n" : "\n\n";
            result += block(*all[i]);
        }
        return result;
    }

    std::string block(const Block& of) {
        if (of.kind == BlockKind::table)
            return table(of);
        if (of.kind == BlockKind::contents && !of.entries.empty())
            return blocks(of.entries, {});
        if (of.kind == BlockKind::rule)
            return "---";
        if (of.kind == BlockKind::subdocument || of.kind == BlockKind::image)
            return "[" + copiedWords(document_, of) + "]";
        const bool isFormula = of.kind == BlockKind::formula; // its number stands on its right
        std::string result = of.marker.empty() || isFormula ? "" : of.marker + " ";
        for (const Run& run : of.runs)
            result += isPicture(run)                   ? "[" + copiedWords(document_, run) + "]"
                      : run.kind == RunKind::lineBreak ? "\n"
                                                       : plainText(run);
        if (isFormula && !of.marker.empty())
            result += " " + of.marker;
        if (of.kind == BlockKind::verbatim && result.ends_with('\n'))
            result.pop_back();
        return result;
    }

    std::string table(const Block& of) {
        std::string result;
        for (const Row& row : of.rows) {
            std::string line;
            for (std::size_t i = 0; i < row.size(); ++i) {
                std::string text = blocks(row[i].blocks, row[i].containers);
                std::ranges::replace(text, '\n', ' ');
                line += (i == 0 ? "" : "\t") + text;
            }
            result += (result.empty() ? "" : "\n") + line;
        }
        return result;
    }

    const document::Document& document_;
};

// --- HTML --------------------------------------------------------------------------------------

std::string escapedHtml(std::string_view text) {
    std::string result;
    for (const char c : text)
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    return result;
}

class HtmlCopy {
public:
    HtmlCopy(const document::Document& document, const Model& model)
        : document_(document), styles_(model.textStyles.get()) {}

    std::string of(const Model& model) {
        std::string result = "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"></head><body>\n";
        result += blocks(model.blocks, model.containers);
        if (!model.footnotes.empty())
            result += "<hr>\n";
        for (const std::shared_ptr<const Footnote>& note : model.footnotes)
            result += blocks(note->blocks, note->containers);
        return result + "</body></html>\n";
    }

private:
    // "": it has no tag of its own.
    static std::string tagOf(const Containers& all, std::size_t index, const Blocks& blocks) {
        switch (all[index].role) {
        case ContainerRole::list: {
            const std::string& marker = blocks[all[index].first]->marker;
            const bool isNumbered =
                std::ranges::any_of(marker, [](char c) { return c >= '0' && c <= '9'; });
            return isNumbered ? "ol" : "ul";
        }
        case ContainerRole::item:
            return "li";
        case ContainerRole::figure:
            return "figure";
        case ContainerRole::quote:
            return "blockquote";
        default:
            return {};
        }
    }

    std::string blocks(const Blocks& all, const Containers& containers) {
        std::string result;
        std::vector<std::pair<std::size_t, std::string>> open; // last block, tag
        std::size_t next = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (; next < containers.size() && containers[next].first == i; ++next) {
                const std::string tag = tagOf(containers, next, all);
                if (tag.empty())
                    continue;
                open.emplace_back(containers[next].last, tag);
                result += "<" + tag + ">";
            }
            const bool inItem = !open.empty() && open.back().second == "li";
            result += block(*all[i], inItem);
            for (; !open.empty() && open.back().first == i; open.pop_back())
                result += "</" + open.back().second + ">\n";
        }
        return result;
    }

    std::string block(const Block& of, bool inItem) {
        switch (of.kind) {
        case BlockKind::table:
            return table(of);
        case BlockKind::contents:
            if (!of.entries.empty())
                return blocks(of.entries, {});
            break;
        case BlockKind::rule:
            return "<hr>\n";
        case BlockKind::pageBreak:
            return {};
        case BlockKind::subdocument:
        case BlockKind::image:
            return "<p>[" + escapedHtml(copiedWords(document_, of)) + "]</p>\n";
        case BlockKind::verbatim:
            return "<pre>" + runs(of) + "</pre>\n";
        default:
            break;
        }
        if (of.kind == BlockKind::formula)
            return "<p>" + runs(of) + " " + escapedHtml(of.marker) + "</p>\n";
        if (of.headingLevel > 0) {
            const std::string tag = "h" + std::to_string(std::min(of.headingLevel, 6));
            return "<" + tag + ">" + marker(of) + runs(of) + "</" + tag + ">\n";
        }
        return inItem ? runs(of) : "<p>" + marker(of) + runs(of) + "</p>\n";
    }

    static std::string marker(const Block& of) {
        return of.marker.empty() ? "" : escapedHtml(of.marker) + " ";
    }

    std::string runs(const Block& of) {
        std::string result;
        const std::uint32_t own = of.textStyle;
        for (const Run& run : of.runs) {
            std::string text = escapedHtml(plainText(run));
            if (run.kind == RunKind::lineBreak)
                text = "<br>";
            if (isPicture(run))
                text = "[" + escapedHtml(copiedWords(document_, run)) + "]";
            if (run.formula)
                text = "<span role=\"math\" aria-label=\"" + escapedHtml(run.formula->spoken) +
                       "\">" + text + "</span>";
            result += linked(run, styled(run, own, std::move(text)));
        }
        return result;
    }

    // Looks that the block has as a whole, as a heading is bold, are its tag's.
    std::string styled(const Run& run, std::uint32_t own, std::string text) const {
        const schemas::TextStyle& style = (*styles_)[run.style];
        const schemas::TextStyle& around = (*styles_)[own];
        const auto wrap = [&](bool is, const std::string& tag) {
            if (is)
                text =
                    std::string("<").append(tag).append(">").append(text).append("</") + tag + ">";
        };
        wrap(style.family == "mono" && around.family != "mono", "code");
        wrap(style.bold && !around.bold, "strong");
        wrap(style.italic && !around.italic, "em");
        wrap(style.raised, "sup");
        return text;
    }

    // Only what leads out of the document: its own places are not in a copy.
    static std::string linked(const Run& run, const std::string& text) {
        if (run.target.empty() || run.target.starts_with('#'))
            return text;
        return "<a href=\"" + escapedHtml(run.target) + "\">" + text + "</a>";
    }

    static std::string spanned(const std::string& attribute, std::size_t count) {
        return count == 1 ? "" : " " + attribute + "=\"" + std::to_string(count) + '"';
    }

    std::string table(const Block& of) {
        std::string result = "<table>\n";
        for (const Row& row : of.rows) {
            result += "<tr>";
            for (const Cell& cell : row)
                result += "<td" + spanned("colspan", cell.span.columns) +
                          spanned("rowspan", cell.span.rows) + ">" +
                          blocks(cell.blocks, cell.containers) + "</td>";
            result += "</tr>\n";
        }
        return result + "</table>\n";
    }

    const document::Document& document_;
    const schemas::TextStyles* styles_;
};

} // namespace

std::string copiedText(const document::Document& document, const Model& model) {
    return TextCopy(document).of(model);
}

std::string copiedHtml(const document::Document& document, const Model& model) {
    return HtmlCopy(document, model).of(model);
}

} // namespace exports

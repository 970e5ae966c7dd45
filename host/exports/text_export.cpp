#include "exports/text_export.h"

#include "model/value_text.h"

#include "text/characters.h"

#include <algorithm>

namespace exports {

using model::Block, model::Run, model::RunKind, model::BlockKind, model::Footnote, model::Cell,
    model::Row, model::Picture, model::plainText;

namespace {

constexpr double pointsPerColumn = 6;
constexpr double blankLine = 4.5; // points of space that become an empty line

std::size_t columns(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !text::isContinuation(c); }));
}

std::string padded(std::string text, std::size_t width) {
    text.append(width - std::min(width, columns(text)), ' ');
    return text;
}

// A line as it is written: no blanks at its end, and no-break spaces have done their work.
std::string finished(std::string text) {
    constexpr std::string_view noBreak = "\u00A0";
    for (std::size_t at = text.find(noBreak); at != std::string::npos; at = text.find(noBreak, at))
        text.replace(at, noBreak.size(), " ");
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
    std::vector<std::string> lines;
    std::string line;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t word = std::min(text.find_first_not_of(' ', at), text.size());
        const std::size_t end = std::min(text.find(' ', word), text.size());
        if (word == text.size())
            break;
        if (!line.empty() && columns(line) + 1 + columns(text.substr(word, end - word)) > width) {
            lines.push_back(line);
            line.clear();
        }
        line += (line.empty() ? "" : " ") + std::string(text.substr(word, end - word));
        at = end;
    }
    lines.push_back(line);
    return lines;
}

class TextWriter {
public:
    TextWriter(const document::Document& document, const Model& model, std::size_t width)
        : document_(document), model_(model), width_(width) {}

    std::string write() {
        for (const std::shared_ptr<const Block>& block : model_.blocks)
            writeBlock(*block);
        if (!model_.footnotes.empty())
            text_ += "\n" + std::string(20, '-') + "\n";
        for (const std::shared_ptr<const Footnote>& footnote : model_.footnotes)
            for (const std::shared_ptr<const Block>& block : footnote->blocks)
                writeFlowing(*block, block->marker.empty() ? "" : "[" + block->marker + "]");
        return std::move(text_);
    }

private:
    void writeBlock(const Block& block) {
        if (block.style.spaceBefore >= blankLine && !text_.empty())
            text_ += '\n';
        switch (block.kind) {
        case BlockKind::text:
            writeFlowing(block, block.marker);
            break;
        case BlockKind::formula:
            writeFormula(block);
            break;
        case BlockKind::verbatim:
            writeLines(block);
            break;
        case BlockKind::table:
            writeTable(block);
            break;
        case BlockKind::contents:
            for (const std::shared_ptr<const Block>& entry : block.entries)
                writeFlowing(*entry, "");
            if (block.entries.empty())
                writeFlowing(block, "");
            break;
        case BlockKind::rule:
            text_ += std::string(width_, '-') + "\n";
            break;
        case BlockKind::pageBreak:
            text_ += "\n";
            break;
        case BlockKind::subdocument:
        case BlockKind::image:
        case BlockKind::chart:
            for (const std::string& line : wrapped(placeholder(block), width_))
                text_ += line + "\n";
            break;
        }
    }

    static std::size_t indentOf(const Block& block) {
        return static_cast<std::size_t>(std::max(0.0, block.style.indentLeft) / pointsPerColumn);
    }

    // The marker hangs in its column, or stands before the text where there is none.
    void writeFlowing(const Block& block, const std::string& marker) {
        const std::size_t indent = std::min(indentOf(block), width_ / 2);
        const bool hangs = !marker.empty() && block.style.markerWidth > 0;
        const std::string text = plain(block.runs);
        const std::vector<std::string> lines =
            wrapped(hangs || marker.empty() ? text : marker + " " + text, width_ - indent);
        for (std::size_t i = 0; i < lines.size(); ++i)
            text_ += finished((hangs && i == 0 ? hanging(marker, block, indent)
                                               : std::string(indent, ' ')) +
                              lines[i]) +
                     "\n";
        if (block.headingLevel == 1 || block.headingLevel == 2)
            text_ += std::string(indent, ' ') +
                     std::string(columns(lines.back()), block.headingLevel == 1 ? '=' : '-') + "\n";
    }

    // In the middle, its number at the right of the last line.
    void writeFormula(const Block& block) {
        for (const Run& run : block.runs) {
            const std::vector<std::string> lines = formulas::plainLines(run.formula->read);
            for (const std::string& text : lines) {
                const std::size_t room = width_ - std::min(width_, columns(text));
                std::string line = std::string(room / 2, ' ') + text;
                if (!block.marker.empty() && &text == &lines.back())
                    line = padded(line, width_ - std::min(width_, columns(block.marker) + 1)) +
                           " " + block.marker;
                text_ += finished(line) + "\n";
            }
        }
    }

    static std::string hanging(const std::string& marker, const Block& block, std::size_t indent) {
        const auto column = static_cast<std::size_t>(block.style.markerWidth / pointsPerColumn);
        std::string start(indent - std::min(indent, column), ' ');
        start += marker;
        return columns(start) + 1 > indent ? start + " " : padded(start, indent);
    }

    void writeLines(const Block& block) {
        const std::string text = plain(block.runs);
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            text_ += finished("    " + text.substr(at, end - at)) + "\n";
            at = end + 1;
        }
    }

    std::string cellText(const Cell& cell) const {
        std::string text;
        for (const std::shared_ptr<const Block>& block : cell.blocks)
            text += (text.empty() ? "" : " ") +
                    (block->runs.empty() ? placeholder(*block) : plain(block->runs));
        return text;
    }

    void writeTable(const Block& block) {
        std::vector<std::size_t> widths;
        for (const Row& row : block.rows)
            for (std::size_t i = 0; i < row.size(); ++i) {
                if (widths.size() <= i)
                    widths.push_back(0);
                widths[i] = std::max(widths[i], columns(cellText(row[i])));
            }
        for (const Row& row : block.rows) {
            std::string line;
            for (std::size_t i = 0; i < row.size(); ++i)
                line += (i == 0 ? "" : " | ") + padded(cellText(row[i]), widths[i]);
            text_ += finished(line) + "\n";
        }
    }

    std::string placeholder(const Block& block) const {
        if (block.kind == BlockKind::chart)
            return "[" + plain(block.runs) + "]";
        if (block.kind == BlockKind::image)
            return placeholder(block.picture);
        return block.kind == BlockKind::subdocument ? placeholder(block.subdocument) : "";
    }

    static std::string placeholder(const Picture& picture) {
        return "[Image " + picture.source +
               (picture.alternative.empty() ? "" : ": " + picture.alternative) + "]";
    }

    std::string placeholder(document::SubdocumentId id) const {
        const document::Subdocument* subdocument = document_.subdocument(id);
        if (subdocument == nullptr)
            return "[]";
        const std::string name =
            subdocument->className.empty() ? "DOCUMENT" : subdocument->className;
        return "[" + name +
               (subdocument->alternative.empty() ? "" : ": " + subdocument->alternative) + "]";
    }

    std::string plain(const std::vector<Run>& runs) const {
        std::string text;
        for (const Run& run : runs)
            if (run.kind == RunKind::subdocument)
                text += placeholder(run.subdocument);
            else if (run.picture)
                text += placeholder(*run.picture);
            else if (run.kind == RunKind::footnote)
                text += "[" + run.text + "]";
            else
                text += plainText(run);
        return text;
    }

    const document::Document& document_;
    const Model& model_;
    std::size_t width_;
    std::string text_;
};

} // namespace

std::string exportText(const document::Document& document, const Model& model, std::size_t width) {
    return TextWriter(document, model, std::max<std::size_t>(width, 20)).write();
}

} // namespace exports

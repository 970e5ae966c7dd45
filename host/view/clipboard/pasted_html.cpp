#include "clipboard/pasted_html.h"

#include "document/table_grid.h"
#include "sgml/edit.h"

#include <QTextBlock>
#include <QTextDocument>
#include <QTextFragment>
#include <QTextList>
#include <QTextTable>
#include <algorithm>
#include <utility>
#include <vector>

namespace view {

namespace {

using schemas::ContainerRole;
using schemas::Display;

// Reads no file and no address that the HTML names.
class Html : public QTextDocument {
protected:
    QVariant loadResource(int, const QUrl&) override { return {}; }
};

// Of a class's elements; "": it has none.
struct Names {
    std::string paragraph, heading, section, list, item, cell, row, table, verbatim;
    std::string emphasis, strong, code, link; // in a line
};

Names namesOf(const manuscript::Grammar& grammar) {
    const auto named = [&](auto what) { return std::string(grammar.named(what)); };
    return {.paragraph = named(ContainerRole::paragraph),
            .heading = named(ContainerRole::heading),
            .section = named(ContainerRole::section),
            .list = named(ContainerRole::list),
            .item = named(ContainerRole::item),
            .cell = named(Display::cell),
            .row = named(Display::row),
            .table = named(Display::table),
            .verbatim = named(Display::verbatim),
            .emphasis = named(ContainerRole::emphasis),
            .strong = named(ContainerRole::strong),
            .code = named(ContainerRole::code),
            .link = named(Display::link)};
}

class Reducer {
public:
    explicit Reducer(const manuscript::Grammar& grammar)
        : grammar_(grammar), names_(namesOf(grammar)) {}

    std::string reduced(const QTextDocument& html) {
        addFrame(*html.rootFrame());
        endLists(0);
        endSections(0);
        return hasText_ ? out_ : std::string();
    }

private:
    void begin(const std::string& name, const std::string& attributes = {}) {
        out_ += "<" + name + attributes + ">";
    }
    void end(const std::string& name) { out_ += "</" + name + ">"; }

    void addFrame(const QTextFrame& frame) {
        for (auto it = frame.begin(); !it.atEnd(); ++it) {
            if (const auto* table = qobject_cast<const QTextTable*>(it.currentFrame()))
                addTable(*table);
            else if (it.currentFrame())
                addFrame(*it.currentFrame());
            else
                addBlock(it.currentBlock());
        }
    }

    void addTable(const QTextTable& table) {
        endLists(0);
        const bool isInner = std::exchange(isInTable_, true);
        const bool has =
            !names_.table.empty() && !names_.row.empty() && !names_.cell.empty() && !isInner;
        if (has)
            begin(names_.table);
        for (int r = 0; r < table.rows(); ++r) {
            isInHeader_ = r < table.format().headerRowCount();
            if (has)
                begin(names_.row, kindOfRow(r));
            for (int c = 0; c < table.columns(); ++c) {
                const QTextTableCell cell = table.cellAt(r, c);
                const bool isFirst = cell.row() == r && cell.column() == c;
                if (!isFirst && hasSpans())
                    continue;
                if (has)
                    begin(names_.cell, isFirst ? spansOf(cell) : std::string());
                if (isFirst)
                    addCell(cell, has);
                if (has)
                    end(names_.cell);
            }
            if (has)
                end(names_.row);
        }
        if (has)
            end(names_.table);
        isInHeader_ = false;
        isInTable_ = isInner;
    }
    // A class without spans gets empty cells in the places that a cell covers.
    [[nodiscard]] bool hasSpans() const {
        return grammar_.hasAttribute(names_.cell, "COLUMNS") &&
               grammar_.hasAttribute(names_.cell, "ROWS");
    }
    [[nodiscard]] std::string spansOf(const QTextTableCell& cell) const {
        std::string attributes;
        const auto add = [&](const char* name, int span) {
            const int most = static_cast<int>(document::mostSpanned);
            if (span > 1)
                attributes += " " + sgml::attributeText(name, std::to_string(std::min(span, most)));
        };
        if (hasSpans()) {
            add("COLUMNS", cell.columnSpan());
            add("ROWS", cell.rowSpan());
        }
        return attributes;
    }
    // HTML without a header says nothing, and the class decides.
    [[nodiscard]] std::string kindOfRow(int row) const {
        const bool isSaid = isInHeader_ && grammar_.hasAttribute(names_.row, "KIND") &&
                            !(row == 0 && grammar_.of(names_.row).isHeaderFirst);
        return isSaid ? " " + sgml::attributeText("KIND", "header") : std::string();
    }

    // A cell of one line has no paragraph of its own.
    void addCell(const QTextTableCell& cell, bool isCell) {
        const QTextBlock first = cell.firstCursorPosition().block();
        if (isCell && first == cell.lastCursorPosition().block() && !first.textList()) {
            addLine(first);
            return;
        }
        for (auto it = cell.begin(); !it.atEnd(); ++it)
            if (it.currentFrame())
                addFrame(*it.currentFrame());
            else
                addBlock(it.currentBlock());
        endLists(0);
    }

    void addBlock(const QTextBlock& block) {
        const QTextList* list =
            names_.list.empty() || names_.item.empty() ? nullptr : block.textList();
        if (list) {
            addItem(block, *list);
            return;
        }
        endLists(0);
        if (block.text().trimmed().isEmpty())
            return;
        if (!names_.verbatim.empty() && block.blockFormat().nonBreakableLines()) {
            addVerbatim(block);
            return;
        }
        isBehindVerbatim_ = false;
        const int level = block.blockFormat().headingLevel();
        if (level > 0 && !isInTable_ && !names_.section.empty() && !names_.heading.empty()) {
            endSections(level - 1);
            begin(names_.section);
            sections_.push_back(level);
            begin(names_.heading);
            isInHeading_ = true;
            addLine(block);
            isInHeading_ = false;
            end(names_.heading);
            return;
        }
        begin(names_.paragraph);
        addLine(block);
        end(names_.paragraph);
    }

    // Lines that follow each other are one piece.
    void addVerbatim(const QTextBlock& block) {
        const std::string close = "}</" + names_.verbatim + ">";
        if (isBehindVerbatim_ && out_.ends_with(close))
            out_.resize(out_.size() - close.size());
        else
            out_ += "<" + names_.verbatim + ">{";
        if (!out_.ends_with('{'))
            out_ += '\n';
        out_ += sgml::escaped(textOf(block.text())) + close;
        hasText_ = isBehindVerbatim_ = true;
    }

    void addItem(const QTextBlock& block, const QTextList& list) {
        const auto depth = static_cast<std::size_t>(std::max(1, list.format().indent()));
        endLists(depth);
        if (lists_.size() == depth && lists_.back() != &list)
            endLists(depth - 1);
        if (lists_.size() == depth)
            end(names_.item); // the one before
        while (lists_.size() < depth) {
            begin(names_.list, lists_.size() + 1 == depth ? kindOf(list) : std::string());
            lists_.push_back(&list);
            begin(names_.item);
        }
        if (out_.ends_with("</" + names_.item + ">"))
            begin(names_.item);
        // Only a list may follow in the item.
        begin(names_.paragraph);
        addLine(block);
        end(names_.paragraph);
    }
    [[nodiscard]] std::string kindOf(const QTextList& list) const {
        const auto style = list.format().style();
        const bool isNumbered = style <= QTextListFormat::ListDecimal;
        const auto& kinds = grammar_.variants(names_.list);
        return isNumbered && !kinds.empty()
                   ? " " + sgml::attributeText(kinds.front().attribute, kinds.front().value)
                   : std::string();
    }
    void endLists(std::size_t depth) {
        for (; lists_.size() > depth; lists_.pop_back()) {
            end(names_.item);
            end(names_.list);
        }
    }
    void endSections(int level) {
        for (; !sections_.empty() && sections_.back() > level; sections_.pop_back())
            end(names_.section);
    }

    // Letters with their emphasis, in the same order of elements.
    void addLine(const QTextBlock& block) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment fragment = it.fragment();
            const QTextCharFormat format = fragment.charFormat();
            if (!fragment.isValid() || format.isImageFormat())
                continue;
            std::vector<std::string> around;
            const auto wrap = [&](bool wanted, const std::string& name,
                                  const std::string& attributes = {}) {
                if (!wanted || name.empty())
                    return;
                begin(name, attributes);
                around.push_back(name);
            };
            const QString target = format.anchorHref();
            wrap(!target.isEmpty() && !target.startsWith('#'), names_.link,
                 " " + sgml::attributeText("TO", target.toStdString()));
            wrap(format.fontWeight() > QFont::Medium && !isInHeading_ && !isInHeader_,
                 names_.strong);
            wrap(format.fontItalic(), names_.emphasis);
            wrap(format.fontFixedPitch(), names_.code);
            const std::string letters = textOf(fragment.text());
            // Beside other elements text stands in one of its own.
            out_ += around.empty() ? sgml::elementText("TEXT", letters)
                                   : "{" + sgml::escaped(letters) + "}";
            hasText_ |= !fragment.text().trimmed().isEmpty();
            for (; !around.empty(); around.pop_back())
                end(around.back());
        }
    }
    static std::string textOf(QString text) {
        return text.replace(QChar::LineSeparator, ' ')
            .replace(QChar::ObjectReplacementCharacter, ' ')
            .toStdString();
    }

    const manuscript::Grammar& grammar_;
    const Names names_;
    std::string out_;
    std::vector<const QTextList*> lists_; // that are open
    std::vector<int> sections_;           // levels of those that are open
    bool isInTable_ = false;
    bool isInHeader_ = false; // of a table
    bool isInHeading_ = false;
    bool isBehindVerbatim_ = false;
    bool hasText_ = false;
};

} // namespace

std::string fragmentOf(const QString& html, const manuscript::Grammar& grammar) {
    if (html.size() > longestHtml || grammar.named(ContainerRole::paragraph).empty())
        return {};
    Html document;
    document.setHtml(html);
    return Reducer(grammar).reduced(document);
}

} // namespace view

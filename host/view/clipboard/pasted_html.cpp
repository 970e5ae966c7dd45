#include "clipboard/pasted_html.h"

#include "sgml/edit.h"

#include <QTextBlock>
#include <QTextDocument>
#include <QTextFragment>
#include <QTextList>
#include <QTextTable>
#include <algorithm>
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

class Reducer {
public:
    explicit Reducer(const manuscript::Grammar& grammar)
        : grammar_(grammar), paragraph_(named(ContainerRole::paragraph)),
          heading_(named(ContainerRole::heading)), section_(named(ContainerRole::section)),
          list_(named(ContainerRole::list)), item_(named(ContainerRole::item)),
          cell_(grammar.named(Display::cell)), row_(grammar.named(Display::row)),
          table_(grammar.named(Display::table)), verbatim_(grammar.named(Display::verbatim)) {}

    std::string reduced(const QTextDocument& html) {
        addFrame(*html.rootFrame());
        endLists(0);
        endSections(0);
        return hasText_ ? out_ : std::string();
    }

private:
    [[nodiscard]] std::string named(ContainerRole role) const {
        return std::string(grammar_.named(role));
    }
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
        const bool has = !table_.empty() && !row_.empty() && !cell_.empty() && !isInTable_;
        isInTable_ = true;
        if (has)
            begin(table_);
        for (int r = 0; r < table.rows(); ++r) {
            if (has)
                begin(row_);
            for (int c = 0; c < table.columns(); ++c) {
                const QTextTableCell cell = table.cellAt(r, c);
                if (has)
                    begin(cell_);
                // One that spans several places stands in the first.
                if (cell.row() == r && cell.column() == c)
                    addCell(cell, has);
                if (has)
                    end(cell_);
            }
            if (has)
                end(row_);
        }
        if (has)
            end(table_);
        isInTable_ = false;
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
        const QTextList* list = list_.empty() || item_.empty() ? nullptr : block.textList();
        if (list) {
            addItem(block, *list);
            return;
        }
        endLists(0);
        if (block.text().trimmed().isEmpty())
            return;
        if (!verbatim_.empty() && block.blockFormat().nonBreakableLines()) {
            addVerbatim(block);
            return;
        }
        isBehindVerbatim_ = false;
        const int level = block.blockFormat().headingLevel();
        if (level > 0 && !isInTable_ && !section_.empty() && !heading_.empty()) {
            endSections(level - 1);
            begin(section_);
            sections_.push_back(level);
            begin(heading_);
            isInHeading_ = true;
            addLine(block);
            isInHeading_ = false;
            end(heading_);
            return;
        }
        begin(paragraph_);
        addLine(block);
        end(paragraph_);
    }

    // Lines that follow each other are one piece.
    void addVerbatim(const QTextBlock& block) {
        const std::string close = "}</" + verbatim_ + ">";
        if (isBehindVerbatim_ && out_.ends_with(close))
            out_.resize(out_.size() - close.size());
        else
            out_ += "<" + verbatim_ + ">{";
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
            end(item_); // the one before
        while (lists_.size() < depth) {
            begin(list_, lists_.size() + 1 == depth ? kindOf(list) : std::string());
            lists_.push_back(&list);
            begin(item_);
        }
        if (out_.ends_with("</" + item_ + ">"))
            begin(item_);
        // Only a list may follow in the item.
        begin(paragraph_);
        addLine(block);
        end(paragraph_);
    }
    [[nodiscard]] std::string kindOf(const QTextList& list) const {
        const auto style = list.format().style();
        const bool isNumbered = style <= QTextListFormat::ListDecimal;
        const auto& kinds = grammar_.variants(list_);
        return isNumbered && !kinds.empty()
                   ? " " + sgml::attributeText(kinds.front().attribute, kinds.front().value)
                   : std::string();
    }
    void endLists(std::size_t depth) {
        for (; lists_.size() > depth; lists_.pop_back()) {
            end(item_);
            end(list_);
        }
    }
    void endSections(int level) {
        for (; !sections_.empty() && sections_.back() > level; sections_.pop_back())
            end(section_);
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
            wrap(!target.isEmpty() && !target.startsWith('#'),
                 std::string(grammar_.named(Display::link)),
                 " " + sgml::attributeText("TO", target.toStdString()));
            wrap(format.fontWeight() > QFont::Medium && !isInHeading_,
                 named(ContainerRole::strong));
            wrap(format.fontItalic(), named(ContainerRole::emphasis));
            wrap(format.fontFixedPitch(), named(ContainerRole::code));
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
    const std::string paragraph_, heading_, section_, list_, item_, cell_, row_, table_, verbatim_;
    std::string out_;
    std::vector<const QTextList*> lists_; // that are open
    std::vector<int> sections_;           // levels of those that are open
    bool isInTable_ = false;
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

#include "clipboard/copying.h"

#include "excerpts/selected.h"
#include "exports/copy_export.h"
#include "exports/fragment.h"

#include <algorithm>
#include <set>

namespace view {

namespace {

using Cells = std::set<sgml::NodeId>;

// The table that has them, with nothing else; null: there is none.
std::shared_ptr<const model::Block> tableOf(const model::Blocks& blocks, const Cells& cells) {
    for (const std::shared_ptr<const model::Block>& block : blocks) {
        auto part = std::make_shared<model::Block>(*block);
        part->rows.clear();
        for (const model::Row& row : block->rows) {
            model::Row kept;
            for (const model::Cell& cell : row) {
                if (cells.contains(cell.element))
                    kept.push_back(cell);
                else if (auto inside = tableOf(cell.blocks, cells))
                    return inside;
            }
            if (!kept.empty())
                part->rows.push_back(std::move(kept));
        }
        if (!part->rows.empty())
            return part;
    }
    return nullptr;
}

std::string fragmentOf(const sgml::Tree& tree, const std::vector<sgml::NodeId>& cells) {
    const auto tagged = [&](sgml::NodeId element, const std::string& inside) {
        const std::string name(tree.name(element));
        return "<" + name + ">" + inside + "</" + name + ">";
    };
    std::string rows, row;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        row += tree.text(tree.node(cells[i]).range);
        const sgml::NodeId of = tree.node(cells[i]).parent;
        if (i + 1 == cells.size() || tree.node(cells[i + 1]).parent != of)
            rows += tagged(of, std::exchange(row, {})) + "\n";
    }
    return tagged(tree.node(tree.node(cells.front()).parent).parent, rows);
}

std::unique_ptr<QMimeData> asMimeData(const document::Document& document, const model::Model& part,
                                      const std::string& fragment) {
    auto result = std::make_unique<QMimeData>();
    result->setText(QString::fromStdString(exports::copiedText(document, part)));
    result->setHtml(QString::fromStdString(exports::copiedHtml(document, part)));
    if (!fragment.empty())
        result->setData(fragmentFormat, QByteArray::fromStdString(fragment));
    return result;
}

} // namespace

std::unique_ptr<QMimeData> copied(const document::Document& document, const model::Model& model,
                                  text::Range interval) {
    return asMimeData(document, model::excerpt(document.tree(), model, interval),
                      exports::fragment(document.tree(), interval));
}

std::unique_ptr<QMimeData> copied(const document::Document& document, const model::Model& model,
                                  const std::vector<sgml::NodeId>& cells) {
    const std::shared_ptr<const model::Block> table =
        tableOf(model.blocks, Cells(cells.begin(), cells.end()));
    model::Model part;
    part.textStyles = model.textStyles;
    if (table)
        part.blocks.push_back(table);
    return asMimeData(document, part, fragmentOf(document.tree(), cells));
}

} // namespace view

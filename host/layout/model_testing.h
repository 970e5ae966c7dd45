// Blocks of models for tests of the layout, without a document.
#pragma once

#include "model/model.h"

#include <memory>
#include <string>

namespace layout {

using NewBlock = std::shared_ptr<model::Block>;

inline NewBlock paragraph(const std::string& text) {
    auto block = std::make_shared<model::Block>();
    block->runs.emplace_back().text = text;
    return block;
}

// With the mark of a footnote behind the text.
inline NewBlock noted(const std::string& text, const std::string& mark, const std::string& note) {
    NewBlock block = paragraph(text);
    auto footnote = std::make_shared<model::Footnote>();
    footnote->blocks.push_back(paragraph(note));
    model::Run& run = block->runs.emplace_back();
    run.kind = model::RunKind::footnote;
    run.text = mark;
    run.footnote = footnote;
    return block;
}

inline NewBlock picture(document::SubdocumentId id) {
    auto block = std::make_shared<model::Block>();
    block->kind = model::BlockKind::subdocument;
    block->subdocument = id;
    block->style.keepWithNext = true;
    return block;
}

inline NewBlock tableOf(std::vector<model::Row> rows) {
    auto block = std::make_shared<model::Block>();
    block->kind = model::BlockKind::table;
    block->rows = std::move(rows);
    return block;
}

} // namespace layout

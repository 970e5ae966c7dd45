// Blocks of models for tests of the layout, without a document.
#pragma once

#include "document/model.h"

#include <memory>
#include <string>

namespace layout {

using NewBlock = std::shared_ptr<document::Block>;

inline NewBlock paragraph(const std::string& text) {
    auto block = std::make_shared<document::Block>();
    block->runs.emplace_back().text = text;
    return block;
}

// With the mark of a footnote behind the text.
inline NewBlock noted(const std::string& text, const std::string& mark, const std::string& note) {
    NewBlock block = paragraph(text);
    auto footnote = std::make_shared<document::Footnote>();
    footnote->blocks.push_back(paragraph(note));
    document::Run& run = block->runs.emplace_back();
    run.kind = document::RunKind::footnote;
    run.text = mark;
    run.footnote = footnote;
    return block;
}

inline NewBlock picture(document::SubdocumentId id) {
    auto block = std::make_shared<document::Block>();
    block->kind = document::BlockKind::subdocument;
    block->subdocument = id;
    block->style.keepWithNext = true;
    return block;
}

inline NewBlock tableOf(std::vector<document::Row> rows) {
    auto block = std::make_shared<document::Block>();
    block->kind = document::BlockKind::table;
    block->rows = std::move(rows);
    return block;
}

} // namespace layout

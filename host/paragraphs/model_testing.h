// Blocks of models for tests of the layout, without a document.
#pragma once

#include "model/model.h"

#include <memory>
#include <string>

namespace paragraphs {

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
    block->style.mayFloat = true;
    return block;
}

inline model::Run formulaRun(const std::string& source, bool isAlone = false) {
    auto formula = std::make_shared<model::Formula>();
    formula->source = source;
    formula->read = formulas::read(source);
    formula->isAlone = isAlone;
    model::Run run;
    run.kind = model::RunKind::formula;
    run.text = formulas::plain(formula->read);
    run.formula = std::move(formula);
    return run;
}

// A formula alone, with its number.
inline NewBlock display(const std::string& source, const std::string& number = {}) {
    auto block = std::make_shared<model::Block>();
    block->kind = model::BlockKind::formula;
    block->style.align = schemas::Align::center;
    block->marker = number;
    block->runs.push_back(formulaRun(source, true));
    return block;
}

inline NewBlock tableOf(std::vector<model::Row> rows) {
    auto block = std::make_shared<model::Block>();
    block->kind = model::BlockKind::table;
    block->rows = std::move(rows);
    return block;
}

} // namespace paragraphs

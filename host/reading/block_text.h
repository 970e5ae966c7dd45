// The text of a block for those who hear it: its marker, its letters, formulas and figures in
// words; and the places of the document that its letters are at.
#pragma once

#include "document/document.h"
#include "excerpts/selected.h"

#include <QString>

namespace reading {

using model::Block, model::Run;

class BlockText {
public:
    BlockText(const document::Document& document, std::shared_ptr<const Block> block);

    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] const std::shared_ptr<const Block>& block() const { return block_; }
    // The place of the document before a letter; in a unit that of its nearer end, in what else is
    // generated that of the next text.
    [[nodiscard]] std::optional<std::size_t> placeOf(int letter) const;
    // The letter behind a place, the nearest one where it is not shown.
    [[nodiscard]] int letterAt(std::size_t place) const;

    // The letters of a run; the marker is none.
    struct Part {
        int from = 0, to = 0;
        const Run* run = nullptr; // of the block
    };
    [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

    // How many letters this thread has put together, for tests.
    static thread_local std::size_t letters;

private:
    [[nodiscard]] bool isUnit(const model::RunPlaces& places, const Part& part) const;

    const document::Document& document_;
    std::shared_ptr<const Block> block_;
    QString text_;
    std::vector<Part> parts_; // in order
};

// The words that stand for a figure: its alternative text, else what it is.
[[nodiscard]] QString wordsFor(const document::Document& document, const Block& figure);
[[nodiscard]] QString wordsFor(const document::Document& document, const Run& run);

} // namespace reading

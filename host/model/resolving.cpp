#include "model/resolving.h"

namespace model {

namespace {

// Tables and footnotes are not nested deeper than deepestTable and deepestFootnote.
bool resolve(Blocks& blocks, const RunNow& runNow) {
    bool changed = false;
    for (std::shared_ptr<const Block>& block : blocks) {
        std::shared_ptr<const Block> now = resolved(block, runNow);
        changed = changed || now != block;
        block = std::move(now);
    }
    return changed;
}

} // namespace

std::shared_ptr<const Block> resolved(const std::shared_ptr<const Block>& block,
                                      const RunNow& runNow) {
    std::shared_ptr<Block> copy; // when there is something to change
    const auto changed = [&]() -> Block& {
        if (!copy)
            copy = std::make_shared<Block>(*block);
        return *copy;
    };
    for (std::size_t i = 0; i < block->runs.size(); ++i) {
        const Run& run = block->runs[i];
        if (std::optional<Run> now = runNow(run))
            changed().runs[i] = std::move(*now);
        if (run.footnote)
            if (Blocks inside = run.footnote->blocks; resolve(inside, runNow)) {
                const auto footnote = std::make_shared<Footnote>(*run.footnote);
                footnote->blocks = std::move(inside);
                changed().runs[i].footnote = footnote;
            }
    }
    for (std::size_t r = 0; r < block->rows.size(); ++r)
        for (std::size_t c = 0; c < block->rows[r].size(); ++c)
            if (Blocks inside = block->rows[r][c].blocks; resolve(inside, runNow))
                changed().rows[r][c].blocks = std::move(inside);
    return copy ? copy : block;
}

} // namespace model

#include "model/references.h"

namespace model {

References::References(const ModelWalk::Trail& trail) {
    for (const ModelWalk::Segment& segment : trail)
        for (const Name& name : segment.names)
            names_.try_emplace(name.id, name.reference);
}

bool References::differFrom(const References& other) const { return names_ != other.names_; }

std::string References::textOf(const std::string& id) const {
    const auto known = names_.find(id);
    std::string text = known == names_.end() || known->second.empty() ? id : known->second;
    // "Figure 1" is not broken between its words.
    for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at))
        text.replace(at, 1, "\u00A0");
    return text;
}

// Tables and footnotes are not nested deeper than deepestTable and deepestFootnote.
bool References::resolve(Blocks& blocks) const {
    bool changed = false;
    for (std::shared_ptr<const Block>& block : blocks) {
        std::shared_ptr<const Block> now = resolved(block);
        changed = changed || now != block;
        block = std::move(now);
    }
    return changed;
}

std::shared_ptr<const Block> References::resolved(const std::shared_ptr<const Block>& block) const {
    std::shared_ptr<Block> copy; // when there is something to change
    const auto changed = [&]() -> Block& {
        if (!copy)
            copy = std::make_shared<Block>(*block);
        return *copy;
    };
    for (std::size_t i = 0; i < block->runs.size(); ++i) {
        const Run& run = block->runs[i];
        if (run.refers)
            if (std::string text = textOf(run.target.substr(1)); text != run.text)
                changed().runs[i].text = std::move(text);
        if (run.footnote)
            if (Blocks inside = run.footnote->blocks; resolve(inside)) {
                const auto footnote = std::make_shared<Footnote>(*run.footnote);
                footnote->blocks = std::move(inside);
                changed().runs[i].footnote = footnote;
            }
    }
    for (std::size_t r = 0; r < block->rows.size(); ++r)
        for (std::size_t c = 0; c < block->rows[r].size(); ++c)
            if (Blocks inside = block->rows[r][c].blocks; resolve(inside))
                changed().rows[r][c].blocks = std::move(inside);
    return copy ? copy : block;
}

} // namespace model

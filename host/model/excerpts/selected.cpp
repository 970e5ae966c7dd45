#include "excerpts/selected.h"

#include <algorithm>

namespace model {

using sgml::noNode;

// --- places of runs ----------------------------------------------------------------------------

const sgml::Unescaped& RunPlaces::unescaped(sgml::NodeId content) const {
    if (content != last_) {
        unescaped_ = tree_.unescaped(content);
        last_ = content;
    }
    return unescaped_;
}

std::size_t RunPlaces::placeOf(const Run& run, std::size_t byte) const {
    const sgml::Unescaped& of = unescaped(run.content);
    const std::size_t in = run.offset + std::min(byte, run.text.size());
    return of.fileOffset(std::min(in, of.text().size()));
}

std::size_t RunPlaces::byteAt(const Run& run, std::size_t place) const {
    const text::Range content = tree_.contentRange(run.content);
    const sgml::Unescaped& of = unescaped(run.content);
    const std::size_t in = place <= content.from ? 0
                           : place >= content.to ? of.text().size()
                                                 : of.textOffset(place);
    return std::min(in - std::min(in, run.offset), run.text.size());
}

// --- selected runs -----------------------------------------------------------------------------

namespace {

SelectedRun selectedText(const RunPlaces& places, const Run& run, text::Range interval) {
    const std::size_t first = places.placeOf(run, 0);
    const std::size_t last = places.placeOf(run, run.text.size());
    if (interval.to < first || interval.from > last)
        return {};
    const text::Range bytes{places.byteAt(run, interval.from), places.byteAt(run, interval.to)};
    return {bytes, !bytes.empty() || (run.text.empty() && !interval.empty())};
}

} // namespace

std::vector<SelectedRun> selectedRuns(const RunPlaces& places, const Block& block,
                                      text::Range interval) {
    std::vector<SelectedRun> result(block.runs.size());
    std::optional<std::size_t> before; // the end of the text before what is generated
    std::size_t generated = 0;         // the first of these runs
    const auto mark = [&](std::size_t end, bool isIn) {
        for (; generated < end; ++generated)
            result[generated] = {{0, block.runs[generated].text.size()}, isIn};
    };
    for (std::size_t i = 0; i < block.runs.size(); ++i) {
        const Run& run = block.runs[i];
        if (!places.isText(run))
            continue;
        result[i] = selectedText(places, run, interval);
        const std::size_t first = places.placeOf(run, 0);
        mark(i, interval.to > first && interval.from <= before.value_or(first));
        before = places.placeOf(run, run.text.size());
        generated = i + 1;
    }
    mark(block.runs.size(), before && interval.from <= *before && interval.to > *before);
    for (std::size_t i = 0; i < block.runs.size(); ++i)
        if (places.isUnit(block.runs[i])) {
            const text::Range own = places.rangeOf(block.runs[i]);
            result[i].isIn |= interval.from <= own.from && own.to <= interval.to;
        }
    return result;
}

// --- an excerpt --------------------------------------------------------------------------------

namespace {

class Excerpt {
public:
    Excerpt(const sgml::Tree& tree, text::Range interval)
        : tree_(tree), places_(tree), interval_(interval) {}

    Model of(const Model& model) {
        result_.page = model.page;
        result_.textStyles = model.textStyles;
        result_.title = model.title;
        cut(model.blocks, model.containers, result_.blocks, result_.containers);
        for (const std::shared_ptr<const Footnote>& note : model.footnotes)
            if (std::ranges::find(result_.footnotes, note) == result_.footnotes.end())
                cut(note->blocks, note->containers, result_.blocks, result_.containers);
        return std::move(result_);
    }

private:
    void cut(const Blocks& blocks, const Containers& containers, Blocks& out, Containers& outer) {
        std::vector<std::size_t> kept; // how many of the blocks before each
        const std::size_t base = out.size();
        for (const std::shared_ptr<const Block>& block : blocks) {
            kept.push_back(out.size() - base);
            if (const std::shared_ptr<const Block> part = cut(block))
                out.push_back(part);
        }
        kept.push_back(out.size() - base);
        for (Container container : containers) {
            const std::size_t first = kept[container.first], end = kept[container.last + 1];
            if (first == end)
                continue;
            container.first = base + first;
            container.last = base + end - 1;
            outer.push_back(container);
        }
    }

    [[nodiscard]] bool isInside(sgml::NodeId element) const {
        if (element == noNode || !tree_.holds(element))
            return false;
        const text::Range range = tree_.node(element).range;
        return interval_.from <= range.from && range.to <= interval_.to;
    }

    // Null: nothing of it is selected.
    std::shared_ptr<const Block> cut(const std::shared_ptr<const Block>& block) {
        switch (block->kind) {
        case BlockKind::text:
        case BlockKind::verbatim:
            return cutText(*block);
        case BlockKind::table:
            return cutTable(*block);
        default:
            return isInside(block->element) ? block : nullptr;
        }
    }

    std::shared_ptr<const Block> cutText(const Block& block) {
        const std::vector<SelectedRun> selected = selectedRuns(places_, block, interval_);
        auto part = std::make_shared<Block>(block);
        part->runs.clear();
        for (std::size_t i = 0; i < selected.size(); ++i) {
            if (!selected[i].isIn)
                continue;
            Run& run = part->runs.emplace_back(block.runs[i]);
            run.text = run.text.substr(selected[i].bytes.from, selected[i].bytes.size());
            run.offset += selected[i].bytes.from;
            if (run.footnote)
                result_.footnotes.push_back(run.footnote);
        }
        if (part->runs.empty())
            return nullptr;
        if (!selected.front().isIn || selected.front().bytes.from > 0) {
            part->marker.clear();
            part->headingLevel = 0;
        }
        return part;
    }

    std::shared_ptr<const Block> cutTable(const Block& table) {
        auto part = std::make_shared<Block>(table);
        part->rows.clear();
        for (const Row& row : table.rows) {
            Row cells;
            bool isIn = false;
            for (const Cell& cell : row) {
                Cell& out = cells.emplace_back();
                out.element = cell.element;
                out.style = cell.style;
                out.span = cell.span;
                cut(cell.blocks, cell.containers, out.blocks, out.containers);
                isIn = isIn || !out.blocks.empty();
            }
            if (isIn)
                part->rows.push_back(std::move(cells));
        }
        return part->rows.empty() ? nullptr : part;
    }

    const sgml::Tree& tree_;
    RunPlaces places_;
    text::Range interval_;
    Model result_;
};

} // namespace

Model excerpt(const sgml::Tree& tree, const Model& model, text::Range interval) {
    return Excerpt(tree, interval).of(model);
}

} // namespace model

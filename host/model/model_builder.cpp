#include "model/model_builder.h"

#include "model/contents.h"
#include "model/same_blocks.h"
#include "model/value_text.h"

#include <algorithm>

namespace model {

ModelBuilder::ModelBuilder(const document::Document& document,
                           const schemas::Presentation& presentation,
                           const schemas::Schemas& schemas,
                           std::shared_ptr<schemas::TextStyles> styles, int spacing)
    : document_(document), presentation_(presentation), schemas_(schemas),
      styles_(std::move(styles)), spacing_(spacing) {}

// --- changes --------------------------------------------------------------------------------

namespace {

// Grows a range of bytes by another one.
void cover(text::Range& all, text::Range part) {
    all = {std::min(all.from, part.from), std::max(all.to, part.to)};
}

} // namespace

// All that is not as it was lies in the bytes that are edited or were read again.
ModelBuilder::Region ModelBuilder::regionOf(const sgml::Change& change) const {
    const std::size_t size = document_.bytes().size();
    std::size_t added = 0, removed = 0; // bytes
    text::Range all{size, 0};
    for (const text::Edit& edit : change.edits) {
        const std::size_t from = edit.range.from + added - removed;
        cover(all, {from, from + edit.text.size()});
        added += edit.text.size();
        removed += edit.range.to - edit.range.from;
    }
    for (const text::Range read : change.read)
        cover(all, read);
    if (change.everything)
        all = {0, size};
    return {.from = all.from, .to = all.to + removed - added, .end = all.to};
}

void ModelBuilder::follow(const sgml::Change& change) {
    walk_.reset();
    if (!model_)
        return; // it is made from the beginning anyway
    const Region next = regionOf(change);
    if (!region_) {
        region_ = next;
        return;
    }
    // One region for both: [from, to) of the first text, its end in the last one.
    const std::size_t between = std::max(region_->end, next.to);
    *region_ = {.from = std::min(region_->from, next.from),
                .to = region_->to + (between - region_->end),
                .end = next.end + (between - next.to)};
}

// --- the walk -------------------------------------------------------------------------------

bool ModelBuilder::step(int nodes) {
    if (model_ && !region_)
        return false;
    if (!walk_)
        begin();
    for (; nodes > 0; --nodes) {
        if (walk_->isAtEnd() || meets()) {
            finish();
            return false;
        }
        walk_->next();
        ++work_.nodes;
    }
    return true;
}

void ModelBuilder::begin() {
    walk_ = std::make_unique<ModelWalk>(document_, presentation_, schemas_, styles_, spacing_);
    resumed_ = 0;
    ahead_ = trail_.size();
    if (!region_)
        return;
    const auto behind = [this](std::size_t offset) {
        const auto first = std::partition_point(
            trail_.begin(), trail_.end(),
            [&](const ModelWalk::Segment& segment) { return segment.begin.offset < offset; });
        return static_cast<std::size_t>(first - trail_.begin());
    };
    resumed_ = std::max<std::size_t>(behind(region_->from), 1) - 1;
    while (resumed_ > 0 && !walk_->stillHolds(trail_[resumed_].begin))
        --resumed_;
    ahead_ = std::max(behind(region_->to), resumed_ + 1);
    if (resumed_ == 0)
        return;
    const ModelWalk::Checkpoint& from = trail_[resumed_].begin;
    Model model;
    model.page = model_->page;
    model.textStyles = styles_;
    const auto copyFirst = [](const auto& all, auto& to, std::size_t count) {
        to.reserve(all.size() + 1);
        to.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    };
    copyFirst(model_->blocks, model.blocks, from.blocksBefore);
    copyFirst(model_->boxes, model.boxes, from.boxesBefore);
    copyFirst(model_->containers, model.containers, from.containersBefore);
    copyFirst(model_->footnotes, model.footnotes, from.state.footnotes);
    model.title = from.state.titled ? model_->title : "";
    walk_->resume(from, std::move(model));
}

// Looks for the old checkpoint that stands before the same node, and passes those that will never
// be met.
bool ModelBuilder::meets() {
    const std::size_t place = document_.tree().node(walk_->at()).range.from;
    for (; ahead_ < trail_.size(); ++ahead_) {
        const ModelWalk::Checkpoint& old = trail_[ahead_].begin;
        const std::size_t then = old.offset + region_->end - region_->to;
        if (place < then || (place == then && walk_->at() != old.state.at))
            return false;
        if (place == then && walk_->isAt(old))
            return true;
    }
    return false;
}

// --- the new model --------------------------------------------------------------------------

namespace {

using Trail = ModelWalk::Trail;

std::vector<Name> namesIn(Trail::const_iterator from, Trail::const_iterator to) {
    std::vector<Name> names;
    for (; from != to; ++from)
        names.insert(names.end(), from->names.begin(), from->names.end());
    return names;
}

void addFootnotesOf(const Block& block, std::vector<std::shared_ptr<const Footnote>>& footnotes) {
    for (const Run& run : block.runs) {
        if (!run.footnote)
            continue;
        footnotes.push_back(run.footnote);
        for (const std::shared_ptr<const Block>& inside : run.footnote->blocks)
            addFootnotesOf(*inside, footnotes);
    }
    for (const Row& row : block.rows)
        for (const Cell& cell : row)
            for (const std::shared_ptr<const Block>& inside : cell.blocks)
                addFootnotesOf(*inside, footnotes);
}

} // namespace

void ModelBuilder::finish() {
    static const Model nothing;
    const Model& old = model_ ? *model_ : nothing;
    Model& model = walk_->model();
    if (walk_->isAtEnd())
        ahead_ = trail_.size();
    const bool met = ahead_ < trail_.size();
    const std::size_t first = walk_->trail().front().begin.blocksBefore, end = model.blocks.size();
    const std::size_t footnotes = walk_->trail().front().begin.state.footnotes;
    const Replaced replaced{.old = old.blocks,
                            .from = first,
                            .to = met ? trail_[ahead_].begin.blocksBefore : old.blocks.size(),
                            .now = model.blocks,
                            .first = first,
                            .end = end};
    const std::size_t footnotesBehind =
        met ? trail_[ahead_].begin.state.footnotes : old.footnotes.size();
    if (met)
        join(model);
    const bool elsewhere = resolve(model, spliceTrail());
    work_.blocks += keepOld(replaced);
    work_.blocks += fillContents(model, old.blocks);
    model.footnotes.resize(elsewhere ? 0 : footnotes);
    for (std::size_t i = elsewhere ? 0 : first; i < (elsewhere ? model.blocks.size() : end); ++i)
        addFootnotesOf(*model.blocks[i], model.footnotes);
    if (!elsewhere)
        model.footnotes.insert(model.footnotes.end(),
                               old.footnotes.begin() + static_cast<std::ptrdiff_t>(footnotesBehind),
                               old.footnotes.end());
    model_ = std::make_shared<const Model>(std::move(model));
    walk_.reset();
    region_.reset();
}

namespace {

// Ranges of blocks that were opened behind a checkpoint come behind those of a new walk; ranges
// that were open there, and have other numbers now, end where they did.
class Ranges {
public:
    // Ranges before the checkpoint, in the old model and now, and by how much blocks moved.
    Ranges(std::size_t then, std::size_t now, std::size_t blocks)
        : then_(then), now_(now), blocks_(blocks) {}

    template <class Range>
    void append(const std::vector<Range>& old, std::vector<Range>& model) const {
        for (std::size_t i = then_; i < old.size(); ++i) {
            model.push_back(old[i]);
            model.back().first += blocks_;
            model.back().last += blocks_;
        }
    }
    template <class Range>
    void end(const std::vector<Range>& old, std::size_t was, std::vector<Range>& model,
             std::size_t is) const {
        if (is != ModelWalk::none)
            model[is].last = old[was].last + blocks_;
    }
    // The number of a range of the old model; `open`: of what is open there now.
    [[nodiscard]] std::size_t moved(std::size_t range, std::size_t open) const {
        if (range == ModelWalk::none)
            return range;
        return range < then_ ? open : range - then_ + now_;
    }

private:
    std::size_t then_, now_, blocks_;
};

} // namespace

// The blocks behind the checkpoint that was met are as it was, only further on or back.
void ModelBuilder::join(Model& model) {
    const ModelWalk::Checkpoint now = walk_->checkpoint();
    const ModelWalk::Checkpoint then = trail_[ahead_].begin;
    // Differences of unsigned numbers wrap, and so do sums with them.
    const std::size_t blocks = now.blocksBefore - then.blocksBefore;
    const Ranges boxes(then.boxesBefore, now.boxesBefore, blocks);
    const Ranges containers(then.containersBefore, now.containersBefore, blocks);
    boxes.append(model_->boxes, model.boxes);
    containers.append(model_->containers, model.containers);
    for (std::size_t i = 0; i < now.opened.size(); ++i) {
        boxes.end(model_->boxes, then.opened[i].box, model.boxes, now.opened[i].box);
        containers.end(model_->containers, then.opened[i].container, model.containers,
                       now.opened[i].container);
    }
    model.blocks.insert(model.blocks.end(),
                        model_->blocks.begin() + static_cast<std::ptrdiff_t>(then.blocksBefore),
                        model_->blocks.end());
    if (!now.state.titled)
        model.title = model_->title;
    for (std::size_t s = ahead_; s < trail_.size(); ++s) {
        ModelWalk::Checkpoint& begin = trail_[s].begin;
        begin.offset += now.offset - then.offset;
        begin.blocksBefore += blocks;
        begin.boxesBefore += now.boxesBefore - then.boxesBefore;
        begin.containersBefore += now.containersBefore - then.containersBefore;
        for (std::size_t i = 0; i < begin.opened.size(); ++i) {
            const ModelWalk::Opened open =
                i < now.opened.size() ? now.opened[i] : ModelWalk::Opened{};
            begin.opened[i] = {boxes.moved(begin.opened[i].box, open.box),
                               containers.moved(begin.opened[i].container, open.container)};
        }
    }
}

// The segments of the walk take the place of the old ones.
ModelBuilder::Spliced ModelBuilder::spliceTrail() {
    Trail& made = walk_->trail();
    const auto from = trail_.begin() + static_cast<std::ptrdiff_t>(resumed_);
    const auto to = trail_.begin() + static_cast<std::ptrdiff_t>(ahead_);
    const bool renamed = namesIn(from, to) != namesIn(made.begin(), made.end());
    const std::size_t count = made.size();
    trail_.insert(trail_.erase(from, to), std::make_move_iterator(made.begin()),
                  std::make_move_iterator(made.end()));
    if (!renamed)
        return {count, false};
    References now(trail_);
    const bool differ = now.differFrom(references_);
    references_ = std::move(now);
    return {count, differ};
}

// Gives references their text: in the segments of the walk and, where a name has changed, in all.
// True: a block elsewhere became another one.
bool ModelBuilder::resolve(Model& model, const Spliced& spliced) {
    const std::size_t first = resumed_, end = resumed_ + spliced.segments;
    std::size_t elsewhere = 0;
    for (std::size_t s = spliced.renamed ? 0 : first; s < (spliced.renamed ? trail_.size() : end);
         ++s)
        for (const std::size_t i : trail_[s].referring) {
            std::shared_ptr<const Block>& block = model.blocks[trail_[s].begin.blocksBefore + i];
            std::shared_ptr<const Block> now = references_.resolved(block);
            elsewhere += now != block && (s < first || s >= end) ? 1 : 0;
            block = std::move(now);
        }
    for (std::size_t s = first; s < end; ++s)
        for (const std::size_t i : trail_[s].valued) {
            std::shared_ptr<const Block>& block = model.blocks[trail_[s].begin.blocksBefore + i];
            block = withValues(block, values_);
        }
    work_.blocks += elsewhere;
    return elsewhere > 0;
}

// --- values ---------------------------------------------------------------------------------

bool ModelBuilder::followValues() {
    if (!model_ || region_)
        return false; // step() takes them as they are then
    std::shared_ptr<Model> now;
    bool isListed = false, hasNotes = false;
    for (const ModelWalk::Segment& segment : trail_)
        for (const std::size_t i : segment.valued) {
            const std::size_t place = segment.begin.blocksBefore + i;
            std::shared_ptr<const Block> block = withValues(model_->blocks[place], values_);
            if (block == model_->blocks[place])
                continue;
            if (!now)
                now = std::make_shared<Model>(*model_);
            isListed = isListed || std::ranges::any_of(block->anchors, isGeneratedAnchor);
            hasNotes = hasNotes || !block->rows.empty() ||
                       std::ranges::any_of(block->runs,
                                           [](const Run& run) { return run.footnote != nullptr; });
            now->blocks[place] = std::move(block);
            ++work_.blocks;
        }
    if (!now)
        return false;
    if (isListed)
        work_.blocks += fillContents(*now, model_->blocks);
    if (hasNotes) {
        now->footnotes.clear();
        for (const std::shared_ptr<const Block>& block : now->blocks)
            addFootnotesOf(*block, now->footnotes);
    }
    model_ = std::move(now);
    return true;
}

Model buildModel(const document::Document& document, const schemas::Presentation& presentation,
                 const schemas::Schemas& schemas, const ValueSource* values) {
    ModelBuilder builder(document, presentation, schemas);
    builder.setValues(values);
    while (builder.step(1000))
        continue;
    return builder.take();
}

} // namespace model

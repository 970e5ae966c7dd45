#include "reading/reading_tree.h"

#include "excerpts/equal_ends.h"

#include <map>

namespace reading {

using model::Run, model::RunKind, model::BlockKind, model::Container, model::Cell, model::Row,
    model::Ends, model::equalEnds, model::gridOf;

using schemas::ContainerRole;
using sgml::NodeId, sgml::noNode;
using Kind = Part::Kind;

ReadingTree::ReadingTree(const document::Document& document) : document_(document) {}

std::size_t ReadingTree::indexOf(const Part& part) const {
    const Parts& all = part.parent->parts;
    const auto at = std::ranges::find(all, &part, &std::unique_ptr<Part>::get);
    return static_cast<std::size_t>(at - all.begin());
}

// --- making parts ------------------------------------------------------------------------------

std::unique_ptr<Part> ReadingTree::made(Kind kind, Part& parent, NodeId element) {
    ++work_;
    auto part = std::make_unique<Part>();
    part->kind = kind;
    part->parent = &parent;
    part->element = element;
    return part;
}

const ReadingTree::Parts& ReadingTree::partsOf(Part& part) {
    if (part.isOpen || !model_) // or nothing is shown yet
        return part.parts;
    part.isOpen = true;
    switch (part.kind) {
    case Kind::container: {
        // Its place among the blocks of the flow that it is in.
        std::size_t first = 0;
        const Part* at = &part;
        for (; !at->flow.blocks; at = at->parent)
            for (const auto& beside : at->parent->parts) {
                if (beside.get() == at)
                    break;
                first += beside->size;
            }
        part.parts = partsIn(part, at->flow, first, first + part.size);
        break;
    }
    case Kind::document:
    case Kind::cell:
    case Kind::note:
    case Kind::contents:
        if (part.flow.blocks)
            part.parts = partsIn(part, part.flow, 0, part.flow.blocks->size());
        if (part.kind == Kind::document)
            std::ranges::move(notesOf(part), std::back_inserter(part.parts));
        break;
    case Kind::table:
        part.parts = cellsOf(part);
        break;
    case Kind::text:
        part.parts = lineOf(part);
        break;
    default:
        break;
    }
    return part.parts;
}

namespace {

bool isOneText(const Container& container, const Block& first) {
    const bool mayBe =
        container.role == ContainerRole::caption || container.role == ContainerRole::item;
    return mayBe && container.first == container.last && first.kind == BlockKind::text;
}

Kind kindOf(const Block& block) {
    switch (block.kind) {
    case BlockKind::subdocument:
    case BlockKind::image:
    case BlockKind::chart:
        return Kind::figure;
    case BlockKind::table:
        return Kind::table;
    case BlockKind::rule:
    case BlockKind::pageBreak:
        return Kind::separator;
    case BlockKind::formula:
        return Kind::formula;
    case BlockKind::contents:
        return block.entries.empty() ? Kind::text : Kind::contents;
    default:
        return Kind::text;
    }
}

const Containers noContainers;

} // namespace

std::unique_ptr<Part> ReadingTree::partOf(Part& parent, const std::shared_ptr<const Block>& block) {
    std::unique_ptr<Part> part = made(kindOf(*block), parent, block->element);
    part->block = block;
    part->size = 1;
    part->level = block->headingLevel;
    if (part->kind == Kind::contents)
        part->flow = {&block->entries, &noContainers};
    return part;
}

// Of the containers that begin where `parent` does, those around it and itself come first.
ReadingTree::Parts ReadingTree::partsIn(Part& parent, const Flow& flow, std::size_t from,
                                        std::size_t to) {
    const Containers& all = *flow.containers;
    auto at = std::ranges::lower_bound(all, from, {}, &Container::first);
    if (parent.kind == Kind::container) {
        const auto own = std::find_if(at, all.end(), [&](const Container& container) {
            return container.first != from ||
                   (container.element == parent.element && container.role == parent.role);
        });
        if (own != all.end() && own->first == from)
            at = own + 1;
    }
    Parts parts;
    for (std::size_t i = from; i < to;) {
        while (at != all.end() && at->first < i)
            ++at;
        const std::shared_ptr<const Block>& block = (*flow.blocks)[i];
        if (at == all.end() || at->first > i || at->last >= to) {
            parts.push_back(partOf(parent, block));
            ++i;
            continue;
        }
        const bool isText = isOneText(*at, *block);
        std::unique_ptr<Part> part =
            isText ? partOf(parent, block) : made(Kind::container, parent, at->element);
        part->element = at->element;
        part->role = at->role;
        part->level = at->level;
        part->size = at->last - at->first + 1;
        i = at->last + 1;
        parts.push_back(std::move(part));
    }
    return parts;
}

// Runs beside each other that lead to the same place are one link.
ReadingTree::Parts ReadingTree::lineOf(Part& text) {
    Parts parts;
    const std::vector<Run>& runs = text.block->runs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Run& run = runs[i];
        const bool isFigure = run.kind == RunKind::subdocument || run.kind == RunKind::image;
        if (run.target.empty() && !isFigure && !run.formula)
            continue;
        const Kind kind = run.formula ? Kind::formula : isFigure ? Kind::figure : Kind::link;
        if (kind == Kind::link && !parts.empty() && parts.back()->kind == Kind::link &&
            parts.back()->run + parts.back()->runs == i && runs[i - 1].target == run.target) {
            ++parts.back()->runs;
            continue;
        }
        std::unique_ptr<Part> part = made(kind, text, run.element);
        part->block = text.block;
        part->run = i;
        part->runs = 1;
        parts.push_back(std::move(part));
    }
    return parts;
}

ReadingTree::Parts ReadingTree::cellsOf(Part& table) {
    Parts parts;
    const document::TableGrid grid = gridOf(*table.block);
    for (std::size_t row = 0; row < grid.rows(); ++row)
        for (const document::GridCell& place : grid.row(row)) {
            const Cell& cell = table.block->rows[place.row][place.number];
            std::unique_ptr<Part> part = made(Kind::cell, table, cell.element);
            part->place = place;
            part->flow = {&cell.blocks, &cell.containers};
            part->block = table.block;
            parts.push_back(std::move(part));
        }
    return parts;
}

ReadingTree::Parts ReadingTree::notesOf(Part& parent) {
    Parts parts;
    for (const std::shared_ptr<const Footnote>& note : model_->footnotes) {
        std::unique_ptr<Part> part = made(Kind::note, parent, note->element);
        part->note = note;
        part->flow = {&note->blocks, &note->containers};
        parts.push_back(std::move(part));
    }
    return parts;
}

// --- following a model -------------------------------------------------------------------------

// A container that has changed has changed as a whole.
ReadingTree::Window ReadingTree::changed(const Flow& old, const Flow& now) {
    const std::size_t oldSize = old.blocks->size(), newSize = now.blocks->size();
    const Ends same = equalEnds(*old.blocks, *now.blocks,
                                [](const auto& a, const auto& b, bool) { return a == b; });
    Window window{same.front, oldSize - same.back, newSize - same.back};
    const bool isMoved = oldSize != newSize;
    const Ends alike = equalEnds(
        *old.containers, *now.containers, [&](Container a, const Container& b, bool back) {
            if (isMoved && (back ? a.first < oldSize - same.back : a.last >= same.front))
                return false;
            if (back) {
                a.first += newSize - oldSize; // may wrap, as the sum does
                a.last += newSize - oldSize;
            }
            return a == b;
        });
    const auto widen = [&](const Containers& all, std::size_t size, std::size_t Window::*end) {
        for (std::size_t i = alike.front; i + alike.back < all.size(); ++i) {
            window.from = std::min(window.from, all[i].first);
            const std::size_t behind = std::min(size - window.*end, size - (all[i].last + 1));
            window.oldEnd = oldSize - behind;
            window.newEnd = newSize - behind;
        }
    };
    widen(*old.containers, oldSize, &Window::oldEnd);
    widen(*now.containers, newSize, &Window::newEnd);
    return window;
}

void ReadingTree::follow(const std::shared_ptr<const Model>& model, const Listener& listener) {
    if (!model || model == model_)
        return;
    const std::shared_ptr<const Model> old = std::exchange(model_, model);
    const Flow now{&model->blocks, &model->containers};
    if (!root_.isOpen) {
        root_.flow = now;
        return;
    }
    const auto notes =
        std::ranges::find(root_.parts, Kind::note, [](const auto& part) { return part->kind; });
    const auto count = static_cast<std::size_t>(root_.parts.end() - notes);
    refill(root_, now, listener);
    if (old && old->footnotes == model->footnotes)
        return;
    const std::size_t end = root_.parts.size();
    exchange(
        {root_, end - count, end, notesOf(root_)},
        [&](Part& kept, const Part& fresh, std::size_t, std::size_t) {
            update(kept, fresh, listener);
        },
        listener);
}

void ReadingTree::refill(Part& owner, const Flow& now, const Listener& listener) {
    const Flow old = std::exchange(owner.flow, now);
    if (!owner.isOpen || !old.blocks)
        return;
    const Window window = changed(old, now);
    refillIn(owner, 0, 0, now.blocks->size(), now, window, listener);
}

void ReadingTree::refillIn(Part& part, std::size_t oldStart, std::size_t newStart,
                           std::size_t newSize, const Flow& now, const Window& window,
                           const Listener& listener) {
    std::size_t count = 0, oldEnd = oldStart;
    for (; count < part.parts.size() && part.parts[count]->size > 0; ++count)
        oldEnd += part.parts[count]->size;
    std::size_t first = 0, from = oldStart;
    while (first < count && from + part.parts[first]->size <= window.from)
        from += part.parts[first++]->size;
    std::size_t end = count, to = oldEnd;
    while (end > first && to - part.parts[end - 1]->size >= window.oldEnd)
        to -= part.parts[--end]->size;
    const std::size_t newFrom = newStart + (from - oldStart);
    const std::size_t newTo = newStart + newSize - (oldEnd - to);
    const Keep keep = [&](Part& kept, const Part& fresh, std::size_t oldAt, std::size_t newAt) {
        if (kept.kind == Kind::container && kept.isOpen)
            refillIn(kept, oldAt, newAt, fresh.size, now, window, listener);
        update(kept, fresh, listener);
    };
    exchange({part, first, end, partsIn(part, now, newFrom, newTo), from, newFrom}, keep, listener);
}

// A part stays where one of its element is of the same kind as before.
void ReadingTree::exchange(Exchange what, const Keep& keep, const Listener& listener) {
    Parts& all = what.parent.parts;
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(what.first);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(what.end);
    Parts old(std::make_move_iterator(first), std::make_move_iterator(end));
    all.erase(first, end);
    std::multimap<NodeId, std::size_t> byElement;
    std::vector<std::size_t> starts;
    for (std::size_t at = what.oldStart; const std::unique_ptr<Part>& part : old) {
        byElement.emplace(part->element, starts.size());
        starts.push_back(at);
        at += part->size;
    }
    std::vector<Part*> came;
    for (std::size_t at = what.newStart; std::unique_ptr<Part> & part : what.fresh) {
        const std::size_t size = part->size;
        const auto [from, to] = byElement.equal_range(part->element);
        const auto same = std::find_if(from, to, [&](const auto& one) {
            const Part& before = *old[one.second];
            return before.kind == part->kind && before.role == part->role;
        });
        if (same == to) {
            came.push_back(part.get());
        } else {
            std::unique_ptr<Part> kept = std::move(old[same->second]);
            keep(*kept, *part, starts[same->second], at);
            byElement.erase(same);
            part = std::move(kept);
        }
        at += size;
    }
    for (const std::unique_ptr<Part>& part : old)
        if (part)
            listener.leaves(*part);
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(what.first),
               std::make_move_iterator(what.fresh.begin()),
               std::make_move_iterator(what.fresh.end()));
    for (Part* part : came)
        listener.came(*part);
}

void ReadingTree::exchangeAll(Part& part, Parts fresh, const Listener& listener) {
    exchange(
        {part, 0, part.parts.size(), std::move(fresh)},
        [&](Part& kept, const Part& now, std::size_t, std::size_t) { update(kept, now, listener); },
        listener);
}

void ReadingTree::update(Part& kept, const Part& fresh, const Listener& listener) {
    kept.size = fresh.size;
    kept.level = fresh.level;
    kept.run = fresh.run;
    kept.runs = fresh.runs;
    kept.place = fresh.place;
    // Both live on while the flows in them are compared.
    const std::shared_ptr<const Footnote> note = std::exchange(kept.note, fresh.note);
    const std::shared_ptr<const Block> before = std::exchange(kept.block, fresh.block);
    if (fresh.flow.blocks)
        refill(kept, fresh.flow, listener);
    if (before == kept.block)
        return;
    if (kept.kind == Kind::table && kept.isOpen)
        exchangeAll(kept, cellsOf(kept), listener);
    if (kept.kind == Kind::text && kept.isOpen)
        exchangeAll(kept, lineOf(kept), listener);
    listener.changed(kept, before);
}

// --- finding parts -----------------------------------------------------------------------------

bool ReadingTree::holds(NodeId element, std::size_t place) const {
    const sgml::Tree& tree = document_.tree();
    if (element == noNode || !tree.holds(element))
        return false;
    const text::Range range = tree.node(element).range;
    return range.from <= place && place <= range.to;
}

// The place at which its text begins.
std::size_t ReadingTree::startOf(const Block& block) const {
    const sgml::Tree& tree = document_.tree();
    const auto startOf = [&](NodeId node) { return tree.node(node).range.from; };
    for (const Run& run : block.runs)
        if (run.content != noNode && tree.holds(run.content))
            return startOf(run.content);
    for (const Row& row : block.rows)
        for (const Cell& cell : row)
            if (cell.element != noNode && tree.holds(cell.element))
                return startOf(cell.element);
    return block.element != noNode && tree.holds(block.element) ? startOf(block.element) : 0;
}

// Blocks come in the order of their text.
std::size_t ReadingTree::blockAt(const Blocks& blocks, std::size_t place) const {
    const auto behind = std::ranges::upper_bound(
        blocks, place, {}, [this](const auto& block) { return startOf(*block); });
    const auto guess = static_cast<std::size_t>(behind - blocks.begin());
    return guess == 0 ? 0 : guess - 1;
}

Part* ReadingTree::blockPart(Part& owner, std::size_t index) {
    Part* at = &owner;
    for (std::size_t start = 0; at && (at == &owner || at->kind == Kind::container);) {
        Part* inside = nullptr;
        for (const std::unique_ptr<Part>& part : partsOf(*at)) {
            if (index < start + part->size) {
                inside = part.get();
                break;
            }
            start += part->size;
        }
        at = inside;
    }
    return at;
}

Part* ReadingTree::partIn(Part& owner, std::size_t place) {
    if (!owner.flow.blocks || owner.flow.blocks->empty())
        return nullptr;
    Part* part = blockPart(owner, blockAt(*owner.flow.blocks, place));
    if (!part || part->kind != Kind::table)
        return part;
    for (const std::unique_ptr<Part>& cell : partsOf(*part))
        if (holds(cell->element, place))
            return partIn(*cell, place);
    return nullptr;
}

Part* ReadingTree::partAt(std::size_t place) {
    Part* inside = &root_;
    const Parts& all = partsOf(root_);
    for (auto note = all.rbegin(); note != all.rend() && (*note)->kind == Kind::note; ++note)
        if (holds((*note)->element, place)) {
            inside = note->get();
            break; // the innermost one: a footnote's own come behind it
        }
    return partIn(*inside, place);
}

Part* ReadingTree::figureOf(document::SubdocumentId id) {
    const document::Subdocument* of = document_.subdocument(id);
    Part* part = of ? partAt(document_.tree().node(of->element).range.from) : nullptr;
    if (!part || part->kind == Kind::figure)
        return part;
    for (const std::unique_ptr<Part>& inside : partsOf(*part))
        if (inside->kind == Kind::figure && part->block->runs[inside->run].subdocument == id)
            return inside.get();
    return nullptr;
}

Part* ReadingTree::cellAt(Part& table, std::size_t row, std::size_t column) {
    for (const std::unique_ptr<Part>& cell : partsOf(table)) {
        const document::GridCell& at = cell->place;
        if (at.row <= row && row <= at.lastRow() && at.column <= column &&
            column <= at.lastColumn())
            return cell.get();
    }
    return nullptr;
}

} // namespace reading

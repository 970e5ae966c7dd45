#include "model/same_blocks.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace model {

// A structured binding names each member of a struct, so that one that is added must be added here.

namespace {

template <class T> bool areEqual(const std::vector<T>& a, const std::vector<T>& b);

bool isEqual(const std::shared_ptr<const Block>& a, const std::shared_ptr<const Block>& b) {
    return a == b || model::isEqual(*a, *b);
}

bool isEqual(const Cell& a, const Cell& b) {
    const auto& [element, style, blocks, containers, span] = a;
    return element == b.element && style == b.style && containers == b.containers &&
           span == b.span && areEqual(blocks, b.blocks);
}

bool isEqual(const Row& a, const Row& b) { return areEqual(a, b); }

bool isEqual(const std::shared_ptr<const Footnote>& a, const std::shared_ptr<const Footnote>& b) {
    if (a == b || !a || !b)
        return a == b;
    const auto& [number, element, blocks, containers] = *a;
    return number == b->number && element == b->element && containers == b->containers &&
           areEqual(blocks, b->blocks);
}

bool isEqual(const std::shared_ptr<const Formula>& a, const std::shared_ptr<const Formula>& b) {
    if (a == b || !a || !b)
        return a == b;
    // All else comes of these.
    return a->source == b->source && a->isAlone == b->isAlone && a->looks == b->looks &&
           a->values == b->values;
}

bool isEqual(const std::shared_ptr<const Picture>& a, const std::shared_ptr<const Picture>& b) {
    return a == b || (a && b && *a == *b);
}

bool isEqual(const std::shared_ptr<const Value>& a, const std::shared_ptr<const Value>& b) {
    return a == b || (a && b && *a == *b);
}

bool isEqual(const Run& a, const Run& b) {
    const auto& [kind, text, style, element, content, offset, target, refers, byNumber, looks,
                 subdocument, footnote, formula, picture, value] = a;
    return std::tie(kind, style, element, content, offset, refers, byNumber, looks, subdocument,
                    text, target) == std::tie(b.kind, b.style, b.element, b.content, b.offset,
                                              b.refers, b.byNumber, b.looks, b.subdocument, b.text,
                                              b.target) &&
           isEqual(footnote, b.footnote) && isEqual(formula, b.formula) &&
           isEqual(picture, b.picture) && isEqual(value, b.value);
}

template <class T> bool areEqual(const std::vector<T>& a, const std::vector<T>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const T& one, const T& other) { return isEqual(one, other); });
}

} // namespace

bool isEqual(const Block& a, const Block& b) {
    const auto& [kind, element, style, marker, markerStyle, runs, textStyle, headingLevel, anchors,
                 subdocument, picture, rows, headerRows, columnWidths, lists, entries] = a;
    return std::tie(kind, element, style, marker, markerStyle, textStyle, headingLevel, anchors,
                    subdocument, picture, lists) ==
               std::tie(b.kind, b.element, b.style, b.marker, b.markerStyle, b.textStyle,
                        b.headingLevel, b.anchors, b.subdocument, b.picture, b.lists) &&
           headerRows == b.headerRows && columnWidths == b.columnWidths && areEqual(runs, b.runs) &&
           areEqual(rows, b.rows) && areEqual(entries, b.entries);
}

namespace {

void keepInside(const Blocks& old, Blocks& now) {
    (void)keepOld(
        {.old = old, .from = 0, .to = old.size(), .now = now, .first = 0, .end = now.size()});
}

// Cells and footnotes that did not change, of a block that did.
void keepParts(const Block& old, std::shared_ptr<const Block>& now) {
    std::unordered_map<sgml::NodeId, const Cell*> cells;
    std::unordered_map<sgml::NodeId, std::shared_ptr<const Footnote>> footnotes;
    for (const Row& row : old.rows)
        for (const Cell& cell : row)
            cells.emplace(cell.element, &cell);
    for (const Run& run : old.runs)
        if (run.footnote)
            footnotes.emplace(run.footnote->element, run.footnote);
    if (cells.empty() && footnotes.empty())
        return;
    auto made = std::make_shared<Block>(*now);
    for (Row& row : made->rows)
        for (Cell& cell : row)
            if (const auto known = cells.find(cell.element); known != cells.end())
                keepInside(known->second->blocks, cell.blocks);
    for (Run& run : made->runs) {
        const auto known = run.footnote ? footnotes.find(run.footnote->element) : footnotes.end();
        if (known == footnotes.end())
            continue;
        if (isEqual(known->second, run.footnote)) {
            run.footnote = known->second;
            continue;
        }
        auto note = std::make_shared<Footnote>(*run.footnote);
        keepInside(known->second->blocks, note->blocks);
        run.footnote = std::move(note);
    }
    now = std::move(made);
}

} // namespace

// Most edits leave what is before and behind one place; the rest is found by its elements.
std::size_t keepOld(const Replaced& in) {
    std::size_t from = in.from, to = in.to, first = in.first, end = in.end;
    const auto keeps = [&](std::size_t old, std::size_t now) {
        if (!isEqual(in.old[old], in.now[now]))
            return false;
        in.now[now] = in.old[old];
        return true;
    };
    while (from < to && first < end && keeps(from, first))
        ++from, ++first;
    while (from < to && first < end && keeps(to - 1, end - 1))
        --to, --end;
    std::unordered_multimap<sgml::NodeId, std::size_t> byElement;
    for (std::size_t old = from; old < to; ++old)
        byElement.emplace(in.old[old]->element, old);
    std::size_t made = 0;
    for (; first < end; ++first) {
        const auto [known, last] = byElement.equal_range(in.now[first]->element);
        if (std::any_of(known, last, [&](const auto& old) { return keeps(old.second, first); }))
            continue;
        ++made;
        if (known != last)
            keepParts(*in.old[known->second], in.now[first]);
    }
    return made;
}

} // namespace model

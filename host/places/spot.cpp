#include "places/spot.h"

#include <algorithm>

namespace places {

using layout::Page;
using layout::Pages;
using layout::Piece;
using layout::TextPiece;
using paragraphs::BlockPointer;
using paragraphs::Paragraph;

namespace {

// Calls `look` for the pages from there on, the nearest first, until it gives a place.
template <class Look>
std::optional<PlaceOnPage> nearest(const Pages& pages, std::size_t from, Look look) {
    const std::size_t count = pages.pages.size();
    for (std::size_t i = 0; i < 2 * count + 1; ++i) {
        const std::size_t page = i % 2 == 0 ? from - i / 2 : from + (i + 1) / 2; // may wrap
        if (page >= count)
            continue;
        if (const std::optional<double> y = look(*pages.pages[page]))
            return PlaceOnPage{page, *y};
    }
    return std::nullopt;
}

} // namespace

std::optional<Spot> spotAt(const Pages& pages, PlaceOnPage place) {
    for (std::size_t i = place.page; i < pages.pages.size(); ++i, place.y = 0)
        for (const Piece& piece : pages.pages[i]->pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece); text && !text->isRepeated) {
                const Paragraph::Line& line = text->letters();
                if (text->at.y() + line.height > place.y && i == place.page)
                    return Spot{text->paragraph->block(), line.from, place.y - text->at.y()};
                if (i > place.page)
                    return Spot{text->paragraph->block(), line.from, 0};
            }
    return std::nullopt;
}

namespace {

bool sameWords(const model::Block& a, const model::Block& b) {
    const auto isSame = [](const model::Run& one, const model::Run& other) {
        return one.text == other.text && one.kind == other.kind;
    };
    return a.kind == b.kind && std::ranges::equal(a.runs, b.runs, isSame);
}

// The line that has the letter, in a block of which `is` says that it is that one.
template <class Is>
std::optional<PlaceOnPage> find(const Pages& pages, const Spot& spot, std::size_t from, Is is) {
    return nearest(pages, from, [&](const Page& page) -> std::optional<double> {
        for (const Piece& piece : page.pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece); text && !text->isRepeated) {
                const Paragraph::Line& line = text->letters();
                const bool isLast = text->paragraph->lines().back().to == line.to;
                if (line.from <= spot.letter && (line.to > spot.letter || isLast) &&
                    is(text->paragraph->block()))
                    return text->at.y() + spot.above;
            }
        return std::nullopt;
    });
}

} // namespace

std::optional<PlaceOnPage> placeOf(const Pages& pages, const Spot& spot, std::size_t from) {
    from = std::min(from, pages.pages.empty() ? 0 : pages.pages.size() - 1);
    auto place =
        find(pages, spot, from, [&](const BlockPointer& block) { return block == spot.block; });
    if (!place)
        place = find(pages, spot, from,
                     [&](const BlockPointer& block) { return sameWords(*block, *spot.block); });
    if (!place)
        place = find(pages, spot, from, [&](const BlockPointer& block) {
            return block->element == spot.block->element;
        });
    return place;
}

} // namespace places

// The elements that a change of a scene's text kept, added and removed (dissertation 4.2.2).
//
// A named element is the one of that name. One without a name (a force, a link, a constraint) is,
// of those that are left, the one that
//     1. says the same at the same place of the text, where places follow the edit,
//     2. says the same elsewhere: it was moved, or others before it came or went,
//     3. stands at the same place, on the same bodies: its values were changed,
//     4. is next in order on the same bodies: place and values were changed,
//     5. stands at the same place: its bodies were changed.
// So it keeps its identity through edits, moves and reordering.
//
// LIMIT: of several alike without a name that trade places with edited ones, which is which is a
// guess; nothing in the scene tells either.
#pragma once

#include "editing/value_edit.h"

namespace editing {

// A text and the scene that was read from it.
struct Reading {
    std::string_view text;
    const scene::Scene& scene;
};

struct Kept {
    Element before, after;
    bool modified = false; // another value, expression or colour; places do not count
    bool operator==(const Kept&) const = default;
};

struct Changes {
    std::vector<Kept> kept;
    std::vector<Element> added;   // of the scene after
    std::vector<Element> removed; // of the scene before

    // The element that this one of the scene before is now; nothing: removed.
    [[nodiscard]] std::optional<Element> now(const Element& before) const;
};

[[nodiscard]] Changes changesBetween(const Reading& before, const Reading& after);

struct Renamed {
    Element element; // of both scenes
    std::string before, now;
};
// Elements that stand at their place as before, under a name that is new; none where elements came
// or went.
[[nodiscard]] std::vector<Renamed> renamedBetween(const scene::Scene& before,
                                                  const scene::Scene& after);

// All elements of a scene, by kind and in order; the simulator only where the text has one.
[[nodiscard]] std::vector<Element> elementsOf(const scene::Scene& scene);

// Those whose commands hold that place: an element's own, or all that a loop's command made.
[[nodiscard]] std::vector<Element> elementsAt(const scene::Scene& scene, scene::Range range);

} // namespace editing

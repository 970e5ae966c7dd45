// How much text there is.
#pragma once

#include "model/model.h"

namespace reading {

using model::Model;

struct TextCount {
    std::size_t words = 0;      // as Unicode (annex 29) tells them apart
    std::size_t characters = 0; // with their accents, blanks included
    std::size_t notBlank = 0;   // of these, those that are no blanks
    bool operator==(const TextCount&) const = default;
};

// Of what the author wrote, in tables and footnotes, too. Numbers, references and marks that are
// generated do not count, nor do formulas and what is in figures.
[[nodiscard]] TextCount countText(const Model& model);

} // namespace reading

// Places of a document that wait for text: those whose presentation has a hint for them.
#pragma once

#include "model/model.h"

namespace model {

// A block of text without a letter.
[[nodiscard]] bool isWithoutText(const Block& block);
// A view in which one writes shows the hint there.
[[nodiscard]] bool isEmptyPlace(const Block& block);
// As paper shows it: without them, and without what has nothing but them and generated words. Null:
// there are none.
[[nodiscard]] std::shared_ptr<const Model> withoutEmptyPlaces(const Model& whole);

} // namespace model

// The meaning of a handle's place for the text: wishes that editing/ answers.
#pragma once

#include "editing/value_edit.h"
#include "handles/handles.h"

#include <string>

namespace gestures {

[[nodiscard]] editing::Element elementOf(const render::Handle& handle);

// The handle at that place of the world. `length` is the least that the gesture tells apart there,
// 0: exact. `quaternion`: the text gives the attitude by four numbers.
[[nodiscard]] std::vector<editing::Wish> wishesFor(const scene::Scene& scene,
                                                   const render::Handle& handle,
                                                   const geometry::Vector& place, double length,
                                                   bool quaternion);

// Of the attitude handle of a body: it is turned so from its attitude at the start.
[[nodiscard]] editing::Wish turnWish(const scene::Scene& scene, const render::Handle& handle,
                                     const geometry::Quaternion& turn, double resolution,
                                     bool quaternion);
// With other numbers for the same options, in their order.
[[nodiscard]] std::vector<editing::Wish> withValues(std::vector<editing::Wish> wishes,
                                                    const std::vector<double>& values);

// Numbers of its own place the body: another place moves nothing else, and can be written.
[[nodiscard]] bool isPlacedAlone(const editing::Mapper& mapper, std::size_t body);

// With the wishes that follow from them: the point of a joint moves on both of its bodies, so that
// they still meet there at the start.
[[nodiscard]] std::vector<editing::Wish> withFollowing(const scene::Scene& scene,
                                                       std::vector<editing::Wish> wishes);

// "b1", "force on b1".
[[nodiscard]] std::string subjectOf(const scene::Scene& scene, const render::Handle& handle);
// "velocity"
[[nodiscard]] std::string quantityOf(const scene::Scene& scene, const render::Handle& handle);
// "the velocity of b1", "the force on b1": for a sentence.
[[nodiscard]] std::string nameOf(const scene::Scene& scene, const render::Handle& handle);
// "Move b1", for undo.
[[nodiscard]] std::string labelOf(const scene::Scene& scene, const render::Handle& handle);
// "-4.37 0 2", in the digits that the wishes tell apart.
[[nodiscard]] std::string valuesOf(const std::vector<editing::Wish>& wishes);

} // namespace gestures

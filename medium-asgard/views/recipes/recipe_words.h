// How the Create commands write what was shown to them.
#pragma once

#include "recipes/recipe.h"

#include <string>
#include <vector>

namespace views {

// "{1 2 3}", in the digits that the resolution tells apart.
[[nodiscard]] std::string listed(const Vector& v, double resolution);
// What points along an axis of the world but for a hand's unsteadiness is meant to.
[[nodiscard]] Vector alongAxis(const Vector& v);

// Steps that ask for a body, a point, a body as a whole.
[[nodiscard]] Step showBody(const QString& prompt);
[[nodiscard]] Step showPlace(const QString& prompt, const QString& otherwise);
[[nodiscard]] Step showWholeBody(const QString& prompt);

// Options for the place and the attitude with which a new body begins.
[[nodiscard]] std::vector<std::string>
placeWords(const Vector& place, const geometry::Quaternion& attitude, double resolution);
// Things of a room, not the language's ideal ones: balls bounce, all else comes to rest where it
// falls, and wheels roll. Bodies that one makes one after another differ in colour.
void addRoomWords(editing::NewElement& body, const scene::Scene& scene, bool isBall,
                  bool isColored);

// Where on its body something acts; nothing at its centre of mass, which is what is meant then.
void addOffset(editing::NewElement& element, const char* option, const Indicated& shown);
[[nodiscard]] std::string bodyName(const scene::Scene& scene, const Indicated& shown);

// A trajectory that was shown, or a new one that begins at that place.
struct Path {
    std::string name;
    std::vector<editing::Element> behind;
    std::vector<editing::NewElement> made;
};
[[nodiscard]] Path pathFrom(const std::string& text, const scene::Scene& scene,
                            const Indicated& shown, const Vector& place, const Vector& way,
                            double resolution);

} // namespace views

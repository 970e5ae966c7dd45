// Which law holds where two bodies touch, and may they touch at all?
//
// By default it follows from both bodies: the geometric mean of their friction, the larger rolling
// friction, the smaller restitution. A contact of the pair overrides each of these (scene language,
// "Friction").
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace scene {

struct PairLaw {
    double sticking = 0, sliding = 0; // Coulomb's coefficients
    double rolling = 0;               // a length
    double restitution = 1;
};

class ContactPairs {
public:
    // Keeps the scene. Contacts of bodies that are not in it count for nothing.
    explicit ContactPairs(const Scene& scene);

    [[nodiscard]] PairLaw lawOf(std::size_t a, std::size_t b) const;
    [[nodiscard]] double restitutionOf(std::size_t a, std::size_t b) const;
    // As the pair's contact says; none: it says nothing.
    [[nodiscard]] std::optional<bool> collides(std::size_t a, std::size_t b) const;
    // There is one with a name, whose forces may be read.
    [[nodiscard]] bool isNamed(std::size_t a, std::size_t b) const {
        const Contact* own = find(a, b);
        return own && !own->name.empty();
    }
    // Contacts by their pairs, the lesser body first; indices into Scene::contacts.
    using Index = std::map<std::pair<std::size_t, std::size_t>, std::size_t>;
    [[nodiscard]] const Index& all() const { return contacts_; }
    [[nodiscard]] const Contact* find(std::size_t a, std::size_t b) const;

private:
    const Scene& scene_;
    Index contacts_;
};

} // namespace scene

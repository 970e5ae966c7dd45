// Does a body rest, slide or tip on what it touches, or is it free?
//
// The corners that touch without approaching are given the smallest forces that keep them from
// sinking in (physics::restingForces). Those that stay in touch under these forces bear: the body
// goes on with their gaps as constraints. The others open. The answer is looked at again along the
// motion; where another comes out, the constraints are wrong from there on.
//
// A contact along several axes bears only if these forces leave it approaching along each: the box
// below bears a box at the seam of two boxes in one plane, and no push along the plane presses it
// against the other one's edge.
#pragma once

#include "contacts/touching.h"
#include "surfaces/contact_resolution.h"

#include <string>
#include <vector>

namespace simulation {

struct Footing { // what bears of one pair of parts
    std::size_t support = 0, bodyPart = 0, supportPart = 0;
    bool isFlat = false;
    double size = 0;
    std::vector<physics::GapConstraint> constraints;
};

struct Rest {
    enum class State {
        free,        // nothing bears
        bearing,     // on `footings`
        approaching, // a corner sinks in: it is an impact
        drifted,     // bears, and its gap is no longer 0 to the tolerance: to be put back
        unmodelled   // `sentence` says why it cannot be followed
    };
    State state = State::free;
    std::vector<Footing> footings;
    std::size_t partner = 0; // approaching: whom
    std::string sentence;
    // Of the place and the attitude (a rotation vector): the least, in the sense of kinetic energy,
    // that makes the bearing gaps 0.
    Vector correction = Vector::Zero(), turn = Vector::Zero();

    // The same corners and edges bear. They may have moved along their features.
    [[nodiscard]] bool bearsLike(const Rest& other) const;
};

struct RestQuestion {
    Placed body;
    physics::ImpactBody mobility;
    Acceleration free; // without contacts, world axes
    std::vector<Placed> supports;
    std::vector<physics::ImpactBody> supportMobility; // by support: how it answers
    // On which it rests already. Only there an approach is told: the search for hits leaves these
    // out, and finds all others.
    std::vector<PartsInTouch> footings;
};

[[nodiscard]] Rest restOf(const RestQuestion& question, const ContactResolution& resolution,
                          const std::vector<std::string>& names);

} // namespace simulation

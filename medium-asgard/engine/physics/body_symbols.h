// One body as expressions see it: its state as symbols (or constants, if it is fixed), and what
// follows from them for its points.
#pragma once

#include "physics/mass.h"
#include "physics/node_vector.h"

#include <string>

namespace physics {

struct BodySymbols {
    NodeVector position; // of the centre of mass
    NodeVector velocity;
    NodeQuaternion attitude;       // body to world
    NodeVector spin;               // angular velocity, along the axes that the next line says
    bool isSpinInWorldAxes = true; // else along the body's
    NodeMatrix rotation;           // of the attitude

    [[nodiscard]] NodeVector toWorld(Graph& g, const NodeVector& v) const {
        return times(g, rotation, v);
    }
    [[nodiscard]] NodeVector toBody(Graph& g, const NodeVector& v) const {
        return transposedTimes(g, rotation, v);
    }
    // A vector of the world along the axes of the spin.
    [[nodiscard]] NodeVector toSpinAxes(Graph& g, const NodeVector& v) const {
        return isSpinInWorldAxes ? v : toBody(g, v);
    }
    [[nodiscard]] NodeVector worldSpin(Graph& g) const {
        return isSpinInWorldAxes ? spin : toWorld(g, spin);
    }
    // World velocity, relative to the centre of mass, of the point at `arm` from it (body frame).
    [[nodiscard]] NodeVector velocityOfArm(Graph& g, const NodeVector& arm) const {
        return isSpinInWorldAxes ? cross(g, spin, toWorld(g, arm))
                                 : toWorld(g, cross(g, spin, arm));
    }
    [[nodiscard]] NodeQuaternion attitudeRate(Graph& g) const {
        return physics::attitudeRate(g, attitude, spin, isSpinInWorldAxes);
    }
};

// Symbols named "B.x", ... An anisotropic body's spin is "B.w1 B.w2 B.w3", about its own axes.
[[nodiscard]] BodySymbols movingBody(Graph& g, const std::string& name, bool isSpinInWorldAxes);
[[nodiscard]] BodySymbols fixedBody(Graph& g, const geometry::Pose& centreOfMass);

} // namespace physics

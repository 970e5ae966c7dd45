// The bodies of a scene, as contacts, meetings and impacts see them.
#pragma once

#include "motion/body_motion.h"
#include "physics/contact_rows.h"
#include "physics/equations_of_motion.h"
#include "physics/joint_rows.h"
#include "scene/contact_pairs.h"
#include "scene/scene.h"
#include "surfaces/contact_resolution.h"

#include <utility>
#include <vector>

namespace simulation {

using Pair = std::pair<std::size_t, std::size_t>; // of bodies, as collision::Pair: the lesser first

struct Colliders {
    // The scene and the equations must outlive it; its shapes are valid.
    Colliders(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
              const std::vector<geometry::Shape>& shapes, double start,
              std::vector<ContactResolution> resolution);
    Colliders(const Colliders&) = delete;
    Colliders& operator=(const Colliders&) = delete;

    // The histories that the moving bodies are read from.
    void read(const solution::Histories& histories);

    [[nodiscard]] bool isFixed(std::size_t body) const { return records[body].isFixed; }
    [[nodiscard]] bool isBall(std::size_t body) const { return moving[body].isBall(); }
    // It has a hollow part.
    [[nodiscard]] bool isHollow(std::size_t body) const;
    [[nodiscard]] const std::string& name(std::size_t body) const {
        return scene.bodies[body].name;
    }
    [[nodiscard]] double restitutionOf(const Pair& pair) const {
        return pairs.restitutionOf(pair.first, pair.second);
    }

    // Of the smaller one's shape about its centre of mass. A half space is never that.
    [[nodiscard]] double smallerRadius(const Pair& pair) const;
    // Of two in a contact that lasts the rounder, then the smaller one is the body.
    [[nodiscard]] Pair bodyAndSupport(const Pair& pair) const;
    // Coulomb's law of the pair.
    [[nodiscard]] physics::ContactFriction frictionOf(std::size_t body, std::size_t support) const;

    const scene::Scene& scene;
    const physics::EquationsOfMotion& equations;
    scene::ContactPairs pairs;
    double start;
    std::vector<BodyRecord> records;
    std::vector<MovingBody> moving;
    std::vector<ContactResolution> resolution; // by body
    physics::JointRows joints;

private:
    const solution::Histories* read_ = nullptr;
};

} // namespace simulation

#include "scene/part_of.h"

#include <algorithm>

namespace scene {
namespace {

class Chosen {
public:
    void add(std::size_t index) { indices_.push_back(index); }
    void add(std::span<const std::size_t> indices) {
        indices_.insert(indices_.end(), indices.begin(), indices.end());
    }
    template <typename Element> std::vector<Element> of(const std::vector<Element>& all) {
        std::ranges::sort(indices_);
        indices_.erase(std::unique(indices_.begin(), indices_.end()), indices_.end());
        std::vector<Element> made;
        made.reserve(indices_.size());
        for (const std::size_t i : indices_)
            made.push_back(all[i]);
        return made;
    }

private:
    std::vector<std::size_t> indices_;
};

} // namespace

Scene partOf(const Version& version, const std::vector<std::size_t>& bodies) {
    const Scene& scene = *version.scene;
    const Connections& connections = version.connections;
    Chosen shapes, forces, links, joints, gears, ropes, contacts, constraints, trajectories,
        parameters;
    Scene part;
    part.simulator = scene.simulator;
    for (const std::size_t b : bodies) {
        part.bodies.push_back(scene.bodies[b]);
        shapes.add(connections.shapes[b]);
        if (scene.bodies[b].fixed)
            continue;
        forces.add(connections.forces.of(b));
        links.add(connections.firstEnds.of(b));
        links.add(connections.secondEnds.of(b));
        joints.add(connections.joints.of(b));
        gears.add(connections.gears.of(b));
        ropes.add(connections.ropes.of(b));
        contacts.add(connections.contacts.of(b));
        constraints.add(connections.constraints.of(b));
        for (const std::size_t m : connections.mentions.of(b))
            if (const Mention& mention = connections.mentionList[m];
                mention.kind == Mention::Kind::trajectory)
                trajectories.add(mention.index);
            else if (mention.kind == Mention::Kind::parameter)
                parameters.add(mention.index);
            else if (mention.kind == Mention::Kind::joint)
                joints.add(mention.index);
            else if (mention.kind == Mention::Kind::spring)
                links.add(mention.index);
            else if (mention.kind == Mention::Kind::rope)
                ropes.add(mention.index);
            else if (mention.kind == Mention::Kind::contact)
                contacts.add(mention.index);
    }
    part.shapeSets = shapes.of(scene.shapeSets);
    part.forces = forces.of(scene.forces);
    part.links = links.of(scene.links);
    part.joints = joints.of(scene.joints);
    part.gears = gears.of(scene.gears);
    part.ropes = ropes.of(scene.ropes);
    part.contacts = contacts.of(scene.contacts);
    part.constraints = constraints.of(scene.constraints);
    part.trajectories = trajectories.of(scene.trajectories);
    part.parameters = parameters.of(scene.parameters);
    return part;
}

} // namespace scene

#include "scenes.h"

#include "expression/tokens.h"
#include "script/reader.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace edits {
namespace {

namespace fs = std::filesystem;
using scene::Scene;

// Elements of another scene under names of their own, in expressions too.
class Renamed {
public:
    Renamed(Scene scene, const std::string& suffix) : scene_(std::move(scene)), suffix_(suffix) {
        for (const auto& set : scene_.shapeSets)
            names_.insert(set.name);
        for (const auto& body : scene_.bodies)
            names_.insert(body.name);
        for (const auto& trajectory : scene_.trajectories)
            names_.insert(trajectory.name);
        for (const auto& parameter : scene_.parameters)
            names_.insert(parameter.name);
        for (const auto& joint : scene_.joints)
            names_.insert(joint.name);
        for (const auto& gear : scene_.gears)
            names_.insert(gear.name);
        for (const auto& rope : scene_.ropes)
            names_.insert(rope.name);
        for (const auto& contact : scene_.contacts)
            names_.insert(contact.name);
        rename();
        renameConditions();
    }
    Scene take() { return std::move(scene_); }

private:
    void name(std::string& text) {
        if (names_.contains(text))
            text += suffix_;
    }
    void expression(std::string& text) {
        std::string made;
        std::size_t at = 0;
        for (expression::Tokens tokens(text); tokens.now().kind != expression::TokenKind::end;
             tokens.advance()) {
            if (tokens.now().kind != expression::TokenKind::name)
                continue;
            const std::size_t dot = tokens.now().text.rfind('.');
            const std::string owner(tokens.now().text.substr(0, dot));
            if (!names_.contains(owner))
                continue;
            const std::size_t end = tokens.now().from + owner.size();
            made += text.substr(at, end - at) + suffix_;
            at = end;
        }
        text = made + text.substr(at);
    }
    void rename() {
        for (auto& set : scene_.shapeSets)
            name(set.name);
        for (auto& body : scene_.bodies) {
            name(body.name);
            name(body.shape);
        }
        for (auto& trajectory : scene_.trajectories)
            name(trajectory.name);
        for (auto& parameter : scene_.parameters)
            name(parameter.name);
        for (auto& force : scene_.forces) {
            name(force.body);
            if (auto* kind = std::get_if<scene::ComponentForce>(&force.kind))
                for (auto& text : kind->components)
                    expression(text);
            if (auto* kind = std::get_if<scene::TrajectoryForce>(&force.kind))
                name(kind->trajectory);
            expression(force.release);
        }
        for (auto& link : scene_.links) {
            name(link.first.body);
            if (auto* end = std::get_if<scene::BodyEnd>(&link.second))
                name(end->body);
            else if (auto* driven = std::get_if<scene::TrajectoryEnd>(&link.second))
                name(driven->trajectory);
            else
                for (auto& text : std::get<scene::PointEnd>(link.second).coordinates)
                    expression(text);
            expression(link.release);
        }
        for (auto& constraint : scene_.constraints) {
            name(constraint.body);
            name(constraint.trajectory);
        }
    }

    void expression(std::optional<std::string>& text) {
        if (text)
            expression(*text);
    }
    void renameConditions() {
        for (auto& joint : scene_.joints) {
            name(joint.name);
            name(joint.body1);
            if (joint.body2)
                name(*joint.body2);
            for (auto& coordinate : joint.coordinates)
                for (auto* text : {&coordinate.motor, &coordinate.speed, &coordinate.position})
                    expression(*text);
            expression(joint.release);
        }
        for (auto& gear : scene_.gears) {
            name(gear.name);
            for (auto& term : gear.terms)
                name(term.joint);
            expression(gear.release);
        }
        for (auto& rope : scene_.ropes) {
            name(rope.name);
            for (auto& point : rope.points)
                if (point.body)
                    name(*point.body);
            expression(rope.release);
        }
        for (auto& contact : scene_.contacts)
            for (std::string* text : {&contact.name, &contact.body1, &contact.body2})
                name(*text);
    }

    Scene scene_;
    std::string suffix_;
    std::set<std::string> names_;
};

template <typename Element>
void append(std::vector<Element>& to, const std::vector<Element>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

// The finish comes nearer until a run is short work.
void shorten(Scene& scene) {
    scene.simulator.accuracy = std::max(scene.simulator.accuracy, 1e-4);
    for (int i = 0; i < 12; ++i) {
        scene::Scene trial = scene;
        const double span = scene.simulator.finish - scene.simulator.start;
        trial.simulator.finish = scene.simulator.start + std::min(span, std::max(span / 64, 0.05));
        std::size_t polls = 0;
        const auto work =
            simulation::simulate(trial, {},
                                 {.cancelled = [&] { return ++polls > 30'000; }, .progress = {}})
                .statistics;
        const auto cost = static_cast<double>(work.evaluations + 20 * work.pairTests);
        if (cost * span / (trial.simulator.finish - scene.simulator.start) < 8000)
            return;
        scene.simulator.finish = scene.simulator.start + span / 2;
    }
}

std::vector<fs::path> files() {
    std::vector<fs::path> found;
    for (const char* folder : {"/samples", "/tests/reference", "/tests/joints"})
        for (const auto& entry : fs::directory_iterator(std::string(SOURCE_DIR) + folder))
            if (entry.path().extension() == ".al")
                found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

// Thirty balls in five heaps that do not meet, above plates.
Scene heaps() {
    Scene scene;
    scene.simulator.finish = 1;
    scene::ShapeSet ball{"ball", {}, {}, {}}, plate{"plate", {}, {}, {}};
    ball.parts.resize(1);
    ball.parts[0].shape = scene::SphereShape{0.2};
    plate.parts.resize(1);
    plate.parts[0].shape = scene::BoxShape{{3, 0.2, 3}};
    scene.shapeSets = {ball, plate};
    for (int heap = 0; heap < 5; ++heap) {
        scene::Body& below = scene.bodies.emplace_back();
        below.name = "plate" + std::to_string(heap);
        below.shape = "plate";
        below.fixed = true;
        below.initialPosition = {10.0 * heap, -0.1, 0};
        scene::Parameter& pull = scene.parameters.emplace_back();
        pull.name = "pull" + std::to_string(heap);
        pull.value = 5 + heap;
        for (int i = 0; i < 6; ++i) {
            scene::Body& body = scene.bodies.emplace_back();
            body.name = "b" + std::to_string(heap) + "_" + std::to_string(i);
            body.shape = "ball";
            body.restitution = 0.9;
            body.initialPosition = {10.0 * heap + 0.5 * (i % 3), 0.6 + 0.5 * (i / 3.0), 0.13 * i};
            body.initialVelocity = {0.3 - 0.1 * i, 0, 0.2 * (i - heap)};
            scene::Force& weight = scene.forces.emplace_back();
            weight.body = body.name;
            weight.kind = scene::GravitationalForce{{0, -9.81, 0}};
            if (i == 5) // by one parameter for each heap
                weight.kind = scene::ComponentForce{
                    {"0", "-pull" + std::to_string(heap) + "*" + body.name + ".mass", "0"}};
        }
    }
    return scene;
}

// Ten round bodies that bounce between two half spaces.
Scene rounds() {
    Scene scene;
    scene.simulator.finish = 1;
    const scene::Part kinds[] = {
        {scene::PlaneShape{}, {0, 0, 0}, {0, 0, 0}, {}},
        {scene::CapsuleShape{0.2, 0.4}, {0, 0, 0}, {0, 0, 0}, {}},
        {scene::CylinderShape{0.3, 0.5}, {0, 0, 0}, {0, 0, 0}, {}},
        {scene::ConeShape{0.3, 0.6}, {0, 0, 0}, {0, 0, 0}, {}},
        {scene::EllipsoidShape{{0.2, 0.3, 0.4}}, {0, 0, 0}, {0, 0, 0}, {}}};
    for (std::size_t i = 0; i < 5; ++i)
        scene.shapeSets.push_back({"s" + std::to_string(i), {kinds[i]}, {}, {}});
    for (int i = 0; i < 12; ++i) {
        scene::Body& body = scene.bodies.emplace_back();
        body.name = "b" + std::to_string(i);
        body.fixed = i < 2;
        body.shape = body.fixed ? "s0" : "s" + std::to_string(1 + i % 4);
        body.initialPosition = {0.7 * (i % 4), 0.5 * (i / 4), 0.1 * i};
        body.initialVelocity = {0.5 - 0.1 * i, -1, 0.3 * (i % 3)};
        body.initialAngularVelocity = {0.3 * i, 1, -0.2 * i};
        if (body.fixed) {
            body.initialPosition = {0, i == 0 ? -0.6 : 2, 0};
            body.initialVelocity = body.initialAngularVelocity = {0, 0, 0};
            if (i == 1)
                body.initialAttitude = scene::Quaternion(0, 1, 0, 0);
        }
    }
    return scene;
}

} // namespace

Scene besides(const Scene& first, const Scene& second, const scene::Vector& shift) {
    Scene both = first;
    Scene other = Renamed(second, "_").take();
    for (scene::Body& body : other.bodies)
        body.initialPosition += shift;
    for (scene::Joint& joint : other.joints)
        if (!joint.body2 && joint.offset2)
            *joint.offset2 += shift;
    for (scene::Rope& rope : other.ropes)
        for (scene::Rope::Point& point : rope.points)
            if (!point.body && point.place)
                *point.place += shift;
    append(both.shapeSets, other.shapeSets);
    append(both.bodies, other.bodies);
    append(both.forces, other.forces);
    append(both.links, other.links);
    append(both.joints, other.joints);
    append(both.gears, other.gears);
    append(both.ropes, other.ropes);
    append(both.contacts, other.contacts);
    append(both.trajectories, other.trajectories);
    append(both.constraints, other.constraints);
    append(both.parameters, other.parameters);
    return both;
}

std::vector<NamedScene> scenes() {
    script::Reader reader;
    std::vector<NamedScene> all;
    for (const fs::path& file : files()) {
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        script::ReadResult read = reader.read(text.str());
        if (!read.usable || read.scene.bodies.size() > 60)
            continue;
        shorten(read.scene);
        all.push_back({file.stem().string(), std::move(read.scene)});
    }
    all.push_back({"heaps", heaps()});
    all.push_back({"rounds", rounds()});
    const std::size_t alone = all.size();
    for (std::size_t i = 0; i + 7 < alone; i += 3) { // far from each other, and in each other's way
        const scene::Vector shift =
            i % 2 == 0 ? scene::Vector(0, 0, 500) : scene::Vector(0.4, 0, 3);
        Scene both = besides(all[i].scene, all[i + 7].scene, shift);
        shorten(both);
        all.push_back({all[i].name + " beside " + all[i + 7].name, std::move(both)});
    }
    return all;
}

} // namespace edits

#include "gestures/present.h"

#include "editing/creation.h"
#include "editing/number_text.h"
#include "geometry/pose.h"
#include "render/handles.h"

#include <algorithm>
#include <set>
#include <utility>

namespace gestures {

using editing::Kind;
using editing::Wish;
using geometry::Vector;

namespace {

std::vector<double> numbersOf(const Vector& v) { return {v.x(), v.y(), v.z()}; }

// What would count from another start then: "" nothing.
std::string countsFromStart(const scene::Scene& scene) {
    const auto says = [&](const editing::Element& element, const std::string& what) {
        return editing::describe(scene, element) + " takes " + what +
               " from the start of the motion: write it first.";
    };
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        for (const scene::JointCoordinate& q : scene.joints[i].coordinates)
            if (q.lower || q.upper || q.position || q.stiffness != 0)
                return editing::describe(scene, {Kind::joint, i}) +
                       " has limits, a position or a spring that count from the start of the "
                       "motion: it cannot begin elsewhere.";
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        if (scene.links[i].spring && !scene.links[i].spring->rest)
            return says({Kind::link, i}, "its length -rest");
    for (std::size_t i = 0; i < scene.ropes.size(); ++i)
        if (!scene.ropes[i].length)
            return says({Kind::rope, i}, "its -length");
    return {};
}

class Moment {
public:
    Moment(const Ground& ground, double time)
        : ground_(ground),
          mapper_(ground.text, ground.scene,
                  [&ground](const std::string& name) {
                      return render::constantValue(*ground.scene, ground.motion.get(), name);
                  }),
          time_(time) {
        for (const scene::Constraint& held : ground.scene->constraints)
            led_.insert(held.body);
        for (std::size_t i = 0; i < ground.scene->bodies.size(); ++i)
            size_ = std::max(size_, ground.motion->at(i, time).position.norm());
    }

    [[nodiscard]] editing::Answer answer() const {
        std::vector<Wish> wishes;
        const auto& bodies = ground_.scene->bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (!bodies[i].fixed && !led_.contains(bodies[i].name))
                add(wishes, i);
        if (ground_.scene->simulator.source)
            wishes.push_back({{Kind::simulator, 0},
                              "-start",
                              {},
                              {time_},
                              1e-6,
                              {0},
                              {ground_.scene->simulator.start}});
        editing::Answer all = mapper_.answer(wishes);
        if (all.possible() && !ground_.scene->simulator.source)
            addSimulator(all.edits);
        return all;
    }

private:
    void add(std::vector<Wish>& wishes, std::size_t index) const {
        const scene::Body& body = ground_.scene->bodies[index];
        const simulation::BodyState state = ground_.motion->at(index, time_);
        const auto wish = [&](const char* option, const Vector& value, const Vector& now,
                              double resolution) {
            wishes.push_back({{Kind::body, index},
                              option,
                              {},
                              numbersOf(value),
                              resolution,
                              numbersOf(Vector::Zero()),
                              numbersOf(now)});
        };
        wish("-init_pos", ground_.motion->shapePose(index, time_).position, body.initialPosition,
             1e-9 * size_);
        wish("-init_dpos", state.velocity, body.initialVelocity, 1e-9 * size_);
        wish("-init_drot", state.angularVelocity, body.initialAngularVelocity, 1e-9);
        if (state.attitude.angularDistance(body.initialAttitude) <= 1e-9)
            return;
        wish("-init_rot", geometry::toRotationVector(state.attitude), Vector::Zero(), 1e-9);
        wishes.back().now.clear(); // one attitude has many rotation vectors
        const auto& q = state.attitude;
        if (mapper_.count(wishes.back()) == 4)
            wishes.back().values = {q.w(), q.x(), q.y(), q.z()};
    }

    void addSimulator(text::Edits& edits) const {
        const auto made = editing::created(
            ground_.text, *ground_.scene,
            {{Kind::simulator, "", {"-start", editing::numberText(time_, 1e-6)}, {}}});
        edits.insert(edits.end(), made.begin(), made.end());
        text::putInOrder(edits);
    }

    const Ground& ground_;
    editing::Mapper mapper_;
    double time_;
    double size_ = 1e-3;
    std::set<std::string> led_; // by a trajectory: that says where they are
};

} // namespace

editing::Answer startingAt(const Ground& ground, double time) {
    editing::Answer no;
    if (!ground.motion || time > ground.motion->computed() || ground.motion->draft())
        no.reason = "The motion is not computed up to this time yet.";
    else
        no.reason = countsFromStart(*ground.scene);
    return no.possible() ? Moment(ground, time).answer() : no;
}

} // namespace gestures

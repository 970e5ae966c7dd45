#include "gestures/present.h"

#include "editing/number_text.h"
#include "editing/variable_uses.h"
#include "element_edits/creation.h"
#include "element_edits/options.h"
#include "element_edits/property_edit.h"
#include "geometry/pose.h"
#include "handles/handles.h"
#include "reports/instants.h"
#include "scene/joint_types.h"
#include "script/structure.h"

#include <algorithm>
#include <utility>

namespace gestures {

using editing::Kind;
using editing::Wish;
using geometry::Vector;

namespace {

std::vector<double> numbersOf(const Vector& v) { return {v.x(), v.y(), v.z()}; }

// The values that would count from another start then: "" none.
std::string countsFromStart(const scene::Scene& scene, const scene::Released& released) {
    const auto says = [&](const editing::Element& element, const std::string& what) {
        return editing::describe(scene, element) + " takes " + what +
               " from the start of the motion: write it first.";
    };
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        for (const scene::JointCoordinate& q : scene.joints[i].coordinates)
            if (!released.joints.contains(i) &&
                (q.lower || q.upper || q.position || q.stiffness != 0))
                return editing::describe(scene, {Kind::joint, i}) +
                       " has limits, a position or a spring that count from the start of the "
                       "motion: it cannot begin elsewhere.";
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        if (!released.links.contains(i) && scene.links[i].spring && !scene.links[i].spring->rest)
            return says({Kind::link, i}, "its length -rest");
    for (std::size_t i = 0; i < scene.ropes.size(); ++i)
        if (!released.ropes.contains(i) && !scene.ropes[i].length)
            return says({Kind::rope, i}, "its -length");
    return {};
}

std::vector<editing::Element> elementsOf(const scene::Released& released) {
    std::vector<editing::Element> elements;
    for (const auto& [kind, indices] :
         {std::pair(Kind::joint, &released.joints), std::pair(Kind::gear, &released.gears),
          std::pair(Kind::rope, &released.ropes), std::pair(Kind::link, &released.links),
          std::pair(Kind::force, &released.forces)})
        for (const std::size_t index : *indices)
            elements.push_back({kind, index});
    return elements;
}

class Moment {
public:
    Moment(const Ground& ground, double time, const std::vector<Put>& puts)
        : ground_(ground), puts_(puts),
          mapper_(ground.text, ground.scene,
                  [&ground](const std::string& name) {
                      return render::constantValue(*ground.scene, ground.motion.get(), name);
                  }),
          time_(time) {
        for (std::size_t i = 0; i < ground.scene->bodies.size(); ++i)
            size_ = std::max(size_, ground.motion->at(i, time).position.norm());
    }

    [[nodiscard]] editing::Answer answer() const {
        std::vector<Wish> wishes;
        const auto& bodies = ground_.scene->bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (!bodies[i].fixed)
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
    // Of what is gone by then: it is from the start on.
    void release(editing::Answer& all, const scene::Released& released) const {
        const editing::Properties properties(ground_.text, ground_.scene);
        for (const editing::Element& element : elementsOf(released)) {
            const auto& command = editing::hintOf(*ground_.scene, element);
            const editing::Answer answer =
                properties.set({element}, *editing::hintOf(command, "-release"), {"1"});
            if (!answer.possible())
                all = answer;
            if (!all.possible())
                return;
            all.edits.insert(all.edits.end(), answer.edits.begin(), answer.edits.end());
        }
        text::putInOrder(all.edits);
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
        const auto put = std::ranges::find(puts_, index, &Put::body);
        const Put* const hand = put == puts_.end() ? nullptr : &*put;
        const double fine = 1e-9 * size_;
        wish("-init_pos", hand ? hand->place : ground_.motion->shapePose(index, time_).position,
             body.initialPosition, hand ? hand->resolution : fine);
        const bool isThrown = hand && hand->velocity;
        wish("-init_dpos", isThrown ? *hand->velocity : state.velocity, body.initialVelocity,
             isThrown ? hand->resolution : fine);
        wish("-init_drot", hand && hand->spin ? *hand->spin : state.angularVelocity,
             body.initialAngularVelocity, 1e-9);
        const geometry::Quaternion q = hand && hand->attitude ? *hand->attitude : state.attitude;
        if (q.angularDistance(body.initialAttitude) <= 1e-9)
            return;
        wish("-init_rot", geometry::toRotationVector(q), Vector::Zero(), 1e-9);
        wishes.back().now.clear(); // one attitude has many rotation vectors
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
    const std::vector<Put>& puts_;
    editing::Mapper mapper_;
    double time_;
    double size_ = 1e-3;
};

} // namespace

double roundMoment(const simulation::Motion& motion, double time) {
    const double step = editing::decimalStep((motion.finish() - motion.start()) / 2000);
    return std::clamp(editing::roundedTo(time, step), motion.start(), motion.computed());
}

std::string countsAnew(const Ground& ground, double time) {
    std::string names;
    std::size_t count = 0;
    const scene::Scene& scene = *ground.scene;
    const script::Structure structure = script::structureOf(ground.text);
    const auto isRead = [&](const std::string& name) {
        const auto reads = [&](std::string_view text, const script::Structure& of) {
            return editing::isUsedIn(name, {0, text.size()}, {}, editing::Origins(text, of, scene));
        };
        // A loop puts names of plots together, which its text does not show.
        return reads(ground.text, structure) ||
               std::ranges::any_of(scene.plots, [&](const auto& plot) {
                   return std::ranges::any_of(
                       plot.values, [&](const std::string& value) { return reads(value, {}); });
               });
    };
    for (const scene::Joint& joint : ground.scene->joints) {
        const scene::JointTraits& traits = scene::traitsOf(joint.type);
        for (std::size_t i = 0; traits.startsAtZero && i < traits.coordinates.size(); ++i) {
            const std::string name = joint.name + ".q" + scene::coordinateSuffix(joint.type, i);
            if (isRead(name)) {
                names += (count == 0 ? "" : ", ") + name;
                ++count;
            }
        }
    }
    if (count == 0)
        return {};
    return names + (count == 1 ? " counts" : " count") +
           " from this moment on: " + (count == 1 ? "it is" : "they are") + " 0 at " +
           editing::numberText(time, 1e-6) + " s.";
}

std::string whyNotAt(const scene::Scene& scene, const simulation::MotionPointer& motion,
                     double time) {
    if (!motion || time > motion->computed() || motion->draft())
        return "The motion is not computed up to this time yet.";
    if (time >= motion->finish())
        return "Nothing of the motion is left from here on: go to an earlier moment.";
    return countsFromStart(scene, simulation::releasedBy(scene, *motion, time));
}

scene::Scene sceneAt(const Ground& ground, double time) {
    scene::Scene scene = *ground.scene;
    const scene::Released released = simulation::releasedBy(scene, *ground.motion, time);
    const auto end = [](auto& elements, const std::set<std::size_t>& which) {
        for (const std::size_t index : which)
            elements[index].release = "1";
    };
    end(scene.joints, released.joints);
    end(scene.gears, released.gears);
    end(scene.ropes, released.ropes);
    scene.simulator.start = time;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        scene::Body& body = scene.bodies[i];
        if (body.fixed)
            continue;
        const simulation::BodyState state = ground.motion->at(i, time);
        body.initialPosition = ground.motion->shapePose(i, time).position;
        body.initialAttitude = state.attitude;
        body.initialVelocity = state.velocity;
        body.initialAngularVelocity = state.angularVelocity;
    }
    return scene;
}

editing::Answer startingAt(const Ground& ground, double time, const std::vector<Put>& puts) {
    editing::Answer answer;
    answer.reason = whyNotAt(*ground.scene, ground.motion, time);
    if (!answer.possible())
        return answer;
    const Moment moment(ground, time, puts);
    answer = moment.answer();
    moment.release(answer, simulation::releasedBy(*ground.scene, *ground.motion, time));
    return answer;
}

} // namespace gestures

#include "gestures/present.h"

#include "editing/number_text.h"
#include "editing/variable_uses.h"
#include "element_edits/creation.h"
#include "element_edits/options.h"
#include "element_edits/property_edit.h"
#include "geometry/pose.h"
#include "handles/handles.h"
#include "physics/joint_frames.h"
#include "reports/instants.h"
#include "run/quantities.h"
#include "scene/joint_types.h"
#include "script/structure.h"

#include <algorithm>
#include <cmath>
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

// The names that expressions of the text read.
class Reads {
public:
    explicit Reads(const Ground& ground)
        : text_(ground.text), scene_(*ground.scene), structure_(script::structureOf(ground.text)) {}

    [[nodiscard]] bool name(const std::string& name) const {
        // A loop puts names of plots together, which its text does not show.
        return has(name, text_, structure_) ||
               std::ranges::any_of(scene_.plots, [&](const scene::Plot& plot) {
                   return std::ranges::any_of(
                       plot.values, [&](const std::string& value) { return has(name, value, {}); });
               });
    }

private:
    [[nodiscard]] bool has(const std::string& name, std::string_view text,
                           const script::Structure& structure) const {
        return editing::isUsedIn(name, {0, text.size()}, {},
                                 editing::Origins(text, structure, scene_));
    }

    const std::string& text_;
    const scene::Scene& scene_;
    script::Structure structure_;
};

std::string nameOf(const scene::Joint& joint, std::size_t k) {
    return joint.name + ".q" + scene::coordinateSuffix(joint.type, k);
}

// From one direction to another about an axis, -pi to pi.
double angleAbout(const Vector& axis, const Vector& from, const Vector& to) {
    return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

// The bodies of a joint, at one time.
struct Ends {
    geometry::Pose first, second;
    [[nodiscard]] Vector inSecond(const Vector& inFirst) const {
        return second.attitude.conjugate() * (first.attitude * inFirst);
    }
};

// How far its coordinate is from one placement of its bodies to another, by less than half a turn.
// `offset`: of its point, in the frame of the first body.
double goneBetween(const scene::Joint& joint, std::size_t k, const Vector& offset,
                   const Ends& atStart, const Ends& before, const Ends& after) {
    const Vector own = joint.axis.normalized(), axis = before.inSecond(own);
    const bool isAngle = scene::traitsOf(joint.type).coordinates[k] == scene::CoordinateKind::angle;
    if (joint.type == scene::JointType::universal) {
        const Vector other = joint.axis2 ? Vector(joint.axis2->normalized())
                                         : atStart.second.attitude.conjugate() *
                                               physics::acrossOf(atStart.first.attitude * own);
        if (k == 1)
            return angleAbout(other, axis, after.inSecond(own));
        const auto inFirst = [&](const Ends& ends) {
            return Vector(ends.first.attitude.conjugate() * (ends.second.attitude * other));
        };
        return -angleAbout(own, inFirst(before), inFirst(after));
    }
    if (isAngle) {
        const Vector across = own.unitOrthogonal();
        return angleAbout(axis, before.inSecond(across), after.inSecond(across));
    }
    const auto place = [&](const Ends& ends) {
        return ends.second.toLocal(ends.first.toWorld(offset));
    };
    Vector along = axis;
    if (joint.type == scene::JointType::planar) {
        along = joint.axis2.value_or(Vector::UnitX());
        if (!joint.axis2 && along.cross(axis).norm() < 1e-9)
            along = Vector::UnitY();
        along = (along - axis * axis.dot(along)).normalized();
        if (k == 1)
            along = axis.cross(along);
    }
    return along.dot(place(after) - place(before));
}

// The places of bodies at a moment: as a hand has put them, or as the motion has them.
class Placement {
public:
    Placement(const Ground& ground, double time, const std::vector<Put>& puts)
        : ground_(ground), puts_(puts), time_(time) {}

    [[nodiscard]] const Put* putOf(std::size_t body) const {
        const auto put = std::ranges::find(puts_, body, &Put::body);
        return put == puts_.end() ? nullptr : &*put;
    }

    // How far the coordinate of a joint has gone by the hand.
    [[nodiscard]] double goneByHand(const scene::Joint& joint, std::size_t k) const {
        if (puts_.empty())
            return 0;
        const auto endsAt = [&](double time, bool byHand) {
            return Ends{poseOf(joint.body1, time, byHand), poseOf(joint.body2, time, byHand)};
        };
        const auto& bodies = ground_.scene->bodies;
        const auto first = static_cast<std::size_t>(
            std::ranges::find(bodies, joint.body1, &scene::Body::name) - bodies.begin());
        return goneBetween(joint, k, joint.offset1.value_or(ground_.motion->centroid(first)),
                           endsAt(ground_.motion->start(), false), endsAt(time_, false),
                           endsAt(time_, true));
    }

private:
    // The body stands as the hand has put it, or as the motion has it.
    [[nodiscard]] geometry::Pose poseOf(const std::optional<std::string>& name, double time,
                                        bool byHand) const {
        const auto& bodies = ground_.scene->bodies;
        const auto found =
            name ? std::ranges::find(bodies, *name, &scene::Body::name) : bodies.end();
        if (found == bodies.end())
            return {Vector::Zero(), geometry::Quaternion::Identity()};
        const auto index = static_cast<std::size_t>(found - bodies.begin());
        geometry::Pose pose = ground_.motion->shapePose(index, time);
        if (const Put* const hand = byHand ? putOf(index) : nullptr) {
            pose.position = hand->place;
            pose.attitude = hand->attitude.value_or(pose.attitude);
        }
        return pose;
    }

    const Ground& ground_;
    const std::vector<Put>& puts_;
    double time_;
};

// A coordinate that is so far beyond a limit is there: rounding is none.
constexpr double roundingOf(double value) { return 1e-6 * std::max(1.0, std::abs(value)); }

double withinLimits(const scene::JointCoordinate& q, double value) {
    return std::clamp(value, q.lower.value_or(value), q.upper.value_or(value));
}

class Moment {
public:
    Moment(const Ground& ground, double time, const std::vector<Put>& puts)
        : ground_(ground), placement_(ground, time, puts),
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
        if (std::string why = addCoordinates(wishes); !why.empty())
            return {{}, std::move(why), {}, {}, {}};
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
        const Put* const hand = placement_.putOf(index);
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

    // The coordinates of joints that something asks for. A sentence: why they cannot be so.
    [[nodiscard]] std::string addCoordinates(std::vector<Wish>& wishes) const {
        const scene::Scene& scene = *ground_.scene;
        const auto released = simulation::releasedBy(scene, *ground_.motion, time_).joints;
        const Reads reads(ground_);
        std::vector<std::pair<std::size_t, std::size_t>> asked; // joint, coordinate
        std::vector<std::string> names;
        for (std::size_t i = 0; i < scene.joints.size(); ++i)
            for (std::size_t k = 0; k < scene.joints[i].coordinates.size(); ++k) {
                const scene::Joint& joint = scene.joints[i];
                const scene::JointCoordinate& q = joint.coordinates[k];
                if (!scene::traitsOf(joint.type).hasFrom || released.contains(i))
                    continue;
                if (q.from != 0 || q.lower || q.upper || q.position || q.stiffness != 0 ||
                    reads.name(nameOf(joint, k))) {
                    asked.emplace_back(i, k);
                    names.push_back(nameOf(joint, k));
                }
            }
        if (names.empty())
            return {};
        std::vector<std::string> faults;
        const auto values =
            simulation::Quantities(scene, {}, ground_.motion, names, faults).at(time_);
        for (std::size_t n = 0; n < asked.size(); ++n)
            if (std::string why = addCoordinate(wishes, asked[n], values[n]); !why.empty())
                return why;
        return {};
    }

    [[nodiscard]] std::string addCoordinate(std::vector<Wish>& wishes,
                                            const std::pair<std::size_t, std::size_t>& which,
                                            double value) const {
        const editing::Element element{Kind::joint, which.first};
        const scene::Joint& joint = ground_.scene->joints[which.first];
        const scene::JointCoordinate& q = joint.coordinates[which.second];
        const double byHand = placement_.goneByHand(joint, which.second);
        const std::string name = editing::describe(*ground_.scene, element);
        if (q.position && std::abs(byHand) > roundingOf(0))
            return name + " follows its -position, and this would take it elsewhere.";
        const double wanted = value + byHand;
        const double kept = withinLimits(q, wanted);
        if (std::abs(kept - wanted) > roundingOf(wanted))
            return name + " would be beyond its -limits.";
        wishes.push_back({element,
                          "-from" + scene::coordinateSuffix(joint.type, which.second),
                          {},
                          {kept},
                          1e-9,
                          {0},
                          {q.from}});
        return {};
    }

    void addSimulator(text::Edits& edits) const {
        const auto made = editing::created(
            ground_.text, *ground_.scene,
            {{Kind::simulator, "", {"-start", editing::numberText(time_, 1e-6)}, {}}});
        edits.insert(edits.end(), made.begin(), made.end());
        text::putInOrder(edits);
    }

    const Ground& ground_;
    Placement placement_;
    editing::Mapper mapper_;
    double time_;
    double size_ = 1e-3;
};

} // namespace

JointLimits::JointLimits(const Ground& ground, double time) : ground_(ground), time_(time) {
    const scene::Scene& scene = *ground.scene;
    const auto released = simulation::releasedBy(scene, *ground.motion, time).joints;
    std::vector<std::string> names, faults;
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        for (std::size_t k = 0; k < scene.joints[i].coordinates.size(); ++k) {
            const scene::JointCoordinate& q = scene.joints[i].coordinates[k];
            if (!scene::traitsOf(scene.joints[i].type).hasFrom || released.contains(i) ||
                !(q.lower || q.upper))
                continue;
            limited_.push_back({i, k, 0});
            names.push_back(nameOf(scene.joints[i], k));
        }
    if (names.empty())
        return;
    const auto values = simulation::Quantities(scene, {}, ground.motion, names, faults).at(time);
    for (std::size_t n = 0; n < limited_.size(); ++n)
        limited_[n].value = values[n];
}

bool JointLimits::areKept(const std::vector<Put>& puts) const {
    const Placement placement(ground_, time_, puts);
    return std::ranges::all_of(limited_, [&](const Coordinate& one) {
        const scene::Joint& joint = ground_.scene->joints[one.joint];
        const double now = one.value + placement.goneByHand(joint, one.index);
        return std::abs(withinLimits(joint.coordinates[one.index], now) - now) <= roundingOf(now);
    });
}

double roundMoment(const simulation::Motion& motion, double time) {
    const double step = editing::decimalStep((motion.finish() - motion.start()) / 2000);
    return std::clamp(editing::roundedTo(time, step), motion.start(), motion.computed());
}

std::string countsAnew(const Ground& ground, double time) {
    std::string names;
    std::size_t count = 0;
    const Reads reads(ground);
    const auto add = [&](const std::string& name) {
        if (!reads.name(name))
            return;
        names += (count == 0 ? "" : ", ") + name;
        ++count;
    };
    for (const scene::Joint& joint : ground.scene->joints) {
        const scene::JointTraits& traits = scene::traitsOf(joint.type);
        for (std::size_t k = 0; traits.startsAtZero && k < traits.coordinates.size(); ++k)
            if (!traits.hasFrom)
                add(nameOf(joint, k));
    }
    for (const scene::Body& body : ground.scene->bodies)
        for (const char* turn : {".rx", ".ry", ".rz"})
            add(body.name + turn);
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

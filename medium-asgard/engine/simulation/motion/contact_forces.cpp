#include "motion/contact_forces.h"

#include "motion/computed_motion.h"

#include <algorithm>
#include <map>
#include <span>

namespace simulation {
namespace {

using Part = ComputedMotion::Part;

// An entry of the log has all contacts of its bodies from its time on. The last entry of a body
// counts.
std::vector<const ContactLog::Contact*> contactsAt(const Part& part, double time) {
    const auto& entries = part.contacts.entries();
    auto after = std::upper_bound(
        entries.begin(), entries.end(), time,
        [](double at, const ContactLog::EntryPointer& entry) { return at < entry->time; });
    std::vector<bool> isTold(part.bodies->size());
    std::vector<const ContactLog::Contact*> found;
    while (after != entries.begin()) {
        const ContactLog::Entry& entry = **--after;
        for (const ContactLog::Contact& contact : entry.contacts)
            if (!isTold[contact.body] && !isTold[contact.support])
                found.push_back(&contact);
        for (const std::size_t body : entry.moving)
            isTold[body] = true;
    }
    std::ranges::reverse(found);
    return found;
}

class ForcesOfPart {
public:
    ForcesOfPart(const ComputedMotion& motion, std::size_t index, double time)
        : motion_(motion), part_(motion.contents().parts[index]), time_(time) {
        const auto& places = motion.contents().places;
        for (std::size_t b = 0; b < places.size(); ++b)
            if (places[b].part == index)
                shown_.emplace(places[b].body, b);
    }

    void addTo(std::vector<ContactForce>& forces) const {
        for (const ContactLog::Contact* contact : contactsAt(part_, time_))
            add(*contact, forces);
    }

private:
    // None: the body is shown of another part, or has stopped. Fixed bodies stand in each part.
    [[nodiscard]] std::optional<physics::SurfacePose> poseOf(std::size_t body) const {
        const auto made = [](const geometry::Pose& pose) {
            return physics::SurfacePose{pose.position, pose.attitude.toRotationMatrix()};
        };
        const BodyRecord& record = (*part_.bodies)[body];
        if (record.isFixed)
            return made(record.start);
        const auto shown = shown_.find(body);
        if (shown == shown_.end())
            return std::nullopt;
        const auto stop = motion_.stop(shown->second);
        if (stop && time_ > stop->time)
            return std::nullopt;
        const BodyState state = motion_.at(shown->second, time_);
        return made({state.position, state.attitude});
    }

    [[nodiscard]] std::vector<double> multipliersOf(std::span<const std::size_t> rows) const {
        std::vector<double> values(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (!part_.conditions->values(rows[i], time_, std::span(&values[i], 1)))
                values[i] = 0;
        return values;
    }

    void add(const ContactLog::Contact& contact, std::vector<ContactForce>& forces) const {
        const auto body = poseOf(contact.body), support = poseOf(contact.support);
        if (!body || !support)
            return;
        const physics::ContactPress press =
            physics::pressOf(*contact.surfaces, *body, *support, multipliersOf(contact.normals),
                             multipliersOf(contact.friction));
        if (press.force.isZero(0) || !press.force.allFinite() || !press.point.allFinite())
            return;
        const auto [lesser, greater] = contact.bodies;
        const std::size_t on = (*part_.bodies)[lesser].isFixed ? greater : lesser;
        const double side = on == contact.body ? 1 : -1;
        forces.push_back({.on = shown_.at(on),
                          .point = press.point,
                          .force = side * press.force,
                          .normal = side * press.normal,
                          .friction = contact.surfaces->friction});
    }

    const ComputedMotion& motion_;
    const Part& part_;
    double time_;
    std::map<std::size_t, std::size_t> shown_; // body of the scene, by the part's
};

} // namespace

std::vector<ContactForce> contactForcesAt(const Motion& motion, double time) {
    std::vector<ContactForce> forces;
    const double at = std::clamp(time, motion.start(), motion.computed());
    if (const auto* computed = dynamic_cast<const ComputedMotion*>(&motion)) {
        const auto& parts = computed->contents().parts;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].conditions && !parts[i].contacts.entries().empty())
                ForcesOfPart(*computed, i, at).addTo(forces);
    }
    return forces;
}

} // namespace simulation

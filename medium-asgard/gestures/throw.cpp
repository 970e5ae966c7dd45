#include "gestures/throw.h"

#include "framing/framing.h"

#include <algorithm>

namespace gestures {

using geometry::Vector;

namespace {

constexpr double lately = 0.1; // s: how the hand moved before it let go
constexpr double soon = 0.03;  // s: from one place of a hand that moves to the next

geometry::Pose poseAt(const Ground& ground, std::size_t body, double moment) {
    return render::poseOf(*ground.scene, ground.motion.get(), body, moment);
}

} // namespace

std::unique_ptr<Joined> joinedAt(const Ground& ground, double moment, std::size_t body,
                                 const Sight& sight, const Eigen::Vector2d& pixels) {
    const Vector place = poseAt(ground, body, moment).position;
    return Joined::of(sceneAt(ground, moment), body, sight.across(pixels, place));
}

std::optional<std::string> whyNotTaken(const Ground& ground, double time, std::size_t body) {
    const scene::Body& one = ground.scene->bodies[body];
    if (!ground.motion || time <= ground.motion->start() || one.fixed)
        return std::nullopt;
    const auto& constraints = ground.scene->constraints;
    const auto leader = std::ranges::find(constraints, one.name, &scene::Constraint::body);
    if (leader != constraints.end())
        return one.name + " is led by the path " + leader->trajectory +
               ": it is neither thrown nor put elsewhere on its way. Its place at the start can be "
               "dragged there.";
    return whyNotAt(*ground.scene, ground.motion, roundMoment(*ground.motion, time));
}

Throw::Throw(Ground ground, double moment, std::size_t body, const Sight& sight,
             const Eigen::Vector2d& pixels, Poses company)
    : ground_(std::move(ground)), moment_(moment), body_(body),
      pose_(poseAt(ground_, body, moment)),
      off_(pose_.position - sight.across(pixels, pose_.position)),
      joined_(joinedAt(ground_, moment, body, sight, pixels)), company_(std::move(company)) {
    if (joined_)
        joined_->keep([limits = JointLimits(ground_, moment_)](const Joined& joined) {
            std::vector<Put> puts;
            for (const std::size_t one : joined.bodies()) {
                const geometry::Pose there = joined.poseOf(one);
                puts.push_back({one, there.position, std::nullopt, 0, there.attitude});
            }
            return limits.areKept(puts);
        });
}

// In the upright or level plane through a place of the body.
void Throw::move(const Sight& sight, const Eigen::Vector2d& pixels, double seconds) {
    way_.push_back({seconds, sight.across(pixels, pose_.position) + off_});
    if (!joined_)
        return;
    const Vector way = way_.back().place - pose_.position;
    joined_->isLoose() ? joined_->moveAll(way) : joined_->pull(way);
}

// Between two places that are told soon after each other the hand went steadily.
Vector Throw::velocity(double rate, double seconds) const {
    if (way_.empty())
        return Vector::Zero();
    const Place& last = way_.back();
    const double end = seconds - last.seconds < soon ? last.seconds : seconds;
    double begin = end - lately;
    const auto first =
        std::ranges::find_if(way_, [&](const Place& one) { return one.seconds >= begin; });
    if (first == way_.end())
        return Vector::Zero(); // the hand was still
    Vector from = first->place;
    if (first == way_.begin()) {
        begin = first->seconds;
    } else {
        const Place& before = *(first - 1);
        const double left = std::max(before.seconds, first->seconds - soon);
        const double part =
            std::clamp((first->seconds - begin) / std::max(first->seconds - left, 1e-9), 0.0, 1.0);
        from += part * (before.place - from);
    }
    return (last.place - from) / std::max(end - begin, 1e-2) / rate;
}

std::vector<Put> Throw::allPut(double resolution, const std::optional<Vector>& velocity) {
    std::vector<Put> puts;
    const Vector way = way_.back().place - pose_.position;
    for (const auto& [body, pose] : company_)
        puts.push_back({body, pose.position + way, std::nullopt, resolution});
    if (!puts.empty())
        return puts;
    if (!joined_)
        return {{body_, way_.back().place, velocity, resolution}};
    for (const editing::NewPlace& one : joined_->thrown(velocity))
        puts.push_back({one.body, one.pose.position, one.velocity->linear, 0, one.pose.attitude,
                        one.velocity->angular});
    return puts;
}

editing::Answer Throw::answer(const Sight& sight, std::optional<double> rate, double seconds) {
    const auto thrown = rate ? std::optional(velocity(*rate, seconds)) : std::nullopt;
    return startingAt(ground_, moment_, allPut(sight.pixelLength(pose_.position), thrown));
}

std::string Throw::name() const {
    const std::string& name = ground_.scene->bodies[body_].name;
    return company_.size() > 1 ? name + " and " + std::to_string(company_.size() - 1) + " more"
                               : name;
}

Throw::Poses Throw::poses() const {
    if (!company_.empty()) {
        Poses all = company_;
        for (auto& [body, pose] : all)
            pose.position += way_.back().place - pose_.position;
        return all;
    }
    if (!joined_)
        return {{body_, {way_.back().place, pose_.attitude}}};
    Poses all;
    for (const std::size_t body : joined_->bodies())
        all.emplace_back(body, joined_->poseOf(body));
    return all;
}

std::pair<Vector, Vector> Throw::way() const {
    return {pose_.position,
            joined_ && company_.empty() ? joined_->poseOf(body_).position : way_.back().place};
}

} // namespace gestures

#include "collision/advancement.h"

#include "collision/curved_separation.h"
#include "collision/following_normal.h"
#include "collision/hollow_separation.h"
#include "collision/polynomial.h"
#include "collision/spheres.h"
#include "collision/turning_axis.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace collision {

namespace {

constexpr double deep = 1e-7; // of the size: deeper than this is an overlap, not a touch
constexpr std::size_t mostEvaluations = 20'000;
constexpr std::size_t patience = 40; // gaps, until axes that turn are tried too

constexpr double mostlyAbout = 0.1; // an axis: of the spin what is across it

// What turning can add to the part's extent along `direction` within `window`: the extent grows
// at most by rate s + curvature s^2 / 2, and never beyond `room`.
struct Growth {
    double rate = 0, curvature = 0, room = 0;
};

class Advance {
public:
    Advance(const PartPair& pair, Interval during)
        : pair_(pair), during_(during), t_(during.from), size_(pair.size()),
          unnoticed_(pair.unnoticedDepth(during.from)) {}

    Encounter run() {
        while (result_.evaluations < mostEvaluations && !finished_) {
            const Separation now = pair_.separationAt(t_, warm_);
            isInHollow_ = now.isInside;
            ++result_.evaluations;
            const double roundOff = pair_.roundOff(t_);
            if (now.gap < -std::max(deepest(), roundOff))
                stepOutOf(now);
            else if (now.gap <= roundOff || stalled_)
                touch(now);
            else
                stepTowards(now);
        }
        if (!finished_) {
            hit(contactOf(pair_, t_, pair_.separationAt(t_, warm_)), t_, false);
            result_.hit->isLost = true;
        }
        return result_;
    }

private:
    // Deeper they overlap. What was let sink in unnoticed touches still.
    [[nodiscard]] double deepest() const { return std::max(deep * size_, 2 * unnoticed_); }

    // How much deeper a step may lead: what touches is not to overlap after it.
    [[nodiscard]] double allowed(double depth) const {
        return std::clamp(0.5 * (2 * unnoticed_ - depth), 1e-3 * unnoticed_, unnoticed_);
    }

    // An approach that closes less than rounding in all of the interval is none: the speeds of a
    // piece that is next to nothing long are rounding.
    [[nodiscard]] double leastApproach() const {
        const double length = during_.to - during_.from;
        const double least = pair_.leastApproach(t_);
        return length > 0 ? std::max(least, pair_.roundOff(t_) / length) : least;
    }

    [[nodiscard]] double left() const { return during_.to - t_; }

    void moveBy(double s) {
        if (!(s < left())) {
            // The end itself is looked at, once: a hit may fall exactly on it.
            finished_ = t_ == during_.to || s > left();
            t_ = during_.to;
            return;
        }
        const double next = t_ + s;
        stalled_ = next - t_ <= 0 || s <= 2e-16 * std::abs(t_);
        t_ = stalled_ ? std::nextafter(t_, HUGE_VAL) : next;
    }

    void hit(const Contact& contact, double time, bool pressing) {
        result_.hit = Hit{.time = time, .contact = contact, .pressing = pressing};
        finished_ = true;
    }

    void touch(const Separation& now) {
        stalled_ = false;
        Contact contact = contactOf(pair_, t_, now);
        const double least = leastApproach();
        Vector axis = now.normal;
        bool isRoundPassing = false; // what it comes upon next is met there, and presses not here
        if (contact.closingSpeed > least)
            if (std::optional<Contact> kept = passing(pair_, t_)) {
                contact = std::move(*kept);
                axis = contact.normal;
                isRoundPassing = pair_.first.part->isSphere() || pair_.second.part->isSphere();
            }
        if (contact.closingSpeed > least) {
            // Having touched without approaching and sunk in, they were pressed together; unless
            // they approach faster than that could make them: then something else has come down.
            if (pressed_ && contact.closingSpeed <= least + 2 * gainedSince(pressed_->first))
                hit(pressed_->second, pressed_->first, true);
            else
                hit(contact, t_, false);
            return;
        }
        pressed_.reset();
        if (contact.closingSpeed >= -least) {
            if (!isRoundPassing)
                pressed_ = {t_, contact};
        } else if (now.gap < -100 * pair_.roundOff(t_)) {
            // They part from an overlap that counts: out of it first, or the way back is that long.
            stepOutOf(now);
            return;
        }
        // A step too short to matter is made as long as sinking in unnoticed allows; so is each one
        // of those that stay in touch and get nowhere.
        const double away = nextContact(axis, 0, true);
        if (result_.evaluations <= patience && away * pair_.relativeSpeed(t_) > unnoticed_)
            moveBy(away);
        else
            moveBy(std::max(away, nextContact(axis, allowed(-now.gap), false)));
    }

    // How much faster two points of the parts may approach each other than at `then`, at the most.
    [[nodiscard]] double gainedSince(double then) const {
        const Velocity a = velocityAt(pair_.first.piece, t_),
                       b = velocityAt(pair_.second.piece, t_);
        const Velocity before = velocityAt(pair_.first.piece, then);
        const Velocity beforeOther = velocityAt(pair_.second.piece, then);
        double gained = (a.linear - b.linear - before.linear + beforeOther.linear).norm();
        const double speed = pair_.relativeSpeed(t_);
        for (const auto& [part, now, was] :
             {std::tuple(&pair_.first, &a, &before), std::tuple(&pair_.second, &b, &beforeOther)}) {
            const double spin = std::max(now->angular.norm(), was->angular.norm());
            gained += (now->angular - was->angular).norm() * part->reach +
                      spin * (t_ - then) * (spin * part->reach + speed);
        }
        // The wall turns towards what goes along it.
        if (const double room = isInHollow_ ? roomInHollow(pair_) : 0; room > 0)
            gained += (t_ - then) * speed * speed / room;
        return gained;
    }

    void stepTowards(const Separation& now) {
        pressed_.reset();
        moveBy(nextContact(now.normal, now.gap, false));
    }

    // No faster than the fastest point: the depth cannot vanish before that. Nor does it vanish,
    // for all that can be told here, before half the time that it takes at the speed at which they
    // part.
    void stepOutOf(const Separation& now) {
        const double depth = -now.gap;
        if (result_.evaluations == 1 && depth > deepest())
            result_.overlap = depth;
        pressed_.reset();
        const double window = left();
        double speed = 0;
        for (const PartMotion* p : {&pair_.first, &pair_.second})
            speed += turnBounds(p->piece, t_, t_ + window).angularSpeed * p->reach;
        const RelativePath path = relativePath(pair_.first.piece, pair_.second.piece, t_);
        for (const Polynomial& p : path) {
            double power = 1;
            for (std::size_t k = 1; k < p.count; ++k, power *= window)
                speed += static_cast<double>(k) * std::abs(p.terms[k]) * power;
        }
        if (!std::isfinite(speed)) // too long a window for the bounds: a small step
            moveBy(std::max(left() / 1024, 1e-12));
        else if (speed > 0) {
            const double parting = -contactOf(pair_, t_, now).closingSpeed;
            const double least = std::max(depth, pair_.roundOff(t_));
            const double shortest = least / speed;
            // What parts slowly and is pressed comes back before.
            moveBy(parting > 0 ? std::max(shortest,
                                          std::min(0.5 * depth / parting,
                                                   nextContact(now.normal, allowed(depth), false)))
                               : shortest);
        } else
            finished_ = true;
    }

    // Seconds until the gap, which is `gap` now, can become zero along the present normal; more
    // than is left when it cannot. With `leaving`, the root at 0 is divided out.
    double nextContact(const Vector& n, double gap, bool leaving) {
        if (isInHollow_)
            return nextInHollow(gap, leaving);
        const Polynomial along = motionAlong(n);
        if (!pair_.first.turns() && !pair_.second.turns())
            return root(withGap(along, gap), left(), leaving);
        // A root close to 0 that is divided out says nothing about the next one's window.
        double& lastWindow = leaving ? windowAway_ : window_;
        double best = inWindows(
            lastWindow, [&](double window) { return rootWithin(along, n, gap, window, leaving); });
        if (result_.evaluations > patience) {
            best = std::max(best, nextAlongFollowing(n, gap, leaving));
            if (!isCurvedPair(*pair_.first.part, *pair_.second.part))
                best = std::max(best, nextAlongTurningAxes(n, gap));
        }
        lastWindow = std::max(16 * best, 1e-12 * left());
        // Nothing within the window: only that much is known.
        return best >= left() ? 2 * left() : best;
    }

    // The longest time that `within` finds in a window; more than that window: all of it.
    template <typename Within> double inWindows(double first, Within&& within) const {
        double best = 0, window = std::min(left(), first);
        for (int i = 0; i < 4; ++i) {
            const double s = within(window);
            best = std::max(best, std::min(s, window));
            if (s > window / 16) // wide enough; a narrower window has tighter bounds
                break;
            window = std::max(4 * s, window / 4096);
        }
        return best;
    }

    double nextInHollow(double gap, bool leaving) {
        double& lastWindow = leaving ? windowAway_ : window_;
        const double best = inWindows(lastWindow, [&](double window) {
            return clearFor({pair_, t_, gap, window, leaving});
        });
        lastWindow = std::max(16 * best, 1e-12 * left());
        return best >= left() ? 2 * left() : best;
    }

    double rootWithin(const Polynomial& along, const Vector& n, double gap, double window,
                      bool leaving) const {
        const Growth a = growth(pair_.first, -n, Vector::Zero(), window),
                     b = growth(pair_.second, n, Vector::Zero(), window);
        double s = 0;
        if (const double c = a.curvature + b.curvature; std::isfinite(c)) {
            Polynomial turning = withGap(along, gap);
            turning.count = std::max<std::size_t>(turning.count, 3);
            turning.terms[1] -= a.rate + b.rate;
            turning.terms[2] -= c / 2;
            s = root(turning, window, leaving);
        }
        if (const double clear = gap - a.room - b.room; clear > 0)
            s = std::max(s, root(withGap(along, clear), window, false));
        return s;
    }

    // The same along axes that turn with the parts.
    double nextAlongTurningAxes(const Vector& n, double gap) {
        const double apart = apartFor({.pair = pair_,
                                       .normal = n,
                                       .t = t_,
                                       .gap = gap,
                                       .unnoticed = std::max(unnoticed_ - gap, 0.0),
                                       .left = left(),
                                       .firstWindow = turningWindow_});
        turningWindow_ = std::max(64 * apart, 1e-9 * left());
        return apart;
    }

    // The same along a direction that follows what touches.
    double nextAlongFollowing(const Vector& n, double gap, bool leaving) {
        const auto turn = pair_.hasPlane() ? std::nullopt : followingTurn(pair_, n, t_);
        if (!turn || turn->isZero(0))
            return 0;
        const double best = inWindows(followingWindow_, [&](double window) {
            const Growth a = growth(pair_.first, -n, *turn, window),
                         b = growth(pair_.second, n, *turn, window);
            const double c = a.curvature + b.curvature;
            if (!std::isfinite(c))
                return 0.0;
            Polynomial apart = withGap(motionAlong(n, *turn, window), gap);
            apart.terms[1] -= a.rate + b.rate;
            apart.terms[2] -= c / 2;
            return root(apart, window, leaving);
        });
        followingWindow_ = std::max(16 * best, 1e-12 * left());
        return best;
    }

    // n . (p(t + s) - p(t)), the constant term left 0.
    [[nodiscard]] Polynomial motionAlong(const Vector& n) const {
        const RelativePath path = relativePath(pair_.first.piece, pair_.second.piece, t_);
        Polynomial result;
        for (std::size_t c = 0; c < 3; ++c) {
            result.count = std::max(result.count, path[c].count);
            for (std::size_t k = 1; k < path[c].count; ++k)
                result.terms[k] += n[static_cast<Eigen::Index>(c)] * path[c].terms[k];
        }
        return result;
    }

    // At least n(s) . p(t + s) - n . p(t) within the window, where n(s) turns at `turn`: n(s) is
    // n + s (turn x n), but for s^2/2 |turn| |turn x n|.
    [[nodiscard]] Polynomial motionAlong(const Vector& n, const Vector& turn, double window) const {
        const RelativePath path = relativePath(pair_.first.piece, pair_.second.piece, t_);
        const Vector change = turn.cross(n);
        Polynomial result = motionAlong(n);
        double farthest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            result.count = std::max(result.count, path[c].count + 1);
            double power = 1;
            for (std::size_t k = 0; k < path[c].count; ++k, power *= window) {
                result.terms[k + 1] += change[static_cast<Eigen::Index>(c)] * path[c].terms[k];
                farthest += std::abs(path[c].terms[k]) * power;
            }
        }
        result.count = std::max<std::size_t>(result.count, 3);
        result.terms[2] -= turn.norm() * change.norm() * farthest / 2;
        return result;
    }

    static Polynomial withGap(Polynomial p, double gap) {
        p.terms[0] = gap;
        return p;
    }

    static double root(Polynomial p, double length, bool leaving) {
        if (leaving) { // p(0) = 0
            for (std::size_t k = 0; k + 1 < p.count; ++k)
                p.terms[k] = p.terms[k + 1];
            p.terms[p.count - 1] = 0;
            p.count = std::max<std::size_t>(p.count - 1, 1);
        }
        const auto s = firstDescent(p, length);
        return s ? *s : 2 * length;
    }

    struct Extents {
        double now = 0, then = 0; // along n and along n turned back, from the pivot
        double reach = 0;
    };
    // Of the part's core.
    [[nodiscard]] Extents extents(const PartMotion& p, const Vector& n,
                                  const Vector& turned) const {
        const Posed posed = p.posedAt(t_, positionAt(p.piece, t_)); // levers from the pivot
        if (p.part->curved)
            return {n.dot(posed.furthest(n)), turned.dot(posed.furthest(turned)), p.reach};
        return {n.dot(posed.world(posed.support(n))),
                turned.dot(posed.world(posed.support(turned))), p.reach - p.part->radius};
    }

    // Of the piece of a half space that the other part can come to within the window: a disc about
    // the foot of its pivot.
    [[nodiscard]] Extents nearOfPlane(const PartMotion& p, const Vector& n, const Vector& turned,
                                      double angularSpeed, double window) const {
        const PartMotion& other = &p == &pair_.first ? pair_.second : pair_.first;
        const Posed posed = p.posedAt(t_, positionAt(p.piece, t_));
        const Vector up = posed.rotation * p.part->curved->axis();
        const Vector origin = posed.rotation * p.part->curved->center + posed.offset;
        const Vector place = positionAt(other.piece, t_) - positionAt(p.piece, t_);
        const double height = up.dot(place - origin);
        const Vector foot = place - height * up;
        double travel = 0, power = window;
        const RelativePath path = relativePath(pair_.first.piece, pair_.second.piece, t_);
        for (std::size_t k = 1; k <= maximumDegree; ++k, power *= window)
            for (const Polynomial& c : path)
                if (k < c.count)
                    travel += std::abs(c.terms[k]) * power;
        double radius = std::abs(height) + other.reach + travel;
        radius += angularSpeed * window * (foot.norm() + radius);
        const auto along = [&](const Vector& d) {
            return d.dot(foot) + radius * (d - up * up.dot(d)).norm();
        };
        return {along(n), along(turned), foot.norm() + radius};
    }

    // Along a direction n that turns at `turn`, as a constant axis lets it, the rate of n.(R x) is
    // n.((w - turn) x x), so that extents grow to first order like the support along
    // n + s (n x (w - turn)); that is convex in s and lies below its chord. Second order:
    // (|w - turn| (w + turn) + w') |x|; where nothing turns but about n, (|n x w'| + |n x w| w)
    // |x|.
    [[nodiscard]] Growth growth(const PartMotion& p, const Vector& n, const Vector& turn,
                                double window) const {
        const bool doesFollow = !turn.isZero(0);
        if (!p.turns() && !doesFollow)
            return {};
        const TurnBounds bounds = turnBounds(p.piece, t_, t_ + window);
        const Vector w = velocityAt(p.piece, t_).angular;
        const Vector turned = n + window * n.cross(w - turn);
        const auto [now, then, reach] = p.part->isPlane()
                                            ? nearOfPlane(p, n, turned, bounds.angularSpeed, window)
                                            : extents(p, n, turned);
        const double beside = doesFollow ? (w - turn).norm() + bounds.angularAcceleration * window
                                         : bounds.angularSpeed;
        Growth g;
        g.rate = (then - now) / window;
        g.curvature =
            (beside * (bounds.angularSpeed + turn.norm()) + bounds.angularAcceleration) * reach;
        g.room = reach - now;
        // Turning about n itself moves nothing along it: a box that spins on a floor stays there.
        if (!doesFollow && n.cross(w).norm() < mostlyAbout * w.norm()) {
            const TurnBounds across = turnBoundsAcross(p.piece, n, t_, t_ + window);
            const double bend =
                across.angularAcceleration + across.angularSpeed * bounds.angularSpeed;
            if (std::isfinite(bend))
                g.curvature = std::min(g.curvature, bend * reach);
        }
        return g;
    }

    const PartPair& pair_;
    Interval during_;
    double t_;
    double size_, unnoticed_;
    double window_ = HUGE_VAL, windowAway_ = HUGE_VAL, turningWindow_ = HUGE_VAL,
           followingWindow_ = HUGE_VAL;
    WarmStart warm_;
    bool stalled_ = false, finished_ = false, isInHollow_ = false;
    std::optional<std::pair<double, Contact>> pressed_;
    Encounter result_;
};

} // namespace

Encounter advance(const PartPair& pair, Interval during) { return Advance(pair, during).run(); }

} // namespace collision

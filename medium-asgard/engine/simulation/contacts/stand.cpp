#include "contacts/stand.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace simulation {

using physics::ContactPoint;
using Kind = physics::SurfacePiece::Kind;

std::vector<Stand::Arc> Stand::arcsBeside() const {
    std::vector<std::pair<double, bool>> round; // angles in order, and who carries
    for (std::size_t k = 0; k < carries.size(); ++k)
        round.emplace_back(angles[k], carries[k] != 0);
    std::ranges::sort(round);
    std::vector<Arc> between, beside;
    for (std::size_t k = 0; k < round.size(); ++k) {
        const bool isLast = k + 1 == round.size();
        const auto& [from, carriesFrom] = round[k];
        const auto& [to, carriesTo] = round[isLast ? 0 : k + 1];
        const Arc arc{from, to - from + (isLast ? 2 * std::numbers::pi : 0)};
        if (carriesFrom && carriesTo)
            between.push_back(arc);
        else if (carriesFrom || carriesTo)
            beside.push_back(arc);
    }
    return between.empty() ? beside : between;
}

bool Stand::tipsEarly() const {
    // Shorter arcs lie so near the rim that rates of their points are 0 but for rounding.
    constexpr double shortest = 2e-3;
    // On so short a part a third point next to those that carry may carry by rounding.
    constexpr double narrow = 0.1;
    std::vector<double> carrying;
    std::size_t count = 0;
    for (std::size_t k = 0; k < carries.size(); ++k)
        if (carries[k] != 0) {
            ++count;
            if (!angles.empty())
                carrying.push_back(angles[k]);
        }
    if (isAcrossBorder)
        return isOnFew && (count == 1 || count == 2);
    const auto isNear = [&](double angle) {
        return std::abs(std::remainder(angle - carrying[0], 2 * std::numbers::pi)) < narrow;
    };
    if (count == 0 || (count > 2 && !std::ranges::all_of(carrying, isNear)))
        return false;
    return std::ranges::any_of(arcsBeside(), [](const Arc& arc) { return arc.width > shortest; });
}

namespace {

constexpr std::size_t few = 4;

class Choosing {
public:
    Choosing(const Touch& touch, const Placed& owner,
             const std::function<ContactPoint(const Vector& at, bool isBodys)>& onRim, bool isBodys,
             std::vector<ContactPoint>& points)
        : touch_(touch), owner_(owner), onRim_(onRim), isBodys_(isBodys), points_(points) {}

    void standOnFew(std::size_t first) {
        const auto isOfRim = [](const Corner& corner) { return !corner.pieces; };
        const auto all = std::ranges::count_if(touch_.corners, isOfRim);
        const auto step = std::max<std::size_t>(static_cast<std::size_t>(all) / few, 1);
        std::vector<ContactPoint> kept;
        std::size_t ofRim = first * step / few;
        for (std::size_t i = 0; i < touch_.corners.size(); ++i)
            if (!isOfRim(touch_.corners[i]) || ofRim++ % step == 0)
                kept.push_back(std::move(points_[i]));
        points_ = std::move(kept);
    }

    void findRim() {
        for (const ContactPoint& point : points_)
            middle_ += placeOf(point) / static_cast<double>(points_.size());
        const Vector arm = placeOf(points_[0]) - middle_;
        radius_ = arm.norm();
        along_ = arm / radius_;
        across_ =
            Vector(owner_.state.attitude.conjugate() * touch_.normal).cross(along_).normalized();
    }

    // Where the end tips, on the first few points, on those that carry, and on others beside them.
    void standAsBefore(const Stand& was) {
        points_.clear();
        const bool tips = !was.carries.empty();
        Stand now; // as the rim has its angles here
        for (std::size_t k = 0; k < was.places.size(); ++k) {
            now.angles.push_back(angleOf(was.places[k]));
            if (!tips || k < few || was.carries[k] != 0)
                addAt(was.places[k]);
        }
        now.carries = was.carries;
        for (const Stand::Arc& arc : now.arcsBeside())
            for (std::size_t k = 1; k < few; ++k) {
                const double at =
                    arc.from + arc.width * static_cast<double>(k) / static_cast<double>(few);
                addAt(middle_ + radius_ * (std::cos(at) * along_ + std::sin(at) * across_));
            }
    }

    void note(Stand& stand) const {
        for (const ContactPoint& point : points_) {
            stand.places.push_back(placeOf(point));
            stand.angles.push_back(angleOf(placeOf(point)));
        }
    }

private:
    [[nodiscard]] const Vector& placeOf(const ContactPoint& point) const {
        return isBodys_ ? point.gap.body.place : point.gap.support.place;
    }
    [[nodiscard]] double angleOf(const Vector& place) const {
        return std::atan2(across_.dot(place - middle_), along_.dot(place - middle_));
    }
    void addAt(const Vector& place) {
        constexpr double same = 1e-9; // of the parts' size
        const auto isThere = [&](const ContactPoint& point) {
            return (placeOf(point) - place).norm() <= same * touch_.size;
        };
        if (std::ranges::none_of(points_, isThere))
            points_.push_back(
                onRim_(owner_.state.position + owner_.state.attitude * place, isBodys_));
    }

    const Touch& touch_;
    const Placed& owner_;
    const std::function<ContactPoint(const Vector& at, bool isBodys)>& onRim_;
    bool isBodys_;
    std::vector<ContactPoint>& points_;
    Vector middle_ = Vector::Zero(), along_ = Vector::UnitX(), across_ = Vector::UnitZ();
    double radius_ = 0;
};

} // namespace

Stand chooseStand(const Touch& touch, const Placed& body, const Placed& support, const Stand* was,
                  const std::function<ContactPoint(const Vector& at, bool isBodys)>& onRim,
                  std::vector<ContactPoint>& points) {
    Stand stand;
    stand.stands = true;
    stand.isBodys = points[0].gap.support.kind == Kind::plane;
    // Two rims that lie on each other cross, too: their points are ends of no one of the two.
    const auto isOfRim = [&](const ContactPoint& point) {
        const auto& [own, other] = stand.isBodys ? std::tie(point.gap.body, point.gap.support)
                                                 : std::tie(point.gap.support, point.gap.body);
        return own.kind == Kind::point && other.kind == Kind::plane;
    };
    stand.isAcrossBorder = !std::ranges::all_of(points, isOfRim);
    const bool isKnown = was != nullptr && was->isAcrossBorder == stand.isAcrossBorder &&
                         was->isBodys == stand.isBodys;
    Choosing choosing(touch, stand.isBodys ? body : support, onRim, stand.isBodys, points);
    if (stand.isAcrossBorder) {
        stand.isOnFew = !isKnown || (was->isOnFew && was->carries.empty());
        if (stand.isOnFew)
            choosing.standOnFew(few / 2); // the ends of an arc leave the face first
        return stand;
    }
    choosing.findRim();
    if (isKnown)
        choosing.standAsBefore(*was);
    else
        choosing.standOnFew(0);
    choosing.note(stand);
    return stand;
}

} // namespace simulation

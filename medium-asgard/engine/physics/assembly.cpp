#include "physics/assembly.h"

#include "physics/linkage.h"

#include <cstdio>
#include <utility>

namespace physics {
namespace {

// Along what opens nothing, back towards where the bodies were.
void shorten(Linkage& linkage, const std::function<bool()>& cancelled) {
    constexpr int most = 60;
    for (int k = 0; k < most && !cancelled(); ++k) {
        const Eigen::MatrixXd jacobian = linkage.jacobian();
        const Eigen::VectorXd way = linkage.movement();
        const Eigen::VectorXd along = way - linkage.solver().solve(Eigen::VectorXd(jacobian * way));
        if (!(along.norm() > 1e-9 * way.norm()))
            return;
        const std::vector<double> before = linkage.values();
        linkage.step(-along);
        if (!linkage.close(cancelled) || !(linkage.movement().norm() < way.norm()))
            return linkage.setValues(before);
    }
}

} // namespace

// A coordinate counts from the start, wherever that is: its drive is no gap.
Assembly assembled(const scene::Scene& written, const std::function<bool()>& cancelled) {
    scene::Scene scene = written;
    for (scene::Joint& joint : scene.joints)
        for (scene::JointCoordinate& coordinate : joint.coordinates)
            coordinate.position.reset();
    EquationsOfMotion equations(scene, {}, nullptr, EquationsOfMotion::Start::mayMiss);
    Assembly made;
    if (!equations.faults.empty()) {
        made.reason = equations.faults.front();
        return made;
    }
    const auto isCancelled = [&] {
        made.cancelled = made.cancelled || (cancelled && cancelled());
        return made.cancelled;
    };
    Linkage linkage(scene, equations);
    const bool closes = linkage.close(isCancelled);
    if (closes)
        shorten(linkage, isCancelled);
    if (isCancelled())
        return made;
    if (closes) {
        made.moved = linkage.moved();
        return made;
    }
    char text[160];
    std::snprintf(text, sizeof text,
                  "the joints do not close by moving the bodies that are free to move; a gap of "
                  "%.4g is left",
                  linkage.largestGap());
    made.reason = text;
    return made;
}

} // namespace physics

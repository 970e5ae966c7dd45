#include "handles/handles.h"

#include "signs/joint_signs.h"

namespace render {

scene::Color colorOf(HandleKind kind) {
    switch (kind) {
    case HandleKind::position:
        return {0.95, 0.55, 0.05};
    case HandleKind::orientation:
        return {0.95, 0.80, 0.15};
    case HandleKind::velocity:
        return {0.10, 0.60, 0.25};
    case HandleKind::spin:
        return {0.10, 0.65, 0.65};
    case HandleKind::forceBase:
    case HandleKind::forceHead:
        return {0.85, 0.15, 0.15};
    case HandleKind::torqueBase:
    case HandleKind::torqueHead:
        return {0.75, 0.15, 0.60};
    case HandleKind::linkEnd:
    case HandleKind::ropeLength:
        return {0.15, 0.35, 0.85};
    case HandleKind::jointPoint:
    case HandleKind::jointAxis:
    case HandleKind::jointLimit:
        return jointColor;
    case HandleKind::lightPlace:
    case HandleKind::lightDirection:
        return {0.98, 0.90, 0.35};
    case HandleKind::trajectoryPoint:
        break;
    }
    return {0.50, 0.30, 0.80};
}

double radiusOf(HandleKind kind) {
    switch (kind) {
    case HandleKind::position:
        return 6.5;
    case HandleKind::linkEnd:
    case HandleKind::jointAxis:
    case HandleKind::lightPlace:
    case HandleKind::trajectoryPoint:
        return 5;
    case HandleKind::jointPoint: // over its axis where that is seen end on
        return 4.5;
    default:
        return 4;
    }
}

bool shows(const Display& display, HandleKind kind) {
    switch (kind) {
    case HandleKind::position:
        return display.positionHandles;
    case HandleKind::orientation:
        return display.orientationHandles;
    case HandleKind::velocity:
        return display.velocityHandles;
    case HandleKind::spin:
        return display.spinHandles;
    case HandleKind::forceBase:
    case HandleKind::forceHead:
        return display.forceHandles;
    case HandleKind::torqueBase:
    case HandleKind::torqueHead:
        return display.torqueHandles;
    case HandleKind::linkEnd:
    case HandleKind::ropeLength:
        return display.linkHandles;
    case HandleKind::jointPoint:
    case HandleKind::jointAxis:
    case HandleKind::jointLimit:
        return display.jointHandles;
    case HandleKind::lightPlace:
    case HandleKind::lightDirection:
        return display.lightHandles;
    case HandleKind::trajectoryPoint:
        break;
    }
    return display.trajectories;
}

bool showsHandles(const Display& display) {
    return display.positionHandles || display.orientationHandles || display.velocityHandles ||
           display.spinHandles || display.forceHandles || display.torqueHandles ||
           display.linkHandles || display.jointHandles || display.lightHandles ||
           display.trajectories;
}

bool isJoint(HandleKind kind) {
    return kind == HandleKind::jointPoint || kind == HandleKind::jointAxis ||
           kind == HandleKind::jointLimit;
}

std::vector<Vector> pathOf(const scene::Trajectory& trajectory) {
    std::vector<Vector> path;
    for (const scene::BezierCurve& curve : trajectory.curves) {
        const int parts = curve.control.size() < 3 ? 1 : 24;
        for (int i = 0; i <= parts && !curve.control.empty(); ++i) {
            std::vector<Vector> points = curve.control; // de Casteljau
            const double s = static_cast<double>(i) / parts;
            for (std::size_t n = points.size() - 1; n > 0; --n)
                for (std::size_t j = 0; j < n; ++j)
                    points[j] = (1 - s) * points[j] + s * points[j + 1];
            path.push_back(points.front());
        }
    }
    return path;
}

} // namespace render

// The motion of an assembly of bodies on joints by a formulation of its own, to hold the engine
// against: coordinates of all bodies, conditions phi(t) = 0 whose derivatives Taylor series give,
// forces of joints by a complete orthogonal decomposition (so redundant conditions are no trouble),
// the classical Runge-Kutta method with a fixed step, and a projection of places and velocities
// after each step.
//
// usage: assembly_motion STEPS < ASSEMBLY
//
//     bodies N, then for each: mass, three moments of inertia (kg m^2, the body's axes), place (m),
//         attitude (quaternion w x y z), velocity (m/s), angular velocity (rad/s, the world's axes)
//     joints N, then for each: type, body, other (-1: the ground), point in the body's frame, point
//     in the
//         other's, axis in the body's frame, axis in the other's (as they agree at the start)
//     times N, then the times (s); gravity is (0, -9.81, 0)
//
// Prints for each time the places of all bodies, then how far one with half the steps ends from
// them.
#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;

// a + b s + c s^2 along a path.
struct Series {
    double a = 0, b = 0, c = 0;
};
Series operator+(Series p, Series q) { return {p.a + q.a, p.b + q.b, p.c + q.c}; }
Series operator-(Series p, Series q) { return {p.a - q.a, p.b - q.b, p.c - q.c}; }
Series operator*(Series p, Series q) {
    return {p.a * q.a, p.a * q.b + p.b * q.a, p.a * q.c + p.b * q.b + p.c * q.a};
}
using Vectors = std::array<Series, 3>;
Vectors operator-(const Vectors& p, const Vectors& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
Series dot(const Vectors& p, const Vectors& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Vectors series(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return {Series{a.x(), b.x(), c.x()}, Series{a.y(), b.y(), c.y()}, Series{a.z(), b.z(), c.z()}};
}

struct Body {
    double mass = 0;
    Vector3d inertia, place, velocity, spin;
    Quaterniond attitude;
};

struct Joint {
    std::string type;
    int one = 0, other = -1;
    Vector3d point1, point2, axis1, axis2;
    Quaterniond turned =
        Quaterniond::Identity(); // from the other's frame to the body's, at the start
    double length = 0;
};

// A body on its way: v and w are constant.
struct Path {
    Vector3d place = Vector3d::Zero(), v = Vector3d::Zero(), w = Vector3d::Zero();
    Quaterniond attitude = Quaterniond::Identity();

    [[nodiscard]] Vectors direction(const Vector3d& local) const {
        const Vector3d at = attitude * local;
        return series(at, w.cross(at), w.cross(w.cross(at)) / 2);
    }
    [[nodiscard]] Vectors point(const Vector3d& local) const {
        Vectors found = direction(local);
        for (int i = 0; i < 3; ++i) {
            found[i].a += place[i];
            found[i].b += v[i];
        }
        return found;
    }
};

std::array<Vector3d, 2> across(const Vector3d& axis) {
    const Vector3d first = axis.unitOrthogonal();
    return {first, axis.cross(first)};
}

// The conditions of one joint, all of them 0.
void conditions(const Joint& joint, const Path& one, const Path& other, std::vector<Series>& out) {
    const Vectors apart = one.point(joint.point1) - other.point(joint.point2);
    const auto meets = [&] { out.insert(out.end(), apart.begin(), apart.end()); };
    const auto parallel = [&] { // the axes
        for (const Vector3d& side : across(joint.axis2))
            out.push_back(dot(one.direction(joint.axis1), other.direction(side)));
    };
    const auto onAxis = [&] {
        for (const Vector3d& side : across(joint.axis2))
            out.push_back(dot(apart, other.direction(side)));
    };
    const auto unturned = [&] { // three axes of one against three of the other
        for (int i = 0; i < 3; ++i)
            out.push_back(dot(one.direction(joint.turned * Vector3d::Unit(i)),
                              other.direction(Vector3d::Unit((i + 1) % 3))));
    };
    if (joint.type == "ball")
        meets();
    else if (joint.type == "hinge")
        meets(), parallel();
    else if (joint.type == "fixed")
        meets(), unturned();
    else if (joint.type == "universal") {
        meets();
        out.push_back(dot(one.direction(joint.axis1), other.direction(joint.axis2)));
    } else if (joint.type == "cylindrical")
        onAxis(), parallel();
    else if (joint.type == "slider")
        onAxis(), unturned();
    else if (joint.type == "planar") {
        out.push_back(dot(apart, other.direction(joint.axis2)));
        parallel();
    } else if (joint.type == "distance")
        out.push_back(dot(apart, apart) - Series{joint.length * joint.length, 0, 0});
    else
        std::exit((std::fprintf(stderr, "assembly_motion: no type %s\n", joint.type.c_str()), 1));
}

struct Assembly {
    std::vector<Body> bodies;
    std::vector<Joint> joints;

    [[nodiscard]] Path path(int body, const VectorXd& twist) const {
        if (body < 0)
            return {};
        const Body& b = bodies[static_cast<std::size_t>(body)];
        return {b.place, twist.segment<3>(6 * body), twist.segment<3>(6 * body + 3), b.attitude};
    }
    [[nodiscard]] std::vector<Series> along(const VectorXd& twist) const {
        std::vector<Series> found;
        for (const Joint& joint : joints)
            conditions(joint, path(joint.one, twist), path(joint.other, twist), found);
        return found;
    }
    [[nodiscard]] VectorXd twist() const {
        VectorXd found(6 * size());
        for (int i = 0; i < size(); ++i)
            found.segment<6>(6 * i) << bodies[static_cast<std::size_t>(i)].velocity,
                bodies[static_cast<std::size_t>(i)].spin;
        return found;
    }
    [[nodiscard]] int size() const { return static_cast<int>(bodies.size()); }
    [[nodiscard]] MatrixXd jacobian() const {
        MatrixXd found(along(VectorXd::Zero(6 * size())).size(), 6 * size());
        for (int i = 0; i < 6 * size(); ++i) {
            const std::vector<Series> column = along(VectorXd::Unit(6 * size(), i));
            for (std::size_t row = 0; row < column.size(); ++row)
                found(static_cast<Eigen::Index>(row), i) = column[row].b;
        }
        return found;
    }
    // M^-1/2, so that the decomposition weighs bodies by their inertia.
    [[nodiscard]] MatrixXd root() const {
        MatrixXd found = MatrixXd::Zero(6 * size(), 6 * size());
        for (int i = 0; i < size(); ++i) {
            const Body& b = bodies[static_cast<std::size_t>(i)];
            const Matrix3d r = b.attitude.toRotationMatrix();
            found.block<3, 3>(6 * i, 6 * i) = Matrix3d::Identity() / std::sqrt(b.mass);
            found.block<3, 3>(6 * i + 3, 6 * i + 3) =
                r * b.inertia.cwiseSqrt().cwiseInverse().asDiagonal() * r.transpose();
        }
        return found;
    }
    // The least change of x, by inertia, after which J x = wanted.
    [[nodiscard]] VectorXd corrected(const VectorXd& x, const VectorXd& wanted) const {
        const MatrixXd j = jacobian(), w = root();
        if (j.rows() == 0)
            return x;
        Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
        solver.setThreshold(1e-9);
        solver.compute(j * w);
        return x + w * solver.solve(wanted - j * x);
    }
    [[nodiscard]] VectorXd acceleration() const {
        VectorXd free(6 * size());
        for (int i = 0; i < size(); ++i) {
            const Body& b = bodies[static_cast<std::size_t>(i)];
            const Vector3d w = b.attitude.conjugate() * b.spin;
            const Vector3d turn = -w.cross(b.inertia.cwiseProduct(w)).cwiseQuotient(b.inertia);
            free.segment<6>(6 * i) << Vector3d(0, -9.81, 0), b.attitude * turn;
        }
        const std::vector<Series> now = along(twist());
        VectorXd bend(now.size());
        for (std::size_t i = 0; i < now.size(); ++i)
            bend[static_cast<Eigen::Index>(i)] = -2 * now[i].c;
        return corrected(free, bend);
    }
    void shift(const VectorXd& by) { // each body's place and attitude
        for (int i = 0; i < size(); ++i) {
            Body& b = bodies[static_cast<std::size_t>(i)];
            b.place += by.segment<3>(6 * i);
            const Vector3d turn = by.segment<3>(6 * i + 3);
            const double angle = turn.norm();
            if (angle > 0)
                b.attitude = (Eigen::AngleAxisd(angle, turn / angle) * b.attitude).normalized();
        }
    }
    void setTwist(const VectorXd& to) {
        for (int i = 0; i < size(); ++i) {
            bodies[static_cast<std::size_t>(i)].velocity = to.segment<3>(6 * i);
            bodies[static_cast<std::size_t>(i)].spin = to.segment<3>(6 * i + 3);
        }
    }
    void project() {
        for (int i = 0; i < 3; ++i) {
            const std::vector<Series> off = along(VectorXd::Zero(6 * size()));
            VectorXd back(off.size());
            for (std::size_t row = 0; row < off.size(); ++row)
                back[static_cast<Eigen::Index>(row)] = -off[row].a;
            shift(corrected(VectorXd::Zero(6 * size()), back));
        }
        setTwist(corrected(twist(), VectorXd::Zero(jacobian().rows())));
    }
};

// Places and quaternions change linearly in their rates, so that the method sees one smooth
// equation.
struct Rate {
    VectorXd twist, acceleration;
    std::vector<Eigen::Vector4d> turning; // of the quaternions
};
Rate rate(const Assembly& at) {
    Rate found{at.twist(), at.acceleration(), {}};
    for (const Body& b : at.bodies)
        found.turning.push_back(
            (Quaterniond(0, b.spin.x() / 2, b.spin.y() / 2, b.spin.z() / 2) * b.attitude).coeffs());
    return found;
}
Assembly moved(Assembly from, const Rate& by, double h) {
    from.setTwist(from.twist() + h * by.acceleration);
    for (int i = 0; i < from.size(); ++i) {
        Body& b = from.bodies[static_cast<std::size_t>(i)];
        b.place += h * by.twist.segment<3>(6 * i);
        b.attitude.coeffs() += h * by.turning[static_cast<std::size_t>(i)];
    }
    return from;
}
Assembly normalized(Assembly from) {
    for (Body& b : from.bodies)
        b.attitude.normalize();
    return from;
}

Assembly stepped(const Assembly& from, double h) {
    const Rate a = rate(from), b = rate(normalized(moved(from, a, h / 2))),
               c = rate(normalized(moved(from, b, h / 2))), d = rate(normalized(moved(from, c, h)));
    Assembly to = moved(moved(moved(moved(from, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
    to = normalized(to);
    to.project();
    return to;
}

std::vector<Assembly> motion(Assembly at, const std::vector<double>& times, double step) {
    std::vector<Assembly> found;
    double now = 0;
    for (const double time : times) {
        const int count = std::max(1, static_cast<int>(std::lround((time - now) / step)));
        const double h = (time - now) / count;
        for (int i = 0; i < count; ++i)
            at = stepped(at, h);
        now = time;
        found.push_back(at);
    }
    return found;
}

Vector3d vector() {
    Vector3d v;
    std::cin >> v[0] >> v[1] >> v[2];
    return v;
}

Assembly read() {
    Assembly found;
    std::string word;
    std::size_t count = 0;
    std::cin >> word >> count;
    found.bodies.resize(count);
    for (Body& b : found.bodies) {
        std::cin >> b.mass;
        b.inertia = vector();
        b.place = vector();
        std::cin >> b.attitude.w() >> b.attitude.x() >> b.attitude.y() >> b.attitude.z();
        b.velocity = vector();
        b.spin = vector();
    }
    std::cin >> word >> count;
    found.joints.resize(count);
    for (Joint& joint : found.joints) {
        std::cin >> joint.type >> joint.one >> joint.other;
        joint.point1 = vector();
        joint.point2 = vector();
        joint.axis1 = vector().normalized();
        joint.axis2 = vector().normalized();
        const VectorXd still = VectorXd::Zero(6 * found.size());
        const Path one = found.path(joint.one, still), other = found.path(joint.other, still);
        joint.turned = one.attitude.conjugate() * other.attitude;
        const Vectors apart = one.point(joint.point1) - other.point(joint.point2);
        joint.length = std::sqrt(dot(apart, apart).a);
    }
    return found;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2)
        return std::fputs("usage: assembly_motion STEPS < ASSEMBLY\n", stderr), 2;
    const Assembly start = read();
    std::string word;
    std::size_t count = 0;
    std::cin >> word >> count;
    std::vector<double> times(count);
    for (double& time : times)
        std::cin >> time;
    if (!std::cin || count == 0)
        return std::fputs("assembly_motion: the assembly ends early\n", stderr), 1;
    const double step = times.back() / std::atof(argv[1]);
    const std::vector<Assembly> found = motion(start, times, step);
    const std::vector<Assembly> coarse = motion(start, times, 2 * step);
    for (std::size_t i = 0; i < count; ++i) {
        std::printf("%.17g", times[i]);
        double apart = 0;
        for (std::size_t k = 0; k < start.bodies.size(); ++k) {
            const Vector3d& at = found[i].bodies[k].place;
            std::printf(" %.17g %.17g %.17g", at.x(), at.y(), at.z());
            apart = std::max(apart, (at - coarse[i].bodies[k].place).norm());
        }
        std::printf(" %.3g\n", apart);
    }
    return 0;
}

// How do bodies in a plane move? An answer that shares nothing with the engine: Radau IIA with five
// stages (order 9) in long double, Newton with a new Jacobian for every stage and iteration, on a
// mesh that is refined until two motions agree.
//
//   body M I x y angle dx dy dangle      link A ox oy B px py K C    (B = -1: p is a place)
//   gravity gx gy                        times T1 T2 ...             (the last line)
//
// Standard input to standard output: one row for each time, x y angle for each body, after a row
// with the largest difference of the last two motions. Without scale: sizes are about 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Real = long double;
using Vector = std::vector<Real>;
constexpr std::size_t stages = 5;

struct Body {
    Real mass, inertia;
};

struct Link {
    std::size_t first;
    Real ox, oy;
    long second; // -1: a place
    Real px, py, stiffness, damping;
};

struct World {
    std::vector<Body> bodies;
    std::vector<Link> links;
    Real gx = 0, gy = 0;
    Vector start; // x y angle dx dy dangle of each body
    std::vector<Real> times;
};

World readWorld(std::istream& in) {
    World world;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string what;
        words >> what;
        if (what == "body") {
            Body body{};
            words >> body.mass >> body.inertia;
            world.bodies.push_back(body);
            for (Real value; words >> value;)
                world.start.push_back(value);
        } else if (what == "link") {
            Link l{};
            words >> l.first >> l.ox >> l.oy >> l.second >> l.px >> l.py >> l.stiffness >>
                l.damping;
            world.links.push_back(l);
        } else if (what == "gravity") {
            words >> world.gx >> world.gy;
        } else if (what == "times") {
            for (Real value; words >> value;)
                world.times.push_back(value);
        }
    }
    return world;
}

struct Point {
    Real x, y, dx, dy, armX, armY;
};

Point pointOf(const Vector& y, std::size_t body, Real ox, Real oy) {
    const Real* s = &y[6 * body];
    const Real c = std::cos(s[2]), n = std::sin(s[2]);
    const Real armX = c * ox - n * oy, armY = n * ox + c * oy;
    return {s[0] + armX, s[1] + armY, s[3] - s[5] * armY, s[4] + s[5] * armX, armX, armY};
}

void push(const World& world, Vector& f, std::size_t body, const Point& at, Real fx, Real fy) {
    f[6 * body + 3] += fx / world.bodies[body].mass;
    f[6 * body + 4] += fy / world.bodies[body].mass;
    f[6 * body + 5] += (at.armX * fy - at.armY * fx) / world.bodies[body].inertia;
}

Vector rates(const World& world, const Vector& y) {
    Vector f(y.size(), 0);
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
        for (std::size_t i = 0; i < 3; ++i)
            f[6 * b + i] = y[6 * b + 3 + i];
        f[6 * b + 3] = world.gx;
        f[6 * b + 4] = world.gy;
    }
    for (const Link& l : world.links) {
        const Point a = pointOf(y, l.first, l.ox, l.oy);
        const Point b = l.second < 0 ? Point{l.px, l.py, 0, 0, 0, 0}
                                     : pointOf(y, static_cast<std::size_t>(l.second), l.px, l.py);
        const Real fx = -l.stiffness * (a.x - b.x) - l.damping * (a.dx - b.dx);
        const Real fy = -l.stiffness * (a.y - b.y) - l.damping * (a.dy - b.dy);
        push(world, f, l.first, a, fx, fy);
        if (l.second >= 0)
            push(world, f, static_cast<std::size_t>(l.second), b, -fx, -fy);
    }
    return f;
}

// By columns, central differences.
std::vector<Vector> jacobian(const World& world, Vector y) {
    std::vector<Vector> columns;
    for (Real& value : y) {
        const Real was = value, step = 1e-7L * std::max<Real>(1, std::abs(was));
        value = was + step;
        Vector column = rates(world, y);
        value = was - step;
        const Vector low = rates(world, y);
        value = was;
        for (std::size_t i = 0; i < column.size(); ++i)
            column[i] = (column[i] - low[i]) / (2 * step);
        columns.push_back(std::move(column));
    }
    return columns;
}

// Solves in place, rows scaled and exchanged.
bool solve(std::vector<Vector>& m, Vector& b) {
    const std::size_t n = b.size();
    for (std::size_t i = 0; i < n; ++i) {
        Real largest = 0;
        for (const Real x : m[i])
            largest = std::max(largest, std::abs(x));
        for (Real& x : m[i])
            x /= largest;
        b[i] /= largest;
    }
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(m[i][k]) > std::abs(m[best][k]))
                best = i;
        if (m[best][k] == 0)
            return false;
        std::swap(m[k], m[best]);
        std::swap(b[k], b[best]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const Real factor = m[i][k] / m[k][k];
            if (factor == 0)
                continue;
            for (std::size_t j = k + 1; j < n; ++j)
                m[i][j] -= factor * m[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j)
            b[k] -= m[k][j] * b[j];
        b[k] /= m[k][k];
    }
    return true;
}

// The collocation method on the zeros of P_s - P_(s-1), P Legendre's polynomials on [0, 1].
struct Radau {
    std::array<Real, stages> c{};
    std::array<std::array<Real, stages>, stages> a{};

    Radau() {
        std::size_t found = 0;
        constexpr int cells = 1000;
        for (int i = 0; i < cells; ++i) {
            Real low = static_cast<Real>(i) / cells, high = static_cast<Real>(i + 1) / cells;
            if (i + 1 == cells || polynomial(low) * polynomial(high) > 0)
                continue;
            for (int n = 0; n < 80; ++n) {
                const Real middle = (low + high) / 2;
                (polynomial(low) * polynomial(middle) <= 0 ? high : low) = middle;
            }
            c[found++] = (low + high) / 2;
        }
        c[stages - 1] = 1;
        for (std::size_t i = 0; i < stages; ++i) { // sum_j a_ij c_j^m = c_i^(m+1)/(m+1)
            std::vector<Vector> powers(stages, Vector(stages));
            Vector row(stages);
            for (std::size_t m = 0; m < stages; ++m) {
                for (std::size_t j = 0; j < stages; ++j)
                    powers[m][j] = std::pow(c[j], static_cast<Real>(m));
                row[m] = std::pow(c[i], static_cast<Real>(m + 1)) / static_cast<Real>(m + 1);
            }
            solve(powers, row);
            std::copy(row.begin(), row.end(), a[i].begin());
        }
    }

    static Real polynomial(Real x) {
        Real before = 1, now = 2 * x - 1;
        for (std::size_t n = 1; n < stages; ++n) {
            const Real k = static_cast<Real>(n);
            const Real next = ((2 * k + 1) * (2 * x - 1) * now - k * before) / (k + 1);
            before = now;
            now = next;
        }
        return now - before;
    }
};

// One step; false when Newton does not settle.
bool step(const World& world, const Radau& radau, Real h, Vector& y) {
    const std::size_t n = y.size();
    const Vector slope = rates(world, y);
    std::vector<Vector> at(stages, y);
    for (std::size_t i = 0; i < stages; ++i)
        for (std::size_t b = 0; b < n; b += 6)
            for (std::size_t k = 0; k < 3; ++k)
                at[i][b + k] += h * radau.c[i] * slope[b + k];
    Real before = 1e30L;
    for (int iteration = 0; iteration < 40; ++iteration) {
        std::vector<Vector> f;
        std::vector<std::vector<Vector>> j;
        for (const Vector& stage : at) {
            f.push_back(rates(world, stage));
            j.push_back(jacobian(world, stage));
        }
        std::vector<Vector> matrix(stages * n, Vector(stages * n, 0));
        Vector residual(stages * n);
        for (std::size_t i = 0; i < stages; ++i)
            for (std::size_t r = 0; r < n; ++r) {
                Vector& row = matrix[i * n + r];
                Real sum = y[r] - at[i][r];
                for (std::size_t k = 0; k < stages; ++k) {
                    sum += h * radau.a[i][k] * f[k][r];
                    for (std::size_t s = 0; s < n; ++s)
                        row[k * n + s] = -h * radau.a[i][k] * j[k][s][r];
                }
                row[i * n + r] += 1;
                residual[i * n + r] = sum;
            }
        if (!solve(matrix, residual))
            return false;
        Real size = 0;
        for (std::size_t i = 0; i < stages; ++i)
            for (std::size_t r = 0; r < n; ++r) {
                at[i][r] += residual[i * n + r];
                if (r % 6 < 3) // positions; rounding in stiff velocities is larger
                    size = std::max(size, std::abs(residual[i * n + r]));
            }
        if (!std::isfinite(size))
            return false;
        if (size < 1e-16L || (size < 1e-12L && size > 0.3L * before)) {
            y = at.back();
            return true;
        }
        before = size;
    }
    return false;
}

// The fastest rate that links can have: a mesh begins well below its inverse.
Real fastest(const World& world) {
    Real rate = 1;
    for (const Link& l : world.links) {
        const Body& a = world.bodies[l.first];
        Real w = 1 / a.mass + (l.ox * l.ox + l.oy * l.oy) / a.inertia;
        if (l.second >= 0) {
            const Body& b = world.bodies[static_cast<std::size_t>(l.second)];
            w += 1 / b.mass + (l.px * l.px + l.py * l.py) / b.inertia;
        }
        rate = std::max({rate, l.damping * w, std::sqrt(l.stiffness * w)});
    }
    return rate;
}

// Empty when some step is too long.
std::vector<Vector> motion(const World& world, const Radau& radau, int fineness) {
    std::vector<Vector> rows;
    Vector y = world.start;
    const Real longest = 0.1L / fineness, growth = std::pow(2.0L, 1.0L / fineness);
    Real t = 0, h = 0.2L / (fastest(world) * fineness);
    for (const Real until : world.times) {
        while (t < until) {
            Real length = std::min(h, longest);
            const bool last = t + 1.01L * length >= until;
            length = last ? until - t : std::min(length, (until - t) / 2);
            if (!step(world, radau, length, y))
                return {};
            t = last ? until : t + length;
            h = std::min(h * growth, longest);
        }
        rows.push_back(y);
    }
    return rows;
}

Real difference(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    Real largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a[i].size(); ++k)
            if (k % 6 < 3)
                largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
    return largest;
}

} // namespace

int main() {
    const World world = readWorld(std::cin);
    const Radau radau;
    std::vector<Vector> before;
    for (int fineness = 2; fineness <= 128; fineness *= 2) {
        std::vector<Vector> rows = motion(world, radau, fineness);
        if (!rows.empty() && !before.empty()) {
            const Real apart = difference(rows, before);
            if (apart < 1e-10L) {
                std::printf("%.3Lg\n", apart);
                for (const Vector& row : rows) {
                    for (std::size_t b = 0; b < row.size(); b += 6)
                        std::printf("%.20Lg %.20Lg %.20Lg ", row[b], row[b + 1], row[b + 2]);
                    std::printf("\n");
                }
                return 0;
            }
        }
        before = std::move(rows);
    }
    std::fprintf(stderr, "truth: two motions never agreed\n");
    return 1;
}

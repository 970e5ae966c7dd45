#include "gas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double inner = 1 - gasRadius; // where centres are
constexpr double contact = 4 * gasRadius * gasRadius;
constexpr int nobody = -1;

} // namespace

std::vector<GasStart> gasOf(int perEdge) {
    std::mt19937_64 random(1);
    const auto uniform = [&] {
        return std::ldexp(static_cast<double>(random() >> 11), -52) - 1; // -1 to 1
    };
    std::vector<GasStart> balls;
    for (int i = 0; i < perEdge; ++i)
        for (int j = 0; j < perEdge; ++j)
            for (int k = 0; k < perEdge; ++k) {
                GasStart ball{};
                const int place[] = {i, j, k};
                for (std::size_t a = 0; a < 3; ++a) {
                    ball.position[a] = -1 + (place[a] + 0.5) * 2 / perEdge;
                    ball.velocity[a] = std::sqrt(3.0) * uniform();
                }
                balls.push_back(ball);
            }
    return balls;
}

Gas::Gas(const std::vector<GasStart>& balls, int cellsPerEdge)
    : cells_(cellsPerEdge), edge_(2 * inner / cellsPerEdge) {
    const std::size_t n = balls.size();
    while (leaves_ < n)
        leaves_ *= 2;
    const auto edge = static_cast<std::size_t>(cells_);
    first_.assign(edge * edge * edge, nobody);
    hitAt_.assign(n, infinity);
    crossAt_.assign(n, infinity);
    key_.assign(leaves_, infinity);
    partner_.assign(n, nobody);
    crossAxis_.assign(n, 0);
    winner_.assign(2 * leaves_, 0);
    for (std::size_t i = 0; i < leaves_; ++i)
        winner_[leaves_ + i] = static_cast<int>(i);
    for (const GasStart& start : balls) {
        Ball ball{};
        for (std::size_t a = 0; a < 3; ++a) {
            ball.x[a] = start.position[a];
            ball.v[a] = start.velocity[a];
            ball.cell[a] = std::clamp(static_cast<int>((ball.x[a] + inner) / edge_), 0, cells_ - 1);
        }
        balls_.push_back(ball);
        enter(static_cast<int>(balls_.size()) - 1);
    }
    for (int i = 0; i < static_cast<int>(n); ++i) {
        findCrossing(i);
        update(i);
    }
    for (int i = 0; i < static_cast<int>(n); ++i)
        seekEverywhere(i);
}

void Gas::advance(int i, double t) {
    Ball& ball = balls_[static_cast<std::size_t>(i)];
    const double dt = t - ball.t;
    for (int a = 0; a < 3; ++a)
        ball.x[a] += ball.v[a] * dt;
    ball.t = t;
}

void Gas::enter(int i) {
    Ball& ball = balls_[static_cast<std::size_t>(i)];
    int& first = first_[static_cast<std::size_t>(cellOf(ball.cell[0], ball.cell[1], ball.cell[2]))];
    ball.previous = nobody;
    ball.next = first;
    if (first != nobody)
        balls_[static_cast<std::size_t>(first)].previous = i;
    first = i;
}

void Gas::leave(int i) {
    const Ball& ball = balls_[static_cast<std::size_t>(i)];
    if (ball.previous == nobody)
        first_[static_cast<std::size_t>(cellOf(ball.cell[0], ball.cell[1], ball.cell[2]))] =
            ball.next;
    else
        balls_[static_cast<std::size_t>(ball.previous)].next = ball.next;
    if (ball.next != nobody)
        balls_[static_cast<std::size_t>(ball.next)].previous = ball.previous;
}

void Gas::findCrossing(int i) {
    const Ball& ball = balls_[static_cast<std::size_t>(i)];
    double least = infinity;
    int axis = 0;
    for (int a = 0; a < 3; ++a) {
        const int face = ball.cell[a] + (ball.v[a] > 0 ? 1 : 0);
        const double where = face == cells_ ? inner : -inner + face * edge_;
        const double dt = ball.v[a] == 0 ? infinity : (where - ball.x[a]) / ball.v[a];
        if (dt < least) {
            least = dt;
            axis = a;
        }
    }
    crossAt_[static_cast<std::size_t>(i)] = ball.t + std::max(least, 0.0);
    crossAxis_[static_cast<std::size_t>(i)] = axis;
}

// Ball i stands at its own time; the others are brought there.
void Gas::consider(int i, int cell, int& best, double& soonest) const {
    const Ball& a = balls_[static_cast<std::size_t>(i)];
    for (int j = first_[static_cast<std::size_t>(cell)]; j != nobody;) {
        const Ball& b = balls_[static_cast<std::size_t>(j)];
        const double dt = a.t - b.t;
        const double dx = a.x[0] - b.x[0] - b.v[0] * dt, dy = a.x[1] - b.x[1] - b.v[1] * dt,
                     dz = a.x[2] - b.x[2] - b.v[2] * dt;
        const double ux = a.v[0] - b.v[0], uy = a.v[1] - b.v[1], uz = a.v[2] - b.v[2];
        const double approach = dx * ux + dy * uy + dz * uz;
        if (approach < 0 && i != j) {
            const double uu = ux * ux + uy * uy + uz * uz;
            const double gap = dx * dx + dy * dy + dz * dz - contact;
            const double discriminant = approach * approach - uu * gap;
            if (discriminant > 0) {
                const double t = a.t + std::max(gap, 0.0) / (std::sqrt(discriminant) - approach);
                if (t < soonest && t < hitAt_[static_cast<std::size_t>(j)]) {
                    soonest = t;
                    best = j;
                }
            }
        }
        j = b.next;
    }
}

void Gas::seek(int i, const int (&low)[3], const int (&high)[3]) {
    int best = nobody;
    double soonest = hitAt_[static_cast<std::size_t>(i)];
    for (int a = std::max(low[0], 0); a <= std::min(high[0], cells_ - 1); ++a)
        for (int b = std::max(low[1], 0); b <= std::min(high[1], cells_ - 1); ++b)
            for (int c = std::max(low[2], 0); c <= std::min(high[2], cells_ - 1); ++c)
                consider(i, cellOf(a, b, c), best, soonest);
    if (best != nobody)
        pair(i, best, soonest);
    update(i);
}

void Gas::seekEverywhere(int i) {
    const Ball& ball = balls_[static_cast<std::size_t>(i)];
    seek(i, {ball.cell[0] - 1, ball.cell[1] - 1, ball.cell[2] - 1},
         {ball.cell[0] + 1, ball.cell[1] + 1, ball.cell[2] + 1});
}

// Who was to hit this ball will find nobody there, and looks for another then.
void Gas::release(int i) {
    int& partner = partner_[static_cast<std::size_t>(i)];
    if (partner != nobody)
        partner_[static_cast<std::size_t>(partner)] = nobody;
    partner = nobody;
}

void Gas::pair(int i, int j, double t) {
    release(i);
    release(j);
    partner_[static_cast<std::size_t>(i)] = j;
    partner_[static_cast<std::size_t>(j)] = i;
    hitAt_[static_cast<std::size_t>(i)] = hitAt_[static_cast<std::size_t>(j)] = t;
    update(j);
}

void Gas::update(int i) {
    const auto leaf = static_cast<std::size_t>(i);
    key_[leaf] = std::min(hitAt_[leaf], crossAt_[leaf]);
    for (std::size_t node = (leaf + leaves_) / 2; node > 0; node /= 2) {
        const int a = winner_[2 * node], b = winner_[2 * node + 1];
        winner_[node] =
            key_[static_cast<std::size_t>(a)] <= key_[static_cast<std::size_t>(b)] ? a : b;
    }
}

void Gas::collide(int i) {
    const double t = hitAt_[static_cast<std::size_t>(i)];
    const int j = partner_[static_cast<std::size_t>(i)];
    hitAt_[static_cast<std::size_t>(i)] = infinity;
    advance(i, t);
    if (j == nobody) {
        seekEverywhere(i);
        findCrossing(i);
        update(i);
        return;
    }
    ++hits_;
    advance(j, t);
    Ball& a = balls_[static_cast<std::size_t>(i)];
    Ball& b = balls_[static_cast<std::size_t>(j)];
    double n[3], along = 0, square = 0;
    for (int k = 0; k < 3; ++k) {
        n[k] = a.x[k] - b.x[k];
        along += n[k] * (a.v[k] - b.v[k]);
        square += n[k] * n[k];
    }
    for (int k = 0; k < 3; ++k) {
        const double change = n[k] * along / square;
        a.v[k] -= change;
        b.v[k] += change;
    }
    hitAt_[static_cast<std::size_t>(j)] = infinity;
    partner_[static_cast<std::size_t>(i)] = partner_[static_cast<std::size_t>(j)] = nobody;
    for (const int ball : {i, j}) {
        findCrossing(ball);
        seekEverywhere(ball);
    }
}

void Gas::cross(int i) {
    const int axis = crossAxis_[static_cast<std::size_t>(i)];
    advance(i, crossAt_[static_cast<std::size_t>(i)]);
    Ball& ball = balls_[static_cast<std::size_t>(i)];
    const int towards = ball.v[axis] > 0 ? 1 : -1;
    const int cell = ball.cell[axis] + towards;
    if (cell < 0 || cell >= cells_) {
        ++wallHits_;
        ball.v[axis] = -ball.v[axis];
        release(i);
        hitAt_[static_cast<std::size_t>(i)] = infinity;
        findCrossing(i);
        seekEverywhere(i);
        return;
    }
    ++crossings_;
    leave(i);
    ball.cell[axis] = cell;
    enter(i);
    findCrossing(i);
    int low[3], high[3];
    for (int a = 0; a < 3; ++a) {
        low[a] = ball.cell[a] - 1;
        high[a] = ball.cell[a] + 1;
    }
    low[axis] = high[axis] = cell + towards; // only what is new
    seek(i, low, high);
}

void Gas::runTo(double time) {
    for (;;) {
        const int i = winner_[1];
        if (!(key_[static_cast<std::size_t>(i)] <= time))
            return;
        if (hitAt_[static_cast<std::size_t>(i)] <= crossAt_[static_cast<std::size_t>(i)])
            collide(i);
        else
            cross(i);
    }
}

std::vector<std::array<double, 3>> Gas::positions(double time) const {
    std::vector<std::array<double, 3>> all;
    for (const Ball& ball : balls_) {
        const double dt = time - ball.t;
        all.push_back(
            {ball.x[0] + ball.v[0] * dt, ball.x[1] + ball.v[1] * dt, ball.x[2] + ball.v[2] * dt});
    }
    return all;
}

double Gas::energy() const {
    double sum = 0;
    for (const Ball& ball : balls_)
        for (const double v : ball.v)
            sum += v * v / 2;
    return sum;
}

double medianDistance(std::vector<std::array<double, 3>> a,
                      const std::vector<std::array<double, 3>>& b) {
    std::vector<double> distances;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
        distances.push_back(std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]));
    std::ranges::nth_element(distances,
                             distances.begin() + static_cast<long>(distances.size() / 2));
    return distances[distances.size() / 2];
}

} // namespace bench

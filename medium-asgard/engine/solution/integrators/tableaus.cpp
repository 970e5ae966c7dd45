// The tables of the explicit methods. The numbers are the methods' definitions (Hairer, Norsett and
// Wanner, Solving ODEs I); tests check their order conditions and confirm each order by
// convergence.
#include "integrators/dop853.h"
#include "integrators/extrapolation.h"
#include "integrators/tableau.h"

#include <algorithm>
#include <span>
#include <string_view>

namespace solution {

namespace {

std::vector<double> expand(std::span<const dop853::Weight> row, std::size_t columns) {
    std::vector<double> result(columns, 0.0);
    for (const auto& [stage, value] : row)
        result[stage - 1] = value;
    return result;
}

// Hairer's continuous extension is written with s and 1-s alternating; rows d4 to d7.
const std::vector<dop853::Row<12>> dop853Extension = {
    {{{1, -0.84289382761090128651353491142e+01},
      {6, 0.56671495351937776962531783590},
      {7, -0.30689499459498916912797304727e+01},
      {8, 0.23846676565120698287728149680e+01},
      {9, 0.21170345824450282767155149946e+01},
      {10, -0.87139158377797299206789907490},
      {11, 0.22404374302607882758541771650e+01},
      {12, 0.63157877876946881815570249290},
      {13, -0.88990336451333310820698117400e-01},
      {14, 0.18148505520854727256656404962e+02},
      {15, -0.91946323924783554000451984436e+01},
      {16, -0.44360363875948939664310572000e+01}}},
    {{{1, 0.10427508642579134603413151009e+02},
      {6, 0.24228349177525818288430175319e+03},
      {7, 0.16520045171727028198505394887e+03},
      {8, -0.37454675472269020279518312152e+03},
      {9, -0.22113666853125306036270938578e+02},
      {10, 0.77334326684722638389603898808e+01},
      {11, -0.30674084731089398182061213626e+02},
      {12, -0.93321305264302278729567221706e+01},
      {13, 0.15697238121770843886131091075e+02},
      {14, -0.31139403219565177677282850411e+02},
      {15, -0.93529243588444783865713862664e+01},
      {16, 0.35816841486394083752465898540e+02}}},
    {{{1, 0.19985053242002433820987653617e+02},
      {6, -0.38703730874935176555105901742e+03},
      {7, -0.18917813819516756882830838328e+03},
      {8, 0.52780815920542364900561016686e+03},
      {9, -0.11573902539959630126141871134e+02},
      {10, 0.68812326946963000169666922661e+01},
      {11, -0.10006050966910838403183860980e+01},
      {12, 0.77771377980534432092869265740},
      {13, -0.27782057523535084065932004339e+01},
      {14, -0.60196695231264120758267380846e+02},
      {15, 0.84320405506677161018159903784e+02},
      {16, 0.11992291136182789328035130030e+02}}},
    {{{1, -0.25693933462703749003312586129e+02},
      {6, -0.15418974869023643374053993627e+03},
      {7, -0.23152937917604549567536039109e+03},
      {8, 0.35763911791061412378285349910e+03},
      {9, 0.93405324183624310003907691704e+02},
      {10, -0.37458323136451633156875139351e+02},
      {11, 0.10409964950896230045147246184e+03},
      {12, 0.29840293426660503123344363579e+02},
      {13, -0.43533456590011143754432175058e+02},
      {14, 0.96324553959188282948394950600e+02},
      {15, -0.39177261675615439165231486172e+02},
      {16, -0.14972683625798562581422125276e+03}}}};

// y + s(r1 + (1-s)(r2 + s(r3 + (1-s)(r4 + s(r5 + (1-s)(r6 + s r7)))))), with r1 = dy, r2 = k1 - dy,
// r3 = 2 dy - k1 - k13, r4..r7 the extension, all over h: multiplied out for each stage.
std::vector<std::vector<double>> dop853Dense(const std::vector<double>& b) {
    std::vector<std::vector<double>> result;
    for (std::size_t stage = 0; stage < 16; ++stage) {
        const double weight = stage < b.size() ? b[stage] : 0;
        const double first = stage == 0, last = stage == 12;
        std::vector<double> r = {weight, first - weight, 2 * weight - first - last};
        for (const auto& row : dop853Extension)
            r.push_back(expand(row, 16)[stage]);
        std::vector<double> p = {0}; // from inside out
        for (std::size_t i = r.size(); i-- > 0;) {
            p[0] += r[i];
            std::vector<double> next(p.size() + 1, 0.0);
            const bool timesS = i % 2 == 0;
            for (std::size_t k = 0; k < p.size(); ++k) {
                next[k] += timesS ? 0 : p[k];
                next[k + 1] += timesS ? p[k] : -p[k];
            }
            p = std::move(next);
        }
        result.emplace_back(p.begin() + 1, p.end());
    }
    return result;
}

Tableau makeDop853() {
    Tableau t{.name = "dop853",
              .order = 8,
              .stages = dop853::stages,
              .c = {dop853::nodes.begin(), dop853::nodes.end()}};
    std::apply([&t](const auto&... row) { (t.a.push_back(expand(row, t.a.size())), ...); },
               dop853::rows);
    t.error = expand(dop853::error, 13);
    t.secondError = expand(dop853::secondError, 13);
    t.dense = dop853Dense(expand(dop853::weights, 13));
    t.stiffStage = dop853::stiffStage;
    t.checkStages = {9, 10}; // at 0.6 and 6/7
    t.stabilityLimit = 6.1;
    return t;
}

Tableau makeDopri5() {
    Tableau t{.name = "dopri5", .order = 5, .stages = 6, .c = {0, 0.2, 0.3, 0.8, 8.0 / 9, 1, 1}};
    t.a = {{},
           {1.0 / 5},
           {3.0 / 40, 9.0 / 40},
           {44.0 / 45, -56.0 / 15, 32.0 / 9},
           {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
           {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
           {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    t.error = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
               -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
    // Shampine's extension of order 4: d is its extra direction on s^2 (1-s)^2.
    const double d[] = {-12715105075.0 / 11282082432,  0,
                        87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
                        701980252875.0 / 199316789632, -1453857185.0 / 822651844,
                        69997945.0 / 29380423};
    for (std::size_t i = 0; i < 7; ++i) {
        const double b = i < 6 ? t.a[6][i] : 0, first = i == 0, last = i == 6;
        t.dense.push_back(
            {first, 3 * b - 2 * first - last + d[i], first + last - 2 * b - 2 * d[i], d[i]});
    }
    t.stiffStage = 5;
    t.stabilityLimit = 3.25;
    return t;
}

// Tsitouras 2011 (Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying
// assumption), with its extension of order 4.
Tableau makeTsit5() {
    Tableau t{.name = "tsit5",
              .order = 5,
              .stages = 6,
              .c = {0, 0.161, 0.327, 0.9, 0.9800255409045097, 1, 1}};
    t.a = {{},
           {0.161},
           {-0.008480655492356989, 0.335480655492357},
           {2.8971530571054935, -6.359448489975075, 4.3622954328695815},
           {5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525},
           {5.86145544294642, -12.92096931784711, 8.159367898576159, -0.071584973281401,
            -0.028269050394068383},
           {0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.290069515436081,
            2.324710524099774}};
    t.error = {-0.00178001105222577714,
               -0.0008164344596567469,
               0.007880878010261995,
               -0.1447110071732629,
               0.5823571654525552,
               -0.45808210592918697,
               1.0 / 66};
    t.dense = {{1, -2.763706197274826, 2.9132554618219126, -1.0530884977290216},
               {0, 0.1317, -0.2234, 0.1017},
               {0, 3.9302962368947516, -5.941033872131505, 2.490627285651253},
               {0, -12.411077166933676, 30.33818863028232, -16.548102889244902},
               {0, 37.50931341651104, -88.1789048947664, 47.37952196281928},
               {0, -27.896526289197286, 65.09189467479366, -34.87065786149661},
               {0, 1.5, -4, 2.5}};
    t.stiffStage = 5;
    t.stabilityLimit = 3.507;
    return t;
}

// Without an error estimate; dense output is the cubic through both ends.
Tableau makeRk4() {
    Tableau t{.name = "rk4", .order = 4, .stages = 4, .c = {0, 0.5, 0.5, 1, 1}};
    t.a = {{}, {0.5}, {0, 0.5}, {0, 0, 1}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};
    return t;
}

Tableau makeForwardEuler() {
    Tableau t{.name = "forward-euler", .order = 1, .stages = 1, .c = {0, 1}};
    t.a = {{}, {1}};
    return t;
}

} // namespace

const Tableau* tableauNamed(const std::string& name) {
    static const std::vector<Tableau> tableaus = {
        finished(makeDop853()), finished(makeDopri5()),       finished(makeTsit5()),
        finished(makeRk4()),    finished(makeForwardEuler()), finished(makeExtrapolation())};
    const auto found = std::find_if(tableaus.begin(), tableaus.end(),
                                    [&](const Tableau& t) { return name == t.name; });
    return found == tableaus.end() ? nullptr : &*found;
}

} // namespace solution

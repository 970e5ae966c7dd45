// Runs the random trials of geometry and collision in any number; README.md says how.

#include "collision/encounter_trials.h"
#include "collision/separation_trials.h"
#include "geometry/hull_trials.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

struct Tally {
    std::uint64_t faults = 0;

    void note(std::uint64_t which, const std::string& fault) {
        if (fault.empty())
            return;
        ++faults;
        std::printf("case %llu: %s\n", static_cast<unsigned long long>(which), fault.c_str());
    }
};

std::uint64_t runHulls(std::uint64_t count, std::mt19937_64& random) {
    Tally tally;
    std::uint64_t solids = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto points = geometry::drawPoints(random);
        const auto result = geometry::convexHull(points);
        solids += std::holds_alternative<geometry::Hull>(result);
        tally.note(i, geometry::faultOf(points, result));
    }
    std::printf("hulls: %llu sets, %llu solids, the others refused, %llu faults\n",
                static_cast<unsigned long long>(count), static_cast<unsigned long long>(solids),
                static_cast<unsigned long long>(tally.faults));
    return tally.faults;
}

std::uint64_t runPairs(std::uint64_t count, std::mt19937_64& random) {
    Tally tally;
    for (std::uint64_t i = 0; i < count; ++i)
        tally.note(i, collision::separationFault(collision::drawPair(random)));
    std::printf("pairs: %llu, %llu faults\n", static_cast<unsigned long long>(count),
                static_cast<unsigned long long>(tally.faults));
    return tally.faults;
}

std::uint64_t runEncounters(std::uint64_t count, std::mt19937_64& random, bool areCurved) {
    Tally tally;
    std::uint64_t hits = 0;
    std::size_t most = 0, all = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto result = collision::checkMeeting(areCurved ? collision::drawCurvedMeeting(random)
                                                              : collision::drawMeeting(random));
        tally.note(i, result.fault);
        hits += result.hit;
        all += result.evaluations;
        most = std::max(most, result.evaluations);
    }
    std::printf("encounters: %llu, %llu hits, %llu faults; gaps computed: %.1f on average, at most "
                "%zu\n",
                static_cast<unsigned long long>(count), static_cast<unsigned long long>(hits),
                static_cast<unsigned long long>(tally.faults),
                static_cast<double>(all) / static_cast<double>(count), most);
    return tally.faults;
}

} // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    if (argc < 3 || argc > 4 ||
        (what != "hulls" && what != "pairs" && what != "encounters" && what != "curved")) {
        std::fprintf(stderr,
                     "usage: geometry_endurance hulls|pairs|encounters|curved COUNT [SEED]\n");
        return 2;
    }
    const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
    std::mt19937_64 random(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
    const std::uint64_t faults = what == "hulls"   ? runHulls(count, random)
                                 : what == "pairs" ? runPairs(count, random)
                                                   : runEncounters(count, random, what == "curved");
    return faults ? 1 : 0;
}

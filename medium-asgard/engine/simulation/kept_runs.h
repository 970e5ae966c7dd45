// The runs that the search for an accuracy makes, for when the motion is wanted for longer or for
// less long.
//
// The search asks for its runs in an order that the motion decides. When it is repeated to another
// finish, the runs that it asked for before are taken further, or are read up to the new finish. A
// body that it would have at another tolerance now, or in a run that was not made then, is not in
// order any more: it is marked, the search goes on with what there is, and what it says of that
// body is not used.
#pragma once

#include "simulation/open_run.h"

#include <array>
#include <limits>

namespace simulation {

class KeptRuns {
public:
    enum class Keep { no, yes }; // no: a run is forgotten as soon as it was made
    // Runs that together take more than `most` bytes are all forgotten, and none is kept any more.
    explicit KeptRuns(Keep keep, std::size_t most = std::numeric_limits<std::size_t>::max())
        : keep_(keep), most_(most) {}

    // Before each search.
    void begin(std::size_t bodies);
    enum class Kind { compared, rougher, nudged, proving };
    static constexpr std::size_t kinds = 4;
    // The next run of this kind; none when the search before made no such run, or all is marked.
    // Islands that `again` does not mark, whose tolerances are the same as in the run before, are
    // taken from it where nothing hit anything.
    struct Base {
        const Run& before;
        std::vector<bool> again;
    };
    [[nodiscard]] std::optional<Run> next(const Problem& problem, Kind kind,
                                          const std::vector<double>& tolerances,
                                          const Observer& observer,
                                          const std::optional<Base>& base = {});
    void mark(std::size_t body) { marked_[body] = true; }
    [[nodiscard]] const std::vector<bool>& marked() const { return marked_; }
    [[nodiscard]] std::size_t bytes() const; // of all that they hold
    // They were too large: this cannot be searched again.
    [[nodiscard]] bool areForgotten() const { return areForgotten_; }

private:
    [[nodiscard]] std::unique_ptr<OpenRun> made(const Problem& problem, Kind kind,
                                                const std::vector<double>& tolerances,
                                                const std::optional<Base>& base) const;
    // All that moves is marked.
    [[nodiscard]] bool saysNothing(const Problem& problem) const;
    void forget();

    Keep keep_;
    std::size_t most_;
    bool isRepeated_ = false, areForgotten_ = false;
    std::array<std::vector<std::unique_ptr<OpenRun>>, kinds> runs_; // by kind
    std::array<std::size_t, kinds> asked_{};
    std::vector<bool> marked_; // by body
};

} // namespace simulation

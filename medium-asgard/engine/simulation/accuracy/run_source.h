// The runs that the search for an accuracy asks for, one after another.
//
// FreshRuns makes each and keeps none. Another source may have kept the runs of an earlier search,
// and have none that was not made then (kept_runs.h): the search goes on with what there is.
#pragma once

#include "run/open_run.h"

#include <optional>
#include <vector>

namespace simulation {

class RunSource {
public:
    // What the run is for.
    enum class Kind { compared, rougher, nudged, proving };
    static constexpr std::size_t kinds = 4;
    // Islands that `again` does not mark, whose tolerances are the same as in the run before, are
    // taken from it where nothing hit anything.
    struct Base {
        const Run& before;
        std::vector<bool> again;
    };
    struct Wanted {
        Kind kind = Kind::compared;
        const std::vector<double>& tolerances; // by body
        std::vector<bool> concerned = {};      // by body: about whom it is to tell; empty: all
        std::optional<Base> base = {};
    };

    virtual ~RunSource() = default;
    // Before each search.
    virtual void begin(std::size_t bodies) = 0;
    // None: there is no such run, and the search says nothing of those whom it concerns.
    [[nodiscard]] virtual std::optional<Run> next(const Problem& problem, const Wanted& wanted,
                                                  const Observer& observer) = 0;
};

class FreshRuns final : public RunSource {
public:
    void begin(std::size_t bodies) override { (void)bodies; }
    // Always a run.
    [[nodiscard]] std::optional<Run> next(const Problem& problem, const Wanted& wanted,
                                          const Observer& observer) override;
};

// The run that is wanted, before it is solved. The problem must outlive it.
[[nodiscard]] std::unique_ptr<OpenRun> openRun(const Problem& problem,
                                               const RunSource::Wanted& wanted, OpenRun::Use use);

} // namespace simulation

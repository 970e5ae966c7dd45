// The runs that the search for an accuracy asks for, one after another.
//
// FreshRuns makes each and keeps none. Another source may have kept the runs of an earlier search,
// and have none that was not made then (kept_runs.h): the search goes on with what there is.
//
// Most searches compare two runs at least, and know the tolerances of the second beforehand. A
// source solves the one that is expected on a thread of its own, beside the one that is asked for,
// if the options allow two.
#pragma once

#include "accuracy/run_ahead.h"

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
    // A run that takes nothing may be wanted at these tolerances next, and not what was expected
    // before.
    void expect(const Problem& problem, const std::vector<double>& tolerances);
    [[nodiscard]] bool expects(const std::vector<double>& tolerances) const {
        return expected_ && expected_->tolerances() == tolerances;
    }
    void expectNothing() { expected_.reset(); }
    // Asked every now and then while another run is solved: has that taken long enough to begin?
    void beginExpected();
    // None: there is no such run, and the search says nothing of those whom it concerns.
    [[nodiscard]] virtual std::optional<Run> next(const Problem& problem, const Wanted& wanted,
                                                  const Observer& observer) = 0;

protected:
    explicit RunSource(OpenRun::Use use = OpenRun::Use::once) : use_(use) {}
    // The run that is wanted: solved if it was expected, else not begun. The problem must outlive
    // it.
    [[nodiscard]] std::unique_ptr<OpenRun> open(const Problem& problem, const Wanted& wanted,
                                                const Observer& observer);
    [[nodiscard]] virtual bool makesRuns() const { return true; } // or has them

private:
    OpenRun::Use use_;
    std::unique_ptr<RunAhead> expected_;
    bool isBeside_ = false; // the next run is the one beside which it is solved
};

class FreshRuns final : public RunSource {
public:
    void begin(std::size_t bodies) override { (void)bodies; }
    // Always a run.
    [[nodiscard]] std::optional<Run> next(const Problem& problem, const Wanted& wanted,
                                          const Observer& observer) override;
};

} // namespace simulation

// The runs that the search for an accuracy makes, for when the motion is wanted for longer or for
// less long.
//
// The search asks for its runs in an order that the motion decides. When it is repeated to another
// finish, the runs that it asked for before are taken further, or are read up to the new finish. A
// body that it would have at another tolerance now, or that a run which was not made then concerns,
// is not in order any more: it is marked, the search goes on with what there is, and what it says
// of that body is not used.
#pragma once

#include "accuracy/run_source.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace simulation {

class KeptRuns final : public RunSource {
public:
    // Runs that together take more than `most` bytes are all forgotten, and none is kept any more.
    explicit KeptRuns(std::size_t most) : RunSource(OpenRun::Use::again), most_(most) {}

    void begin(std::size_t bodies) override;
    // The next run of this kind; none when the search before made no such run, or all is marked.
    [[nodiscard]] std::optional<Run> next(const Problem& problem, const Wanted& wanted,
                                          const Observer& observer) override;
    [[nodiscard]] const std::vector<bool>& marked() const { return marked_; } // by body
    [[nodiscard]] std::size_t bytes() const; // of all that they hold
    // They were too large: this cannot be searched again.
    [[nodiscard]] bool areForgotten() const { return areForgotten_; }

private:
    [[nodiscard]] bool makesRuns() const override { return !isRepeated_ && !areForgotten_; }
    [[nodiscard]] std::optional<Run> keptRun(const Problem& problem, const Wanted& wanted,
                                             const Observer& observer);
    // Whose run is another one than is wanted now.
    void markOthers(const OpenRun& open, const Wanted& wanted);
    // All that moves is marked.
    [[nodiscard]] bool saysNothing(const Problem& problem) const;
    void forget();

    std::size_t most_;
    bool isRepeated_ = false, areForgotten_ = false;
    std::array<std::vector<std::unique_ptr<OpenRun>>, kinds> runs_; // by kind
    std::array<std::size_t, kinds> asked_{};
    std::vector<bool> marked_; // by body
};

} // namespace simulation

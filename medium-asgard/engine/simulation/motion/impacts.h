// The list of impacts, in order of time.
//
// A list shares what it holds: copies cost little, any thread may read them, and a record that goes
// on changes none of those that were taken of it.
#pragma once

#include "motion/motion.h"

#include <memory>
#include <utility>
#include <vector>

namespace simulation {

class Impacts {
public:
    Impacts() = default;
    explicit Impacts(std::vector<Impact> list)
        : all_(std::make_shared<const std::vector<Impact>>(std::move(list))) {}

    [[nodiscard]] std::size_t size() const { return all_->size(); }
    [[nodiscard]] bool empty() const { return all_->empty(); }
    [[nodiscard]] const std::vector<Impact>& all() const { return *all_; }
    [[nodiscard]] auto begin() const { return all_->begin(); }
    [[nodiscard]] auto end() const { return all_->end(); }
    // No two at once.
    [[nodiscard]] bool isStrictlyOrdered() const;

private:
    std::shared_ptr<const std::vector<Impact>> all_ = std::make_shared<const std::vector<Impact>>();
};

// Of impacts as they are found. Most are found at their own time; hops that were cut off count
// later.
class ImpactRecord {
public:
    void add(const Impact& impact, double found);
    // The impacts found until then.
    [[nodiscard]] Impacts upTo(double until) const;
    [[nodiscard]] bool haveMet(const std::pair<std::size_t, std::size_t>& pair, double since) const;
    // Of what was hit before t: as it is kept here, and as an Impact for who reads it.
    [[nodiscard]] std::size_t bytesBefore(double t) const;

private:
    struct Recorded {
        Impact impact;
        double found = 0;
    };
    std::vector<Recorded> recorded_; // in order of their own times
};

} // namespace simulation

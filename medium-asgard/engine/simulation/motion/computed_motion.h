// A Motion over solved histories: of one solution of the scene, or of parts that were solved apart.
#pragma once

#include "motion/body_motion.h"
#include "motion/contact_log.h"
#include "motion/impacts.h"
#include "motion/motion.h"
#include "solution/condition_reader.h"

#include <map>
#include <memory>

namespace simulation {

class ComputedMotion final : public Motion {
public:
    struct Part { // bodies solved together; not all of them need be shown
        std::shared_ptr<const std::vector<BodyRecord>> bodies;
        std::shared_ptr<const solution::Histories> histories;
        // Of bodies on joints or in contact; none: there are none.
        std::shared_ptr<const solution::ConditionReader> conditions = {};
        std::shared_ptr<const expression::EquationSet> equations = {}; // of the same
        ContactLog contacts = {};
    };
    struct Place { // of a body of the scene
        std::size_t part = 0, body = 0;
    };
    struct Contents {
        double start = 0, finish = 0;
        bool draft = false;
        std::vector<Part> parts;
        std::vector<Place> places;         // by body
        std::map<std::size_t, Stop> stops; // by body
        Impacts impacts;
        std::vector<std::string> notes;
        std::optional<double> errorEstimate, predictableUntil;
    };
    explicit ComputedMotion(Contents contents);

    [[nodiscard]] const Contents& contents() const { return c_; }
    // Of a motion that was solved as one.
    [[nodiscard]] const solution::Histories& histories() const;
    // Where a body's unknowns are: from record.firstUnknown on in those histories.
    struct Solution {
        const BodyRecord& record;
        const solution::Histories& histories;
    };
    [[nodiscard]] Solution of(std::size_t body) const;
    // Of an unknown of that part of the motion which the body belongs to.
    [[nodiscard]] double valueOf(std::size_t body, std::size_t unknown, double time) const;
    // A reading of the equations (expression/equations.h) of that part; 0 where it has none.
    [[nodiscard]] double readingOf(std::size_t body, std::string_view name, double time) const;

    [[nodiscard]] double start() const override { return c_.start; }
    [[nodiscard]] double finish() const override { return c_.finish; }
    [[nodiscard]] double computed() const override { return computed_; }
    [[nodiscard]] bool draft() const override { return c_.draft; }
    [[nodiscard]] std::size_t bodies() const override { return c_.places.size(); }
    [[nodiscard]] BodyState at(std::size_t body, double time) const override;
    [[nodiscard]] std::optional<Stop> stop(std::size_t body) const override;
    [[nodiscard]] Vector centroid(std::size_t body) const override;
    [[nodiscard]] double mass(std::size_t body) const override;
    [[nodiscard]] const std::vector<Impact>& impacts() const override { return c_.impacts.all(); }
    [[nodiscard]] std::vector<double> jumps(std::size_t body) const override;
    [[nodiscard]] std::optional<double> errorEstimate() const override { return c_.errorEstimate; }
    [[nodiscard]] std::optional<double> predictableUntil() const override {
        return c_.predictableUntil;
    }
    [[nodiscard]] const std::vector<std::string>& notes() const override { return c_.notes; }

private:
    Contents c_;
    double computed_ = 0;
};

} // namespace simulation

// The solved motion of all unknowns: piecewise polynomials over each unknown's own time points.
//
// A Histories is a value that shares its pieces: what the solver publishes never changes, any
// thread may read it as long as it likes, and publishing costs as much as was added since.
//
// At an event an unknown may have two values. Everything here answers with the one after it, except
// pieceBefore(). Past the last known time, and before the start, the nearest piece is continued:
// check reached() first when that matters.
#pragma once

#include "dense/polynomial.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace solution {

// In the history of a multiplier, which keeps 1 and its mode (modes/mode.h), and 0 while it sleeps:
// its condition holds, or is gone; of friction, up to the next event, its contact has jammed, and
// it holds since or does not (modes/active_set.h).
inline constexpr double heldMode = 1, releasedMode = 4, jammedMode = 5, jammedLooseMode = 6;
[[nodiscard]] constexpr bool isJammed(double mode) {
    return mode == jammedMode || mode == jammedLooseMode;
}

inline constexpr double largestValue = 1e100; // of anything; beyond it motion ends

// Why the motion of some unknowns ended before the finish.
struct Stop {
    enum class Reason {
        notFinite,     // a right-hand side has no finite value from here on
        overflow,      // a value went over 1e100
        notConverged,  // the implicit equations of a step cannot be solved
        stepUnderflow, // error control needs steps below what doubles can resolve
        tooManySteps,  // more steps than Options::maximumSteps
        decisions,     // switching expressions flip without time advancing
        bounds,        // multipliers reach their bounds again and again, without time advancing
        unheld,        // no multipliers within their bounds keep what holds
        contradiction, // no multipliers keep their conditions
        algebraicLoop, // held values that are defined by each other
        tooManyEvents, // more events at one instant than Options::maximumEventsAtOnce
        tooMuchKept,   // what is kept of the motion is more than Options::mostBytes
        inputEnded,    // an unknown that this one reads ended
        source,        // the source of events ended it
    };
    double time = 0;
    Reason reason = Reason::notFinite;
    std::vector<std::size_t> unknowns; // all whose motion ends here together
    std::vector<std::size_t> culprits; // those that caused it: not finite, fastest, flipping
    std::string sentence; // with names of unknowns as in the equation set; no time in it
};

// Steps of one component: breakpoints and, per step, a row of coefficients for each column.
//
// A flight's steps are all alike: each begins at an event, lasts until the next, and has as many
// coefficients over a scale of 1. So its row says it all, with the origin in front: 24 bytes for a
// straight flight along an axis. Columns beyond columns() are the rates of the first ones there.
//
// Of places and velocities, x' = v, a step may keep the places' alone. What is kept of a column
//
//     place     x0, v0, c2, c3 ...      x = x0 + h v0 s + c2 s^2 + ...     v = v0 + 2 c2/h s + ...
//     other     c0, c1, c2, c3 ...
class History {
public:
    explicit History(std::size_t columns) : columns_(columns) {}
    [[nodiscard]] static std::shared_ptr<History> ofFlight(std::size_t columns,
                                                           std::uint8_t coefficients);

    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] double from() const { return size_ ? origin(0) : infinity; }
    [[nodiscard]] double until() const { return size_ ? until(size_ - 1) : -infinity; }
    // Of steps and their numbers; of those that begin before t.
    [[nodiscard]] std::size_t bytes() const {
        return isFlight() ? size_ * flightRow() * sizeof(double)
                          : size_ * sizeof(Step) + numbers_ * sizeof(double);
    }
    [[nodiscard]] std::size_t bytesBefore(double t) const;

    struct Step {
        double origin = 0, until = 0, scale = 1;
        bool fresh = false;            // begins at an event: values or derivatives may jump here
        std::uint8_t coefficients = 0; // per column; of places, where `others` is not 0
        std::uint8_t others = 0;       // of columns that are neither place nor velocity
        std::uint32_t offset = 0;      // into Chunk::values
    };
    [[nodiscard]] Step step(std::size_t index) const {
        return isFlight() ? flightStep(index)
                          : chunks_[index / stepsPerChunk]->steps[index % stepsPerChunk];
    }
    [[nodiscard]] double origin(std::size_t index) const {
        const Chunk& chunk = *chunks_[index / stepsPerChunk];
        return isFlight() ? chunk.values[index % stepsPerChunk * flightRow()]
                          : chunk.steps[index % stepsPerChunk].origin;
    }
    [[nodiscard]] double until(std::size_t index) const {
        if (isFlight())
            return index + 1 < size_ ? origin(index + 1) : endOfLast_;
        return chunks_[index / stepsPerChunk]->steps[index % stepsPerChunk].until;
    }
    // The numbers of all columns(), as they are kept.
    [[nodiscard]] std::span<const double> row(std::size_t index) const {
        const Step s = step(index);
        return {chunks_[index / stepsPerChunk]->values.data() + s.offset, sizeOf(s)};
    }
    [[nodiscard]] Piece piece(std::size_t index, std::size_t column) const;
    // One step, of which several columns are read at (t - origin) / scale. Until the next change.
    class Reading {
    public:
        Reading() = default;
        [[nodiscard]] const Step& step() const { return step_; }
        [[nodiscard]] double value(std::size_t column, double s) const {
            return evaluate(history_->read(step_, row_, column), s);
        }

    private:
        friend class History;
        const History* history_ = nullptr;
        const double* row_ = nullptr;
        Step step_;
    };
    [[nodiscard]] Reading reading(std::size_t index) const {
        Reading made;
        made.history_ = this;
        made.row_ = row(index).data();
        made.step_ = step(index);
        return made;
    }
    // Index of the step that holds t: the later one at a joint. `near` is where to look first.
    [[nodiscard]] std::size_t find(double t, std::size_t near = 0) const;

    // `rows` has `coefficients` numbers for each column.
    void append(const Step& step, std::span<const double> rows);
    // The same; the caller writes the numbers. Valid until the next change.
    [[nodiscard]] std::span<double> append(const Step& step);
    // Of a flight: a step begins at t and has no end; the one before it ends there. The caller
    // writes its numbers.
    [[nodiscard]] std::span<double> turn(double t);

    // Columns of places and of their velocities, once for all steps. False: there are others.
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    [[nodiscard]] bool takePairs(const Pairs& pairs);
    // Polynomials of all columns, in as many numbers as `step` says; with `others` only of those
    // whose velocities their places tell.
    void append(const Step& step, std::span<const Coefficients* const> columns);
    // The velocity's polynomial is the place's derivative, to the last bit.
    [[nodiscard]] static bool tells(const Coefficients& place, const Coefficients& velocity,
                                    double scale);
    // A component that has values but no step from them yet stands on an anchor: a step of no
    // length that its first step replaces.
    [[nodiscard]] bool endsInAnchor() const {
        return size_ > 0 && step(size_ - 1).until == step(size_ - 1).origin;
    }
    void dropAnchor();
    // Forgets everything after t. Returns the number of whole steps that were dropped.
    std::size_t cut(double t);
    // A copy that shares all chunks; what is shared is never written again.
    [[nodiscard]] std::shared_ptr<const History> freeze() const;
    // The same without what goes on after t: no step begins there but at an event, nor later. Of a
    // frozen one; the first step is kept.
    [[nodiscard]] std::shared_ptr<const History> upTo(double t) const;

private:
    static constexpr std::size_t stepsPerChunk = 64;
    // Leaves numbers as they are that are written at once.
    template <class Value> struct Unwritten : std::allocator<Value> {
        template <class Other> struct rebind { using other = Unwritten<Other>; };
        void construct(Value* place) noexcept { ::new (static_cast<void*>(place)) Value; }
        template <class... From> void construct(Value* place, From&&... from) {
            ::new (static_cast<void*>(place)) Value(std::forward<From>(from)...);
        }
    };
    struct Chunk {
        std::vector<Step> steps; // none of a flight
        std::vector<double, Unwritten<double>> values;
        void grow(std::size_t row, std::size_t coefficients);
    };
    [[nodiscard]] bool isFlight() const { return ofEach_ > 0; }
    [[nodiscard]] std::size_t flightRow() const { return 1 + columns_ * ofEach_; }
    [[nodiscard]] Step flightStep(std::size_t index) const;
    [[nodiscard]] Chunk& writableTail();
    void dropLast();

    // Where columns are in a row with `others`: places in order of pairs, then all others.
    struct Order {
        Pairs pairs;
        enum class Kind { place, velocity, other };
        struct Column {
            Kind kind = Kind::other;
            std::size_t which = 0; // of its kind; of a velocity, of its place's
        };
        std::vector<Column> columns;
    };
    // The numbers of one column in a row.
    struct Form {
        std::size_t first, count;
        void write(double* row, const Coefficients& numbers) const {
            std::copy_n(numbers.begin(), count, row + first);
        }
        [[nodiscard]] CoefficientList read(const double* row) const {
            return CoefficientList(std::span(row + first, count));
        }
    };
    [[nodiscard]] static Form placeOf(const Step& step, std::size_t which) {
        return {which * step.coefficients, step.coefficients};
    }
    [[nodiscard]] Form otherOf(const Step& step, std::size_t which) const;
    [[nodiscard]] std::size_t sizeOf(const Step& step) const;
    [[nodiscard]] CoefficientList read(const Step& step, const double* row,
                                       std::size_t column) const;

    std::size_t columns_;
    std::uint8_t ofEach_ = 0;            // of a flight: coefficients of each step; 0: it is none
    double endOfLast_ = infinity;        // of its last step
    std::shared_ptr<const Order> order_; // none: there are no pairs
    std::size_t size_ = 0;
    std::size_t numbers_ = 0;                       // in all rows; not of a flight
    std::vector<std::shared_ptr<Chunk>> chunks_;    // all but the last have stepsPerChunk steps
    mutable std::size_t sharedChunks_ = 0;          // the first ones, which a frozen copy holds too
    mutable std::shared_ptr<const History> frozen_; // none: changed since freeze()
};

class Histories {
public:
    [[nodiscard]] std::size_t unknowns() const { return tracks_.size(); }
    [[nodiscard]] double start() const { return start_; }
    // The unknown is known from start() up to here (maybe past the finish, maybe infinity).
    [[nodiscard]] double reached(std::size_t unknown) const;
    // All unknowns that did not stop are known up to here.
    [[nodiscard]] double known() const { return known_; }
    [[nodiscard]] const Stop* stop(std::size_t unknown) const;
    [[nodiscard]] const std::vector<Stop>& stops() const { return stops_; }

    [[nodiscard]] double value(std::size_t unknown, double t) const;
    [[nodiscard]] double derivative(std::size_t unknown, double t) const;
    [[nodiscard]] double secondDerivative(std::size_t unknown, double t) const;

    // The piece that holds t; at a joint the later one, and with pieceBefore the earlier one.
    [[nodiscard]] Piece piece(std::size_t unknown, double t) const;
    [[nodiscard]] Piece pieceBefore(std::size_t unknown, double t) const;

    // The steps of the component that has the unknown at t, and its column there.
    struct Place {
        const History* history;
        std::size_t column;
    };
    [[nodiscard]] Place place(std::size_t unknown, double t) const;
    // The same place at all times.
    [[nodiscard]] bool isInOnePlace(std::size_t unknown) const {
        return tracks_[unknown].spans.size() == 1;
    }

    // The place that it has at t is the last one.
    [[nodiscard]] bool staysInPlace(std::size_t unknown, double t) const {
        return tracks_[unknown].spans.back().from <= t;
    }

    // Times, in order, at which the unknown was restarted by an event (value or derivative may
    // jump).
    [[nodiscard]] std::vector<double> restarts(std::size_t unknown) const;
    // Of the steps that begin before t, in all components that it was in.
    struct Course {
        std::size_t steps = 0, restarts = 0;
    };
    [[nodiscard]] Course course(std::size_t unknown, double t) const;
    // Of all steps; of those that begin before t.
    [[nodiscard]] std::size_t bytes() const { return bytesBefore(infinity); }
    [[nodiscard]] std::size_t bytesBefore(double t) const;
    // Of the components that an unknown was in, whatever else they have.
    [[nodiscard]] std::size_t bytesOf(std::size_t unknown) const;

    // The motion up to t, as it was before anything after t was solved. Of a snapshot.
    [[nodiscard]] std::shared_ptr<const Histories> upTo(double t) const;

private:
    friend class Network;
    // A replaced equation gives an unknown another component: one span for each.
    struct Span {
        double from = 0;
        std::shared_ptr<const History> history;
        std::size_t column = 0;
    };
    struct Track {
        std::vector<Span> spans;
        std::optional<std::size_t> stop;
        double initial = 0;
    };
    [[nodiscard]] const Span& spanAt(std::size_t unknown, double t) const;
    // The unknown's own steps that begin before t, in order: of each component those of its time.
    template <typename Visit> void forEachStep(std::size_t unknown, double t, Visit visit) const;

    double start_ = 0, known_ = 0;
    std::vector<Track> tracks_;
    std::vector<Stop> stops_;
};

} // namespace solution

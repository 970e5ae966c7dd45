// The motions that texts had, for a text that comes back: by an undo, a redo, a drag that returns.
//
// A motion is a function of the text and of its parameters' values alone, so the same text has the
// same motion. One that was cancelled, or had no memory, is none. Of the texts of a gesture the
// last is kept alone, so that the one before the gesture stays. Any thread may ask.
#pragma once

#include "computing/tools.h"

#include <list>
#include <mutex>
#include <optional>

namespace computing {

class FormerMotions {
public:
    // LIMIT: the motions that were wanted last, of this many texts, and about as many bytes, those
    // of the texts, of the histories and of the equations.
    static constexpr std::size_t mostTexts = 40, mostBytes = std::size_t{200} << 20;

    // As if it had been computed again, with no work.
    [[nodiscard]] std::optional<simulation::Result>
    of(const std::string& text, const ParameterValues& parameters, bool isGesture = false);
    void add(const std::string& text, const ParameterValues& parameters,
             const simulation::Result& result, std::size_t bodies, bool isGesture = false);

private:
    struct Former {
        std::string text;
        ParameterValues parameters;
        simulation::Result result;
        std::size_t bytes = 0;
        bool isPassing = false; // of a gesture that may go on
    };
    using Place = std::list<Former>::iterator;
    [[nodiscard]] Place find(const std::string& text, const ParameterValues& parameters);
    void drop(Place one);

    std::mutex mutex_;
    std::list<Former> all_; // the one that was wanted last first
    std::size_t bytes_ = 0;
};

} // namespace computing

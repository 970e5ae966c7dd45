// The motions that texts had, for a text that comes back: by an undo, a redo, a drag that returns.
//
// A motion is a function of the text and of its parameters' values alone, so the same text has the
// same motion. One that was cancelled, or had no memory, is none.
#pragma once

#include "computing/tools.h"

#include <list>
#include <optional>

namespace computing {

class FormerMotions {
public:
    // LIMIT: the motions that were wanted last, of this many texts, and as many bytes.
    static constexpr std::size_t mostTexts = 400, mostBytes = std::size_t{200} << 20;

    // As if it had been computed again, with no work.
    [[nodiscard]] std::optional<simulation::Result> of(const std::string& text,
                                                       const ParameterValues& parameters);
    void add(const std::string& text, const ParameterValues& parameters,
             const simulation::Result& result);

private:
    struct Former {
        std::string text;
        ParameterValues parameters;
        simulation::Result result;
    };
    std::list<Former> all_; // the one that was wanted last first
    std::size_t bytes_ = 0;
};

} // namespace computing

// The result of an evaluation: its recording made a scene, its end a sentence.
#pragma once

#include "script/evaluator.h"
#include "script/reader.h"

#include <optional>

namespace script {

// The answer of the server.
struct Answer {
    End end = End::exited;
    int status = 0;
    std::uint64_t progress = ~std::uint64_t{0};
    std::string bytes;
    bool serverReplaced = false; // it had ended; another took its place
};

// Why a text is not evaluated at all: too long, a zero byte, not UTF-8.
[[nodiscard]] std::optional<scene::Diagnostic> refuse(std::string_view text, std::size_t mostBytes);

[[nodiscard]] ReadResult judge(std::string_view text, const Answer& answer, const Limits& limits,
                               const std::map<std::string, double>& parameters);

} // namespace script

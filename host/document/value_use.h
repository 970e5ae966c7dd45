// A value of a subdocument that stands in a text or in a formula: which one it is, and how its
// number is written. docs/document-format.md says how a document spells it.
#pragma once

#include "sgml/tree.h"

#include <optional>
#include <string>
#include <string_view>

namespace document {

struct Digits {
    int count = 3;
    bool areDecimals = false; // behind the point; else all that count
    bool operator==(const Digits&) const = default;
};

inline constexpr int mostDecimals = 12, mostDigits = 15;

struct ValueUse {
    std::string of;               // the ID of the subdocument
    std::string expression;       // in its medium's language
    std::optional<double> time{}; // s; nothing: the time that it shows
    Digits digits{};
    std::string fault{}; // a sentence: what its author wrote cannot be meant so
    bool operator==(const ValueUse&) const = default;
};

// Of an element with OF, EXPRESSION, FORMAT and TIME.
[[nodiscard]] ValueUse valueUse(const sgml::Tree& tree, sgml::NodeId element);
// With FORMAT and TIME as a formula spells them: "2 decimals, at 1.5 s"; "": neither.
[[nodiscard]] ValueUse valueUse(std::string of, std::string expression, std::string_view options);

// "2 decimals", "3 digits", and a time in seconds: "1.5 s".
[[nodiscard]] std::string spelled(const Digits& digits);
[[nodiscard]] std::string spelledTime(double seconds);
// As it stands in braces behind \value; "" for what is usual.
[[nodiscard]] std::string spelledOptions(const ValueUse& use);

} // namespace document

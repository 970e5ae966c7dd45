// The numbers that stand for values of subdocuments: how they are written, and in which runs of a
// model they stand.
//
// A number is written by the language of its text: its point, and how a power of ten is said. While
// its time plays it keeps the room of the widest that stood there (Value::room), so that what is
// behind it does not move to and fro: a figure space in front of it, which no text that leaves the
// pages has, takes what is left of the room. In a formula a supplied value has its room.
#pragma once

#include "model/model.h"

namespace model {

struct ValueNow {
    std::optional<double> number{}; // neither it nor a fault: it is not known yet
    std::string fault{};            // a sentence why there is none
    bool isOutdated = false;        // of an older text of its subdocument
    bool moves = false;             // another one may come soon
    bool operator==(const ValueNow&) const = default;
};

class ValueSource {
public:
    virtual ~ValueSource() = default;
    [[nodiscard]] virtual ValueNow valueNow(const document::ValueUse& use) const = 0;
};

inline constexpr std::string_view figureSpace = "\u2007";

// "−4.20", "1.5×10⁻⁷", in a text of that language (as documents spell it; "": English).
[[nodiscard]] std::string written(double number, document::Digits digits,
                                  std::string_view language);
// The same as source of a formula.
[[nodiscard]] std::string asFormula(double number, document::Digits digits,
                                    std::string_view language);
// The text of any run where its looks are not seen: what is out of date says so, and a number does
// not have the room that it keeps while it plays.
[[nodiscard]] std::string plainText(const Run& run);

// The block with the values of now; the block itself where they are as they were. Without a source
// the expression stands for each.
[[nodiscard]] std::shared_ptr<const Block> withValues(const std::shared_ptr<const Block>& block,
                                                      const ValueSource* source);

} // namespace model

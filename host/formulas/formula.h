// A formula as read: TeX's mathematics, as a tree.
//
// Source is UTF-8: the commands of LaTeX and amsmath that memos and reports need, and the signs of
// Unicode themselves (α, ≤, ², −). Any source gives a formula: faulty parts are shown as far as
// they can be read, and each fault has its place and a sentence. Reading is linear in the length of
// the source.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace formulas {

// LIMIT: of a longer source, and of deeper nesting, the rest is left out, with a fault.
inline constexpr std::size_t longestSource = 20000; // bytes
inline constexpr int deepestNesting = 60;
inline constexpr std::size_t mostFaults = 100;
inline constexpr std::size_t mostColumns = 64; // of an array

// The class of an atom, as TeX calls it: it says how much space is beside it.
enum class Atom {
    ordinary,
    operation, // sum, sin
    binary,
    relation,
    opening,
    closing,
    punctuation,
    inner, // \left ... \right
};

enum class Kind {
    symbol,    // `code` of the font; `letter` is what it was before its alphabet
    text,      // \text, and the names of functions
    list,      // children in a row
    scripts,   // nucleus, subscript, superscript; `none` for what is not there
    fraction,  // numerator, denominator; `amount` 0: without a line
    root,      // radicand, degree or `none`
    accent,    // `code` over the child
    bar,       // a line over (U+0305) or under (U+0332) the child
    stretch,   // `code`, as wide as the child, over or under it
    arrow,     // `code`, as wide as its two children, which stand above and below
    fenced,    // parts between `delimiters`, as high as they are
    delimiter, // `code`, `amount` em high
    array,     // cells, row by row
    space,     // `amount` em
    style,     // for the rest of its list
    phantom,   // the room of the child: `code` is b(oth), h(orizontal), v(ertical)
    room,      // the first child, at the right end of the width of the second where that is wider
};

enum class Style { display, text, script, scriptscript };
enum class Limits { byStyle, always, never }; // are scripts above and below?
enum class Alphabet {
    normal, // italic letters, upright digits and Greek capitals
    upright,
    italic,
    bold,
    boldItalic,
    calligraphic,
    blackboard,
    fraktur,
    sans,
    mono,
};
enum class ArrayForm { matrix, small, cases, aligned, gathered, stack };

using NodeId = std::uint32_t;
inline constexpr NodeId none = 0xFFFFFFFF;

struct Node {
    Kind kind = Kind::list;
    Atom atom = Atom::ordinary;
    Limits limits = Limits::never;
    Style style = Style::text;
    ArrayForm form = ArrayForm::matrix;
    bool faulty = false; // stands for what could not be read
    bool styled = false; // fraction: `style` holds
    std::size_t offset = 0, end = 0;
    char32_t code = 0, letter = 0;
    Alphabet alphabet = Alphabet::normal;
    double amount = 0;
    std::string text{};          // array: a letter l, c or r for each column
    std::u32string delimiters{}; // fenced: one more than there are parts; '.' is none
    std::vector<NodeId> children{};
};

struct Fault {
    std::size_t offset = 0, end = 0; // bytes of the source
    std::string message;
};

// A number from elsewhere: \value[options]{of}{expression}.
struct ValueCall {
    std::string options, of, expression;
    std::size_t offset = 0, end = 0; // bytes of the source
};

struct Formula {
    std::vector<Node> nodes;
    NodeId root = none; // a list; never none in what read() returns
    std::vector<Fault> faults;
    std::vector<ValueCall> values;
    [[nodiscard]] const Node& node(NodeId id) const { return nodes[id]; }
    // The node, or the only part of lists of one part.
    [[nodiscard]] const Node& alone(NodeId id) const {
        const Node* found = &nodes[id];
        while (found->kind == Kind::list && found->children.size() == 1)
            found = &nodes[found->children.front()];
        return *found;
    }
};

// The source of a formula that stands for a value, "" for its expression. It is shown as faulty
// where there is no number, and takes as much width as `room` at least, "": as it is.
struct SuppliedValue {
    std::string source{};
    bool isFaulty = false;
    std::string room{};
    bool operator==(const SuppliedValue&) const = default;
};
using ValueSupply = std::function<SuppliedValue(const ValueCall&)>;

// Without a supply the expression stands for each value.
[[nodiscard]] Formula read(std::string_view source, const ValueSupply& supply = {});

// In English words, for those who hear the formula.
[[nodiscard]] std::string spoken(const Formula& formula);

// In one line of Unicode, as one types it in a mail: "x² + y² = r²".
[[nodiscard]] std::string plain(const Formula& formula);
// The same with a line for each row of a formula that is nothing but rows.
[[nodiscard]] std::vector<std::string> plainLines(const Formula& formula);

} // namespace formulas

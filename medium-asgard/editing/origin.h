// The places in the text from which the numbers of a word come.
//
// Followed: literals; "..." and [list ...] with literals and $variables in them; a variable that
// one `set` gives a literal and nothing else changes; a parameter. Any other maker of a number is
// named with its place.
#pragma once

#include "scene/scene.h"
#include "script/structure.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace editing {

// The bytes of one number, or why there are none that could be rewritten.
struct Origin {
    scene::Range literal; // known: the number's own bytes
    double factor = 1;    // the value is the literal times this
    std::string reason;   // "computed by expr"
    scene::Range cause;
    std::string variable;    // through which it comes, "" when directly
    scene::Range place = {}; // what stands for it in the command: "$x", "[expr {2 * $i}]"
};

class Origins {
public:
    Origins(std::string_view text, const script::Structure& structure, const scene::Scene& scene)
        : text_(text), structure_(structure), scene_(scene) {}

    // One origin for each element of the list that this word of the command is; `path` goes into
    // nested lists first. Empty: it is no list with such an element.
    [[nodiscard]] std::vector<Origin> ofList(const script::Command& command,
                                             const script::Word& word,
                                             const std::vector<std::size_t>& path) const;
    [[nodiscard]] Origin ofScalar(const script::Command& command, const script::Word& word) const;

    // The literal whose content is the word's value: the word itself, or what its variable is set
    // to.
    struct Literal {
        scene::Range content; // unknown with a reason
        std::string reason;
        scene::Range cause;
    };
    [[nodiscard]] Literal literalOf(const script::Command& command, const script::Word& word) const;

    // The command that this one runs in: a procedure's definition, or null at the top.
    [[nodiscard]] const script::Command* procedureOf(const script::Command& command) const;
    // The nearest loop or procedure around a command, or null.
    [[nodiscard]] const script::Command* makerOf(const script::Command& command) const;
    // Whether it gives the variable a value, or may.
    [[nodiscard]] bool writes(const script::Command& command, const std::string& name) const;
    [[nodiscard]] const scene::Scene& scene() const { return scene_; }
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] const script::Structure& structure() const { return structure_; }
    [[nodiscard]] std::string slice(scene::Range range) const;
    [[nodiscard]] int lineOf(std::size_t offset) const;

private:
    [[nodiscard]] std::vector<Origin> inLiteral(scene::Range content,
                                                const std::vector<std::size_t>& path) const;
    [[nodiscard]] std::vector<Origin> inQuotes(const script::Command& command,
                                               scene::Range content) const;
    [[nodiscard]] std::vector<Origin> inListCommand(const script::Command& list) const;
    // Of $name, read by this command.
    [[nodiscard]] Origin ofVariable(const script::Command& reader, const std::string& name,
                                    scene::Range where) const;
    [[nodiscard]] std::vector<Origin> ofListVariable(const script::Command& reader,
                                                     const std::string& name, scene::Range where,
                                                     const std::vector<std::size_t>& path) const;
    struct Definition {
        const script::Word* value = nullptr;
        std::string reason;
        scene::Range cause;
    };
    [[nodiscard]] Definition definitionOf(const script::Command& reader, const std::string& name,
                                          scene::Range where) const;
    [[nodiscard]] Origin refused(const std::string& reason, scene::Range cause) const;
    [[nodiscard]] const script::Command* substitutionAt(scene::Range word) const;

    std::string_view text_;
    const script::Structure& structure_;
    const scene::Scene& scene_;
};

// The variable that a text like $name or ${name} reads, when it is nothing else.
[[nodiscard]] std::optional<std::string> variableIn(std::string_view text);

} // namespace editing

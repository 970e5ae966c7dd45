// The words of one scene command as options and values, each with its place, each fault reported at
// the word that is wrong, with what was expected.
#pragma once

#include "script/locate.h"
#include "script/structure.h"

#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace script {

// A value's text and where it stands.
struct Value {
    std::string text;
    Range range;            // what to underline when it is wrong
    bool exact = false;     // its bytes stand in the scene's text ...
    std::size_t origin = 0; // ... from here

    [[nodiscard]] Value part(const Element& element) const;
    [[nodiscard]] Value piece(std::size_t from, std::size_t to) const; // bytes of the text
};

// One run of a scene command.
struct Call {
    std::vector<Value> words; // words[0] is the command's name
    scene::Source source;     // its arguments are filled in as they are read
};

// Collects what is wrong, with lines and columns.
class Faults {
public:
    Faults(const text::Places& places, std::vector<scene::Diagnostic>& out)
        : places_(places), out_(out) {}
    void error(Range range, std::string message, std::string suggestion = "");
    void warning(Range range, std::string message, std::string suggestion = "");

private:
    void add(scene::Severity severity, Range range, std::string message, std::string suggestion);
    const text::Places& places_;
    std::vector<scene::Diagnostic>& out_;
    std::map<std::size_t, int> atPlace_;
};

enum class Sign { any, positive, notNegative, unit }; // unit: from 0 to 1

// Reads values of one element ("body \"b1\"") and reports what they are not. A getter returns
// nothing when the option is absent or wrong; wrong has then been reported.
class Arguments {
public:
    // Words from `first` on are options and their values. Unknown options, options without a value
    // or given twice, and words that are no options are reported.
    Arguments(Faults& faults, Call& call, std::string subject, std::size_t first,
              std::initializer_list<std::string_view> options);
    Arguments(Faults& faults, Call& call, std::string subject, std::size_t first,
              std::span<const std::string_view> options);

    [[nodiscard]] const Value* find(std::string_view option) const;
    [[nodiscard]] bool has(std::string_view option) const { return find(option) != nullptr; }
    // An option that is there, but without a value.
    [[nodiscard]] bool attempted(std::string_view option) const;

    // The value of an option that is there; reports one that has none.
    const Value* wanted(std::string_view option, std::string_view wants);
    // `otherwise`: suggested for a text that is no number.
    std::optional<double> number(std::string_view option, Sign sign = Sign::any,
                                 std::string otherwise = "");
    std::optional<int> integer(std::string_view option);
    std::optional<bool> flag(std::string_view option);
    std::optional<geometry::Vector> vector(std::string_view option);
    std::optional<scene::Color> color(std::string_view option);
    std::optional<std::string> text(std::string_view option);
    std::optional<std::string> name(std::string_view option, std::string_view what);
    scene::Appearance appearance();

    // Of these at most one; reports the second.
    bool atMostOne(std::initializer_list<std::string_view> options);

    [[nodiscard]] const std::string& subject() const { return subject_; }
    // "-mass of body "b1" wants a number" and what is wrong, at `range`.
    void wrong(std::string_view option, Range range, std::string_view wants, std::string_view but,
               std::string suggestion = "");
    // A fault of the element as a whole, at its command's name.
    void wrongElement(std::string message, std::string suggestion = "");

    // The same for values inside lists.
    std::optional<double> numberIn(std::string_view option, const Value& value, Sign sign,
                                   std::string_view wants, std::string otherwise = "");
    std::optional<std::vector<double>> numbersIn(std::string_view option, const Value& value,
                                                 std::string_view wants);
    std::optional<geometry::Vector> vectorIn(std::string_view option, const Value& value,
                                             std::string_view wants);
    std::optional<scene::Color> colorIn(std::string_view option, const Value& value);
    std::optional<std::vector<Value>> listIn(std::string_view option, const Value& value,
                                             std::string_view wants);

    Faults& faults() { return faults_; }
    [[nodiscard]] Range commandRange() const { return call_.words[0].range; }
    [[nodiscard]] Range optionRange(std::string_view option) const;

private:
    struct Given {
        std::string option;
        Range optionRange;
        const Value* value; // null: nothing follows it
        bool reported = false;
    };
    [[nodiscard]] const Given* given(std::string_view option) const;
    void read(std::size_t first, std::span<const std::string_view> options);
    void strayWord(const Value& word, std::span<const std::string_view> options);

    Faults& faults_;
    Call& call_;
    std::string subject_;
    std::vector<Given> given_;
    bool misread_ = false; // a word that is no option of its own
};

[[nodiscard]] std::string quoted(std::string_view text); // in quotes, long ones cut

} // namespace script

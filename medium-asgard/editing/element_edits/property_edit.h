// The options of elements as the fields of a form: what stands in each, and the edit that gives it
// another value.
//
// Numbers are changed as a gesture changes them, with its offers (value_edit.h). Any other text,
// and a number in place of an expression, is written where the old one stands; a value that is
// missing is added to the command, an empty one removes its option. Whether the scene takes a value
// is for the reader to say.
#pragma once

#include "editing/value_edit.h"
#include "element_edits/options.h"
#include "script/structure.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace editing {

// The options that mean something for an element, in the order of the manual: those of a joint's
// coordinates only as far as its type has them.
[[nodiscard]] std::vector<const OptionHint*> optionsOf(const scene::Scene& scene,
                                                       const Element& element);
// Those that all of these elements have.
[[nodiscard]] std::vector<const OptionHint*> sharedOptions(const scene::Scene& scene,
                                                           const std::vector<Element>& elements);

// The texts of a field's parts: three for a vector that is written as three or not at all, else
// one. Not written: empty ones. A value that a variable, a loop or a procedure makes is told in
// numbers, or as the name of an element, where it is known.
struct PropertyValue {
    std::vector<std::string> parts;
    bool isWritten = false;
    std::string source; // what stands in the text, where the parts say another thing
    bool operator==(const PropertyValue&) const = default;
};

// For one text and the scene that was read from it.
class Properties {
public:
    Properties(std::string text, std::shared_ptr<const scene::Scene> scene,
               Mapper::Factor factor = {});

    [[nodiscard]] PropertyValue valueOf(const Element& element, const OptionHint& option) const;
    // The value that all of them have; a part in which they differ is none.
    [[nodiscard]] std::vector<std::optional<std::string>>
    sharedValue(const std::vector<Element>& elements, const OptionHint& option) const;

    // Parts that are none stay as they are. Empty parts, all of them, remove the option.
    [[nodiscard]] Answer set(const std::vector<Element>& elements, const OptionHint& option,
                             const std::vector<std::optional<std::string>>& parts) const;

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    [[nodiscard]] const script::Word* wordOf(const Element& element, const OptionHint& option,
                                             const script::Command*& command) const;
    [[nodiscard]] Answer setOne(const Element& element, const OptionHint& option,
                                const std::vector<std::string>& parts) const;
    [[nodiscard]] Answer removed(const Element& element, const OptionHint& option) const;
    [[nodiscard]] Answer written(const Element& element, const OptionHint& option,
                                 const std::string& value) const;
    [[nodiscard]] Answer refused(const Element& element, const std::string& why) const;

    std::string text_;
    std::shared_ptr<const scene::Scene> scene_;
    script::Structure structure_;
    Mapper mapper_;
};

} // namespace editing

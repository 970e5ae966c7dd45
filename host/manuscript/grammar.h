// The grammar of a class for somebody who writes: its elements' kinds, and their allowed places.
//
// A class's structure says which elements there are and what they may hold. The class's default
// presentation says what each of them is: by its `display` (a footnote, a link, a table) and by its
// `role` (the paragraph, the heading, the emphasis). No element is known here by its name, except
// the two that the format itself knows: TEXT, which is content in braces, and DOCUMENT.
#pragma once

#include "schemas/schemas.h"
#include "sgml/tree.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace manuscript {

enum class Kind {
    unknown,   // the class says nothing of it: its text can be written, and nothing else
    inlined,   // part of a line, with text in it
    block,     // holds lines, or other blocks
    unit,      // stands in a line or for a block, and is copied and erased as a whole
    blockUnit, // the same, and never part of a line
};

struct Element {
    Kind kind = Kind::unknown;
    schemas::Display display = schemas::Display::unknown;
    schemas::ContainerRole role = schemas::ContainerRole::none;
    bool holdsText = false;
    bool isNumbered = false;    // has a counter, or is a heading of the outline
    bool isHeaderFirst = false; // a row: the first of a table is repeated, unless it says otherwise
    std::string referredAs{};   // by references, before its number: "Figure"; "": no word
};

// Of one class of documents.
class Grammar {
public:
    Grammar(const schemas::StructureSchema* structure, const schemas::Presentation& presentation);

    [[nodiscard]] const Element& of(std::string_view name) const;
    // Has the class a rule for it?
    [[nodiscard]] bool knows(std::string_view name) const {
        return elements_.find(name) != elements_.end();
    }
    // The element with that role or display, "" where the class has none. Of several the first in
    // the order of their names.
    [[nodiscard]] std::string_view named(schemas::ContainerRole role) const;
    [[nodiscard]] std::string_view named(schemas::Display display) const;

    // Children are names of elements; "" stands for content in braces.
    using Children = std::vector<std::string_view>;
    // Why an element may not hold these; "" when it may, and when the class says nothing of it.
    [[nodiscard]] QString whyNot(std::string_view element, const Children& children) const;
    // The elements that may come in before the child at `index`, in the structure's order; "TEXT"
    // stands for text. ANY stands for every element of the class.
    [[nodiscard]] std::vector<std::string>
    allowedAt(std::string_view element, const Children& children, std::size_t index) const;
    // The attributes by which the presentation tells kinds of an element apart: KIND and "number".
    using Variant = schemas::Presentation::Variant;
    [[nodiscard]] const std::vector<Variant>& variants(std::string_view element) const;
    // Is there a place for it in the element, whatever must stand there before it?
    [[nodiscard]] bool mayHold(std::string_view element, std::string_view child) const;
    [[nodiscard]] bool hasAttribute(std::string_view element, std::string_view attribute) const;

private:
    [[nodiscard]] bool allowsText(std::string_view name) const;

    const schemas::StructureSchema* structure_;
    std::map<std::string, Element, std::less<>> elements_;
    std::map<std::string, std::vector<Variant>, std::less<>> variants_;
};

// Of all classes. LIMIT: as the schemas were when it was made.
class Grammars {
public:
    explicit Grammars(const schemas::Schemas& schemas) : schemas_(schemas) {}

    // Null for a class that is no text: its documents are units.
    [[nodiscard]] const Grammar* of(std::string_view className) const;

private:
    const schemas::Schemas& schemas_;
    mutable std::map<std::string, Grammar, std::less<>> grammars_; // made when they are asked for
};

// How a sentence calls an element: "a paragraph", "a PERSON".
[[nodiscard]] QString called(const Grammar& grammar, std::string_view name);

} // namespace manuscript

// How documents of one class look: `CLASS.NAME.presentation`, blocks of properties
// (docs/schemas.md).
//
//     SECTION HEADING { font: 14pt bold; number: "1.1"; space-before: 12pt }
//
// A selector is the names of elements, outermost first, the last one being the element that the
// block is about; others may stand between. `,` gives alternatives, `*` is any element,
// `NAME:first` the first of its name among its siblings, `NAME[KIND=number]` one with that
// attribute. Generated text (`before`, `after`) looks as if it stood in an element BEFORE or AFTER.
// Of two blocks that say different things the one with more names counts, of equals the later one.
// Text properties (font, color, align, line-height) and float are inherited, the others are not.
#pragma once

#include "schemas/style.h"
#include "sgml/tree.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace schemas {

enum class Display {
    unknown, // no rule says: shown as what it is
    block,
    inlined,
    verbatim,
    table,
    row,
    cell,
    image,
    pageBreak,
    rule,
    footnote,
    link,
    reference,
    slider,
    value,
    chart,
    formula,  // in the line
    equation, // a formula that stands alone
    contents, // a list of headings or captions with their pages
};

// Everything that a presentation says about one element, resolved: a plain record with a member for
// each property (docs/schemas.md).
struct ElementStyle {
    Display display = Display::unknown;
    bool show = true;
    TextStyle text;
    BlockStyle block;          // its indents are the element's own, not those of its containers
    std::string before, after; // generated text around the content
    std::string marker;        // "To:", a bullet
    std::string number;        // pattern of the marker: "1.1", "Figure 1:", "(a)"
    std::string counter;       // that the element steps
    std::vector<std::string> restart; // counters that begin again inside it
    std::string reference; // pattern of what REF shows; "" is `number` without its last punctuation
    std::string referenceNumber; // of one that shows the number alone; "" is `reference` without
                                 // the words before its number
    bool refersByNumber = false; // `display: reference`: it shows the number alone
    int headingLevel = 0;
    ContainerRole role = ContainerRole::none;
    bool title = false;                           // its text is the document's title
    ContainerRole lists = ContainerRole::heading; // `display: contents`: of what
    bool repeat = false; // a row: stands again at the top of each page that its table goes on on
    bool operator==(const ElementStyle&) const = default;
};

// `font: 14pt bold "Gentium"` as read: a name and its words.
struct Property {
    struct Word {
        std::string text; // a string without its quotes
        bool quoted = false;
        bool operator==(const Word&) const = default;
    };
    std::string name;
    std::vector<Word> words;
    std::size_t offset = 0; // in the file
};

class Presentation {
public:
    // Faulty parts are left out; each fault has its line in the file. `base`: the one whose blocks
    // come before all of its own: what it says nothing else about looks as that one says.
    [[nodiscard]] static Presentation parse(std::string_view text, std::vector<sgml::Fault>& faults,
                                            const Presentation* base = nullptr);

    [[nodiscard]] const PageStyle& page() const { return page_; }
    // Something could be read that is not its base's.
    [[nodiscard]] bool saysSomething() const { return saysSomething_; }
    // How an element of that name looks wherever it stands. A block that names outer elements or
    // attributes counts less than one that does not: what the element is stands in the latter.
    [[nodiscard]] ElementStyle styleNamed(std::string_view name) const;
    // A kind of an element that selectors tell apart by an attribute: LIST[KIND=number].
    struct Variant {
        std::string attribute, value;
        bool isNumbered = false; // it has a marker with its own number
        ContainerRole lists = ContainerRole::heading;
        std::string reference{};
        bool refersByNumber = false;
        bool operator==(const Variant&) const = default;
    };
    [[nodiscard]] std::vector<Variant> variantsOf(std::string_view name) const;
    // The elements that some block shows as this: "image", "reference".
    [[nodiscard]] std::set<std::string, std::less<>> namesShownAs(std::string_view display) const;

    struct Selector {
        struct Name {
            std::string name; // "*": any
            bool first = false;
            std::string attribute, value; // "": none is asked for
        };
        std::vector<Name> names; // outermost first. LIMIT: 100 of them
        std::size_t block = 0;   // index of its properties
        int layer = 0;           // of two the higher one counts: what inherits from the other
    };
    // How far each selector has matched on the way from the document down to an element.
    using Progress = std::vector<std::uint8_t>;
    [[nodiscard]] Progress start() const { return Progress(selectors_.size(), 0); }
    struct Subject {
        std::string_view name;
        bool first = false;
        const sgml::Tree* tree = nullptr; // null: generated text
        sgml::NodeId element = sgml::noNode;
    };
    // The style of an element inside one with style `outer`; `progress` goes one element down.
    [[nodiscard]] ElementStyle style(const Subject& subject, const ElementStyle& outer,
                                     Progress& progress) const;
    // The style that the document's class element inherits: in English unless the document says
    // another language.
    [[nodiscard]] ElementStyle rootStyle() const;

private:
    friend class PresentationParser;
    std::vector<Selector> selectors_; // the weaker ones first
    std::vector<std::vector<Property>> blocks_;
    PageStyle page_;
    int layer_ = 0;
    bool saysSomething_ = false;
};

// Each puts one property into a style; "" or what is wrong with it.
[[nodiscard]] std::string applyProperty(ElementStyle& style, const Property& property,
                                        const ElementStyle& outer);
// In points: "12mm", with a unit (pt, mm, cm, in, px).
[[nodiscard]] std::optional<double> lengthOf(std::string_view text);
[[nodiscard]] std::string applyPageProperty(PageStyle& page, const Property& property);

} // namespace schemas

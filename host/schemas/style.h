// How something should look, as a presentation says and before anything is laid out. Lengths are
// points (1/72 inch) unless a comment says otherwise.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace schemas {

struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Color&) const = default;
};

// The look of letters. Inherited by everything inside.
struct TextStyle {
    std::string family =
        "serif"; // "serif", "sans", "mono" are generic; anything else is a font's name
    double size = 11;
    bool bold = false;
    bool italic = false;
    bool underline = false;
    bool raised = false; // superscript: smaller and higher (footnote marks)
    Color color;
    std::optional<Color> background;
    bool hyphenate = true; // words may be divided
    std::string language;  // as documents spell it, "de" or "en-GB"; "": unknown
    bool operator==(const TextStyle&) const = default;
};

// Each different look once, by number. The table only grows: a number stays true as long as the
// table lives.
class TextStyles {
public:
    std::uint32_t numberOf(const TextStyle& style);
    [[nodiscard]] const TextStyle& operator[](std::uint32_t number) const {
        return styles_[number];
    }
    [[nodiscard]] std::size_t size() const { return styles_.size(); }

private:
    std::deque<TextStyle> styles_;
    std::unordered_multimap<std::size_t, std::uint32_t> numbers_; // by hash
};

enum class Align { left, center, right, justify };

struct Border {
    double width = 0; // 0: none
    Color color{128, 128, 128};
    bool top = true, right = true, bottom = true, left = true;
    bool operator==(const Border&) const = default;
};

// The place of a block and its surroundings.
struct BlockStyle {
    Align align = Align::left;
    // Of two that meet the larger counts: in a Model all of it is in spaceBefore.
    double spaceBefore = 0, spaceAfter = 0;
    double indentLeft = 0, indentRight = 0; // from the text area's edges, those of containers added
    double firstLine = 0;                   // further indent of the first line; may be negative
    double lineHeight = 1.2;                // times the size of the letters
    // Of the column for the marker (number, bullet, "To:"), which ends at indentLeft; 0: the marker
    // is set in front of the text, on its first line.
    double markerWidth = 0;
    Align markerAlign = Align::left;
    double padding = 0; // between border and text
    // Of a cell: stands with the numbers of its column, their points one below the other.
    bool alignNumbers = false;
    std::optional<Color> background;
    Border border;
    bool keepWithNext = false; // not the last on a page
    bool keepTogether = false; // not split over pages if it fits on one
    bool pageBreakBefore = false;
    // A picture with its caption goes to the top of the next page where there is no room for it,
    // and what follows fills the page before.
    bool mayFloat = false;
    std::string hint; // what stands in it, said where it is written and has no text
    // A line above or below the text is as wide as the text.
    [[nodiscard]] double paddingAside() const {
        return background || border.left || border.right ? padding : 0;
    }
    bool operator==(const BlockStyle&) const = default;
};

// The role of an element for its reader, however it looks. Some stand for several elements. Those
// up to `quote` hold blocks; commands of writing look for the others.
enum class ContainerRole {
    none,
    section,
    list,
    item,
    figure,
    table,
    caption,
    quote,
    paragraph,
    heading,
    emphasis,
    strong,
    code,
};

[[nodiscard]] inline bool isContainer(ContainerRole role) {
    return role != ContainerRole::none && role <= ContainerRole::quote;
}

// The paper. In headers and footers {page}, {pages} and {title} stand for what they say.
struct PageStyle {
    double width = 595.276, height = 841.89; // A4
    double marginTop = 72, marginRight = 72, marginBottom = 72, marginLeft = 72;
    std::string headerLeft, headerCenter, headerRight;
    std::string footerLeft, footerCenter, footerRight;
    bool headerOnFirstPage = true;
    TextStyle headerStyle; // of footers too
    Color background{255, 255, 255};
    bool balance = false; // the pages up to one that the document begins are filled alike
    double zoom = 1;      // times the size on screen that a view of this presentation begins with
    bool operator==(const PageStyle&) const = default;
};

} // namespace schemas

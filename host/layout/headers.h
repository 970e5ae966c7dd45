// Headers and footers of pages, made when a page is asked for: the number of pages changes all.
#pragma once

#include "strips/strip.h"

#include <deque>

namespace layout {

// The place of the text on a page, in twips.
struct TextArea {
    double left = 0, top = 0, bottom = 0, width = 0;
    [[nodiscard]] double height() const { return bottom - top; }
    bool operator==(const TextArea&) const = default;
};
[[nodiscard]] TextArea textAreaOf(const schemas::PageStyle& style);

class Headers {
public:
    Headers(const schemas::PageStyle& style, std::string title);

    [[nodiscard]] std::vector<TextPiece> on(std::size_t page, std::size_t pages) const;
    [[nodiscard]] bool isOf(const schemas::PageStyle& style, const std::string& title) const {
        return style == style_ && title == title_;
    }

private:
    struct Line {
        std::string text;
        schemas::Align align = schemas::Align::left;
        std::shared_ptr<const paragraphs::Paragraph> paragraph;
    };
    static constexpr std::size_t mostLines = 32; // those of some pages are kept
    [[nodiscard]] std::shared_ptr<const paragraphs::Paragraph> line(const std::string& text,
                                                                    schemas::Align align) const;

    schemas::PageStyle style_;
    std::string title_;
    TextArea area_;
    std::shared_ptr<paragraphs::Materials> materials_;
    mutable std::deque<Line> lines_;
};

} // namespace layout

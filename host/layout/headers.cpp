#include "layout/headers.h"

#include "paragraphs/measure.h"

#include <algorithm>

namespace layout {

using paragraphs::fromPoints;
using paragraphs::Materials;
using paragraphs::Paragraph;

namespace {
constexpr double leastPoints = 50; // of a text area, whatever the margins are
}

TextArea textAreaOf(const schemas::PageStyle& style) {
    TextArea area;
    area.left = fromPoints(style.marginLeft);
    area.top = fromPoints(style.marginTop);
    area.bottom =
        std::max(fromPoints(style.height - style.marginBottom), area.top + fromPoints(leastPoints));
    area.width =
        std::max(fromPoints(style.width - style.marginRight) - area.left, fromPoints(leastPoints));
    return area;
}

Headers::Headers(const schemas::PageStyle& style, std::string title)
    : style_(style), title_(std::move(title)), area_(textAreaOf(style)) {
    const auto styles = std::make_shared<schemas::TextStyles>();
    (void)styles->numberOf(style.headerStyle);
    materials_ = std::make_shared<Materials>(styles);
}

std::vector<TextPiece> Headers::on(std::size_t page, std::size_t pages) const {
    using schemas::Align;
    std::vector<TextPiece> result;
    const auto add = [&](const std::string& pattern, Align align, double y) {
        if (pattern.empty())
            return;
        QString text = QString::fromStdString(pattern);
        text.replace("{page}", QString::number(page + 1));
        text.replace("{pages}", QString::number(pages));
        text.replace("{title}", QString::fromStdString(title_));
        if (auto paragraph = line(text.toStdString(), align))
            result.push_back({std::move(paragraph), 0, {area_.left, y}});
    };
    const double height = fromPoints(style_.headerStyle.size * 1.2);
    if (page > 0 || style_.headerOnFirstPage) {
        const double y = area_.top / 2 - height / 2;
        add(style_.headerLeft, Align::left, y);
        add(style_.headerCenter, Align::center, y);
        add(style_.headerRight, Align::right, y);
    }
    const double y = area_.bottom + (fromPoints(style_.height) - area_.bottom) / 2 - height / 2;
    add(style_.footerLeft, Align::left, y);
    add(style_.footerCenter, Align::center, y);
    add(style_.footerRight, Align::right, y);
    return result;
}

std::shared_ptr<const Paragraph> Headers::line(const std::string& text,
                                               schemas::Align align) const {
    const auto known = std::ranges::find_if(
        lines_, [&](const Line& line) { return line.align == align && line.text == text; });
    if (known != lines_.end())
        return known->paragraph;
    auto block = std::make_shared<model::Block>();
    block->style.align = align;
    block->runs.emplace_back().text = text;
    auto paragraph = std::make_shared<Paragraph>(materials_, block, area_.width);
    const bool hasLine = paragraph->makeLine(0);
    lines_.push_back({text, align, hasLine ? paragraph : nullptr});
    if (lines_.size() > mostLines)
        lines_.pop_front();
    return lines_.back().paragraph;
}

} // namespace layout

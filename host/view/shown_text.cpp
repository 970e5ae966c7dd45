#include "view/shown_text.h"

#include <algorithm>

namespace view {

ShownText::ShownText(const document::Document& document, std::shared_ptr<const model::Model> model)
    : document_(document), model_(std::move(model)) {
    if (!model_)
        return;
    add(model_->blocks);
    for (const std::shared_ptr<const model::Footnote>& note : model_->footnotes)
        add(note->blocks);
}

void ShownText::add(const model::Blocks& blocks) {
    for (const std::shared_ptr<const model::Block>& block : blocks) {
        if (!text_.isEmpty() && !text_.endsWith('\n') && !text_.endsWith('\t'))
            text_ += '\n';
        add(*block);
    }
}

void ShownText::add(const model::Block& block) {
    if (!block.marker.empty())
        text_ += QString::fromStdString(block.marker) + ' ';
    if (const document::Subdocument* of = document_.subdocument(block.subdocument))
        text_ += QString::fromStdString(of->alternative);
    else
        text_ += QString::fromStdString(block.alternative);
    for (const model::Run& run : block.runs) {
        const auto from = static_cast<int>(text_.size());
        text_ += QString::fromStdString(run.formula ? run.formula->spoken : run.text);
        if (run.content != sgml::noNode)
            parts_.push_back({from, static_cast<int>(text_.size()), &run});
    }
    for (const model::Row& row : block.rows) {
        for (const model::Cell& cell : row) {
            add(cell.blocks);
            text_ += '\t';
        }
        text_ += '\n';
    }
}

std::optional<std::size_t> ShownText::placeOf(int letter) const {
    const auto endsBefore = [](const Part& part, int at) { return part.to < at; };
    auto part = std::lower_bound(parts_.begin(), parts_.end(), letter, endsBefore);
    if (part == parts_.end() && !parts_.empty())
        --part;
    const model::RunPlaces places(document_.tree());
    if (part == parts_.end() || !places.isText(*part->run))
        return std::nullopt;
    const int inside = std::clamp(letter, part->from, part->to) - part->from;
    const auto bytes = text_.mid(part->from, inside).toUtf8().size();
    return places.placeOf(*part->run, static_cast<std::size_t>(bytes));
}

int ShownText::letterAt(std::size_t place) const {
    const model::RunPlaces places(document_.tree());
    const sgml::NodeId content = document_.tree().innermostAt(place);
    int nearest = 0;
    for (const Part& part : parts_) {
        if (!places.isText(*part.run))
            continue;
        const bool isOwn = part.run->content == content;
        if (isOwn ? places.placeOf(*part.run, 0) > place
                  : document_.tree().node(part.run->content).range.from > place)
            break;
        nearest = part.to;
        if (isOwn) {
            const std::size_t bytes = places.byteAt(*part.run, place);
            const std::string before = part.run->text.substr(0, bytes);
            nearest = part.from + static_cast<int>(QString::fromStdString(before).size());
        }
    }
    return nearest;
}

} // namespace view

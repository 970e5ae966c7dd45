#include "reading/block_text.h"

#include "model/value_text.h"

#include <algorithm>

namespace reading {

using model::RunKind, model::plainText, model::RunPlaces;

namespace {

QString figureWords(const document::Document& document, document::SubdocumentId id,
                    const std::string& alternative) {
    const document::Subdocument* of = document.subdocument(id);
    const std::string& words = of ? of->alternative : alternative;
    return QString::fromStdString(words.empty() && of ? of->className : words);
}

} // namespace

QString wordsFor(const document::Document& document, const Block& figure) {
    const QString words = figureWords(document, figure.subdocument, figure.picture.alternative);
    return words.isEmpty() && !figure.runs.empty()
               ? QString::fromStdString(figure.runs.front().text)
               : words;
}

QString wordsFor(const document::Document& document, const Run& run) {
    if (run.formula)
        return QString::fromStdString(run.formula->spoken);
    return figureWords(document, run.subdocument,
                       run.picture ? run.picture->alternative : plainText(run));
}

thread_local std::size_t BlockText::letters = 0;

BlockText::BlockText(const document::Document& document, std::shared_ptr<const Block> block)
    : document_(document), block_(std::move(block)) {
    if (!block_->marker.empty())
        text_ = QString::fromStdString(block_->marker).trimmed() + ' ';
    for (const Run& run : block_->runs) {
        const auto from = static_cast<int>(text_.size());
        text_ += run.kind == RunKind::lineBreak ? QStringLiteral("\n") : wordsFor(document_, run);
        parts_.push_back({from, static_cast<int>(text_.size()), &run});
    }
    letters += static_cast<std::size_t>(text_.size());
}

std::optional<std::size_t> BlockText::placeOf(int letter) const {
    const RunPlaces places(document_.tree());
    const auto has = [&](const Part& part) { return part.from <= letter && letter <= part.to; };
    const Part *nearest = nullptr, *unit = nullptr;
    for (const Part& part : parts_) {
        if (places.isText(*part.run)) {
            nearest = &part;
            if (part.to >= letter)
                break;
        } else if (has(part) && isUnit(places, part)) {
            unit = &part;
        }
    }
    if (unit && !(nearest && has(*nearest))) {
        const text::Range own = places.rangeOf(*unit->run);
        return letter - unit->from < unit->to - letter ? own.from : own.to;
    }
    if (!nearest)
        return std::nullopt;
    const int inside = std::clamp(letter, nearest->from, nearest->to) - nearest->from;
    const auto bytes = text_.mid(nearest->from, inside).toUtf8().size();
    return places.placeOf(*nearest->run, static_cast<std::size_t>(bytes));
}

int BlockText::letterAt(std::size_t place) const {
    const RunPlaces places(document_.tree());
    const sgml::NodeId content = document_.tree().innermostAt(place);
    int nearest = 0;
    for (const Part& part : parts_) {
        if (isUnit(places, part)) {
            const text::Range own = places.rangeOf(*part.run);
            if (own.from >= place) {
                nearest = own.from == place ? part.from : nearest;
                break;
            }
            nearest = part.to;
        }
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

// A caret stands beside it, as in a line.
bool BlockText::isUnit(const RunPlaces& places, const Part& part) const {
    return block_->kind == model::BlockKind::text && places.isUnit(*part.run);
}

} // namespace reading

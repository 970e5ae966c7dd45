#include "manuscript/line_text.h"

#include "text/characters.h"

#include <algorithm>

namespace manuscript {

using sgml::NodeId;
using sgml::noNode;

namespace {

constexpr qsizetype most = 2000; // letters on each side
constexpr QChar unit(0xFFFC);

QString lettersOf(const std::string& text, bool isVerbatim) {
    QString letters = QString::fromStdString(text);
    return isVerbatim ? letters : letters.replace(u'\n', u' ');
}

} // namespace

LineText::LineText(const Manuscript& manuscript, std::size_t place)
    : tree_(manuscript.document.tree()), leaves_(manuscript, place) {
    const NodeId leaf = leaves_.isText() ? leaves_.at(place) : noNode;
    if (leaf == noNode)
        return;
    if (leaves_.isContent(leaf)) {
        const sgml::Unescaped content = tree_.unescaped(leaf);
        const std::string& text = content.text();
        const std::size_t at = content.textOffset(place), reach = static_cast<std::size_t>(most);
        const std::size_t from = text::characterStart(text, at - std::min(at, reach));
        const std::size_t to = text::characterStart(text, std::min(at + reach, text.size()));
        const bool isVerbatim = leaves_.isVerbatim(leaf);
        parts_.push_back({leaf, from, lettersOf(text.substr(from, to - from), isVerbatim)});
        place_ = lettersOf(text.substr(from, at - from), isVerbatim).size();
        if (from == 0)
            addBeside(leaf, Direction::backward);
        if (to == text.size())
            addBeside(leaf, Direction::forward);
    } else {
        parts_.push_back(partOf(leaf));
        place_ = place == leaves_.firstPlace(leaf) ? 0 : parts_.front().letters.size();
        addBeside(leaf, Direction::backward);
        addBeside(leaf, Direction::forward);
    }
    for (Part& part : parts_) {
        part.start = letters_.size();
        letters_ += part.letters;
    }
}

LineText::Part LineText::partOf(NodeId leaf) const {
    if (leaves_.isContent(leaf))
        return {leaf, 0, lettersOf(tree_.unescaped(leaf).text(), leaves_.isVerbatim(leaf))};
    return {leaf, 0, leaves_.isUnit(leaf) ? QString(unit) : QString()};
}

// The leaves of the line on that side of the one where the place is.
void LineText::addBeside(NodeId leaf, Direction direction) {
    const bool isForward = direction == Direction::forward;
    const NodeId block = leaves_.blockOf(leaf);
    for (qsizetype count = 0; count < most;) {
        leaf = leaves_.beside(leaf, direction);
        if (leaf == noNode || leaves_.blockOf(leaf) != block)
            break;
        Part part = partOf(leaf);
        count += part.letters.size() + 1;
        place_ += isForward ? 0 : part.letters.size();
        parts_.insert(isForward ? parts_.end() : parts_.begin(), std::move(part));
    }
}

std::optional<qsizetype> LineText::letterAt(std::size_t place) const {
    for (const Part& part : parts_) {
        if (place < leaves_.firstPlace(part.leaf) || place > leaves_.lastPlace(part.leaf))
            continue;
        if (!leaves_.isContent(part.leaf))
            return place == leaves_.firstPlace(part.leaf) ? part.start : part.end();
        const sgml::Unescaped content = tree_.unescaped(part.leaf);
        const std::size_t at = content.textOffset(place);
        if (at < part.from)
            return std::nullopt;
        const std::string before = content.text().substr(part.from, at - part.from);
        const qsizetype letters = QString::fromStdString(before).size();
        return letters > part.letters.size() ? std::nullopt : std::optional(part.start + letters);
    }
    return std::nullopt;
}

std::size_t LineText::placeIn(const Part& part, qsizetype letter) const {
    const qsizetype inside = letter - part.start;
    if (!leaves_.isContent(part.leaf))
        return inside == 0 ? leaves_.firstPlace(part.leaf) : leaves_.lastPlace(part.leaf);
    const auto bytes = static_cast<std::size_t>(part.letters.first(inside).toUtf8().size());
    return tree_.unescaped(part.leaf).fileOffset(part.from + bytes);
}

// Both in the same content where that is possible: it begins behind an end, and ends before a
// start.
Selection LineText::between(qsizetype from, qsizetype to) const {
    if (parts_.empty())
        return {};
    from = std::clamp<qsizetype>(from, 0, letters_.size());
    to = std::clamp<qsizetype>(to, from, letters_.size());
    const auto isBefore = [&](const Part& part) { return part.end() <= from; };
    auto first = std::ranges::find_if_not(parts_, isBefore);
    if (first == parts_.end())
        --first;
    const auto last = std::ranges::find_if(
        parts_, [&](const Part& part) { return part.end() >= to && part.start <= to; });
    if (from == to)
        return {placeIn(*last, to), placeIn(*last, to)};
    return {placeIn(*first, from), placeIn(*last, to)};
}

} // namespace manuscript

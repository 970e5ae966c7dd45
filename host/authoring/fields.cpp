#include "authoring/fields.h"
#include "manuscript/places.h"

#include "authoring/commands.h"
#include "manuscript/leaves.h"

namespace authoring {

using manuscript::Leaves, manuscript::placeBeside, manuscript::lineAround;

using schemas::ContainerRole;
using sgml::NodeId;
using sgml::noNode;

namespace {

// A line of text and the element that it is in.
struct FieldLine {
    Selection ends{};
    NodeId block = noNode;
    bool isOnlyLine = false; // its element takes one line only
    bool isField = false;    // such one that is no heading and no caption
    [[nodiscard]] bool isEmpty() const { return ends.isEmpty(); }
};

std::optional<FieldLine> lineAt(const Manuscript& manuscript, std::size_t place) {
    const Leaves leaves(manuscript, place);
    const NodeId leaf = leaves.isText() ? leaves.at(place) : noNode;
    if (leaf == noNode || leaves.isUnit(leaf))
        return std::nullopt;
    const sgml::Tree& tree = manuscript.document.tree();
    FieldLine line{.ends = lineAround(manuscript, place), .block = leaves.blockOf(leaf)};
    const Grammar& grammar = leaves.grammar();
    const Element& known = grammar.of(tree.name(line.block));
    const std::string_view paragraph = grammar.named(ContainerRole::paragraph);
    const bool isLine =
        known.kind == Kind::block && known.display == schemas::Display::block &&
        (known.role == ContainerRole::none || known.role == ContainerRole::heading ||
         known.role == ContainerRole::caption);
    line.isOnlyLine = isLine && known.holdsText && !paragraph.empty() &&
                      !grammar.whyNot(tree.name(line.block), {paragraph, paragraph}).isEmpty();
    line.isField = line.isOnlyLine && known.role == ContainerRole::none;
    return line;
}

std::optional<FieldLine> lineBeside(const Manuscript& manuscript, const FieldLine& line,
                                    Direction direction) {
    const std::size_t end = direction == Direction::forward ? line.ends.caret : line.ends.anchor;
    const std::optional<std::size_t> next =
        placeBeside(manuscript, end, direction, Unit::character);
    return next ? lineAt(manuscript, *next) : std::nullopt;
}

Step stepTo(std::size_t place, const QString& label) {
    return Step{.after = {place, place}, .label = label};
}

} // namespace

std::optional<Step> goToEmptyLine(const Manuscript& manuscript, Selection selection) {
    const auto line = selection.isEmpty() ? lineAt(manuscript, selection.caret) : std::nullopt;
    if (!line || !line->isOnlyLine || selection.caret != line->ends.caret)
        return std::nullopt;
    const std::optional<FieldLine> next = lineBeside(manuscript, *line, Direction::forward);
    if (!next || !next->isEmpty() || next->block == line->block)
        return std::nullopt;
    return stepTo(next->ends.anchor, QStringLiteral("New Paragraph"));
}

std::optional<Step> goToNextLine(const Manuscript& manuscript, Selection selection) {
    const std::size_t end = lineAround(manuscript, selection.caret).caret;
    const std::optional<std::size_t> next =
        placeBeside(manuscript, end, Direction::forward, Unit::character);
    if (!selection.isEmpty() || selection.caret != end || !next)
        return std::nullopt;
    return stepTo(*next, QStringLiteral("New Paragraph"));
}

Result goToField(const Manuscript& manuscript, Selection selection, Direction direction) {
    constexpr int mostLines = 100;
    std::optional<FieldLine> line = lineAt(manuscript, selection.caret);
    const auto before = line ? lineBeside(manuscript, *line, Direction::backward) : std::nullopt;
    const bool isBehind = line && line->isEmpty() && before && before->isOnlyLine;
    if (!line || (!line->isOnlyLine && !isBehind))
        return refused(QStringLiteral("The caret is in no field."));
    for (int i = 0; i < mostLines; ++i) {
        line = lineBeside(manuscript, *line, direction);
        if (!line)
            break;
        if (line->isField || line->isEmpty())
            return stepTo(line->ends.caret, QStringLiteral("Next Field"));
    }
    return refused(direction == Direction::forward ? QStringLiteral("No field follows.")
                                                   : QStringLiteral("No field is before this."));
}

} // namespace authoring

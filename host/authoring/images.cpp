#include "authoring/images.h"

#include "authoring/commands.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using manuscript::Direction;
using schemas::ContainerRole;
using schemas::Display;

namespace {

std::unique_ptr<Piece> madeImage(const std::string& name, const NewImage& image) {
    std::string attributes = " " + sgml::attributeText("FILE", image.file);
    if (image.width > 0)
        attributes += " " + sgml::attributeText("WIDTH", std::to_string(image.width));
    if (!image.alternative.empty())
        attributes += " " + sgml::attributeText("ALT", image.alternative);
    return Draft::made(name, attributes);
}

// In a figure of its own, with its caption; null: none may stand there. Who stood at the end of a
// line writes on behind the figure.
Piece* putFigure(Draft& draft, const std::string& name, const NewImage& image) {
    const std::string figure(draft.grammar().named(ContainerRole::figure));
    const std::string caption(draft.grammar().named(ContainerRole::caption));
    if (figure.empty() || !draft.grammar().mayHold(figure, name))
        return nullptr;
    const bool isAtEnd = draft.isLineBlank(draft.first(), Direction::forward);
    Piece* made = putBlock(draft, draft.first(), Draft::made(figure));
    if (made == nullptr)
        return nullptr;
    if (Piece* line = isAtEnd ? paragraphBehind(draft, *made) : nullptr)
        Draft::moveTo(draft.first(), *line, 0);
    Piece& picture = Draft::put(*made, 0, madeImage(name, image));
    if (!image.caption.empty() && draft.grammar().mayHold(figure, caption)) {
        Piece& line = Draft::put(*made, 1, Draft::made(caption));
        line.gap.fresh = "\n";
        Draft::put(line, 0, Draft::madeText(image.caption));
    }
    return &picture;
}

} // namespace

Result insertImage(const Manuscript& manuscript, Selection selection, const NewImage& image) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(Display::image));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no images."));
    Piece* made = image.isInLine ? nullptr : putFigure(draft, name, image);
    if (made == nullptr) {
        made = putInLine(draft, draft.first(), madeImage(name, image));
        if (made == nullptr)
            return refused(QStringLiteral("An image may not stand here."));
        Draft::moveTo(draft.first(), *made->parent, made->index() + 1);
    }
    draft.collapse();
    return draft.result(QStringLiteral("Image"));
}

} // namespace authoring

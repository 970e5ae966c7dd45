#include "view/chosen_figure.h"

#include "clipboard/copying.h"
#include "manuscript/places.h"
#include "view/document_view.h"
#include "view/text_hand.h"
#include "view/writing.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>

namespace view {

using authoring::Direction;

std::optional<text::Range> ChosenFigure::range() const {
    const document::Document& document = view_.document().document();
    const document::Subdocument* figure = document.subdocument(view_.chosen());
    if (!figure)
        return std::nullopt;
    const sgml::NodeId whole =
        authoring::wholeFigure(view_.writing().manuscript(), figure->element);
    return document.tree().node(whole).range;
}

// Other programs get its picture.
void ChosenFigure::copy() const {
    view_.settle();
    const std::optional<text::Range> all = range();
    if (!all || !view_.model())
        return;
    std::unique_ptr<QMimeData> copy = copied(view_.document().document(), *view_.model(), *all);
    const media::Rendition* of = view_.rendition(view_.chosen());
    if (of && !of->picture().isNull())
        copy->setImageData(of->picture());
    QApplication::clipboard()->setMimeData(copy.release());
}

void ChosenFigure::erase() {
    const document::Subdocument* figure = view_.document().document().subdocument(view_.chosen());
    if (!figure)
        return;
    view_.writing().perform([figure](const authoring::Manuscript& in, authoring::Selection) {
        return authoring::removeElement(in, authoring::wholeFigure(in, figure->element),
                                        DocumentView::tr("Delete Figure"));
    });
}

bool ChosenFigure::useKey(int key, Qt::KeyboardModifiers modifiers) {
    if (!view_.isWriting() || !range())
        return false;
    switch (key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        erase();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        view_.writing().perform(authoring::breakParagraph);
        return true;
    case Qt::Key_Left:
    case Qt::Key_Up:
    case Qt::Key_Right:
    case Qt::Key_Down:
        if (modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
            return false;
        goBeside(key == Qt::Key_Left || key == Qt::Key_Up ? Direction::backward
                                                          : Direction::forward);
        return true;
    default:
        return false;
    }
}

void ChosenFigure::leave() {
    const std::optional<text::Range> all = range();
    const auto at = view_.text().cursor().selection();
    const bool isInside = all && at && all->from <= at->caret && at->caret <= all->to;
    if (view_.isWriting() && all && !isInside)
        goBeside(Direction::forward);
    view_.choose(document::noSubdocument);
}

void ChosenFigure::goBeside(Direction side) {
    const std::optional<text::Range> all = range();
    if (!all)
        return;
    const authoring::Manuscript in = view_.writing().manuscript();
    const std::size_t end = side == Direction::forward ? all->to : all->from;
    const std::size_t place = manuscript::place(in, end, side).value_or(end);
    view_.choose(document::noSubdocument);
    view_.text().cursor().set({place, place});
    view_.text().showCaret();
}

std::optional<authoring::Selection> ChosenFigure::behind() const {
    const std::optional<text::Range> all = range();
    return all ? std::optional(authoring::Selection{all->to, all->to}) : std::nullopt;
}

} // namespace view

#include "view/composing.h"

#include "view/text_hand.h"
#include "view/writing.h"

#include <QApplication>
#include <QUuid>

namespace view {

using authoring::Manuscript, authoring::Selection;

void Composing::clear() {
    letters_.clear();
    step_.clear();
}

std::optional<manuscript::LineText> Composing::line() const {
    const std::optional<Selection> at = writing_.selection();
    return at ? std::optional<manuscript::LineText>(std::in_place, writing_.manuscript(), at->caret)
              : std::nullopt;
}

void Composing::take(const QInputMethodEvent& event) {
    const bool replaces = event.replacementLength() > 0;
    const bool types = !event.commitString().isEmpty();
    if (step_.isEmpty() && (!event.preeditString().isEmpty() || replaces))
        begin();
    letters_ = event.preeditString();
    caret_ = letters_.size();
    for (const QInputMethodEvent::Attribute& one : event.attributes())
        if (one.type == QInputMethodEvent::Cursor)
            caret_ = one.length == 0 ? std::nullopt
                                     : std::optional<qsizetype>(
                                           std::clamp<qsizetype>(one.start, 0, letters_.size()));
    if (replaces)
        replace(event.replacementStart(), event.replacementLength());
    if (types)
        writing_.type(event.commitString(), isLastStep() ? step_ : QString());
    else if (letters_.isEmpty() && !replaces && isLastStep())
        writing_.takeBack();
    if (types || letters_.isEmpty()) // letters that were typed stay, whatever is composed next
        step_.clear();
}

void Composing::begin() {
    step_ = QUuid::createUuid().toString();
    if (hand_.cursor().selects())
        writing_.perform(
            [](const Manuscript& in, Selection at) {
                return authoring::erase(in, at, authoring::Direction::forward);
            },
            step_);
}

// It has changed something, and nobody else has since then.
bool Composing::isLastStep() const {
    return !step_.isEmpty() && writing_.manuscript().document.lastGroup() == step_;
}

// Letters are counted from the caret, to both sides.
void Composing::replace(qsizetype from, qsizetype length) {
    const std::optional<manuscript::LineText> around = line();
    if (!around)
        return;
    const qsizetype first = around->place() + from;
    const Selection part = around->between(first, first + length);
    if (part.isEmpty())
        return;
    writing_.perform(
        [part](const Manuscript& in, Selection) {
            return authoring::erase(in, part, authoring::Direction::forward);
        },
        step_);
}

QVariant Composing::answer(Qt::InputMethodQuery query) const {
    const bool isAsked = query == Qt::ImSurroundingText || query == Qt::ImCursorPosition ||
                         query == Qt::ImAnchorPosition || query == Qt::ImTextBeforeCursor ||
                         query == Qt::ImTextAfterCursor;
    const auto around = isAsked ? line() : std::nullopt;
    if (!around)
        return {};
    switch (query) {
    case Qt::ImSurroundingText:
        return around->letters();
    case Qt::ImTextBeforeCursor:
        return around->letters().first(around->place());
    case Qt::ImTextAfterCursor:
        return around->letters().sliced(around->place());
    case Qt::ImAnchorPosition:
        return static_cast<int>(
            around->letterAt(writing_.selection()->anchor).value_or(around->place()));
    default:
        return static_cast<int>(around->place());
    }
}

std::optional<QRectF> Composing::paint(QPainter& painter, QRectF caret, QColor ink,
                                       QColor paper) const {
    if (letters_.isEmpty())
        return caret;
    constexpr double sizeOfLetters = 0.7; // of the caret's height
    QFont font = QApplication::font();
    font.setPixelSize(static_cast<int>(caret.height() * sizeOfLetters));
    font.setUnderline(true);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    QRectF room = caret;
    room.setWidth(metrics.horizontalAdvance(letters_));
    painter.fillRect(room, paper);
    painter.setPen(ink);
    painter.drawText(room, Qt::AlignVCenter | Qt::TextDontClip, letters_);
    if (!caret_)
        return std::nullopt;
    caret.translate(metrics.horizontalAdvance(letters_.first(*caret_)), 0);
    return caret;
}

} // namespace view

// The letters that an input method composes at the caret: not typed yet, in place of others, with
// the text around them that it asks for.
#pragma once

#include "manuscript/line_text.h"

#include <QInputMethodEvent>
#include <QPainter>

namespace view {

class TextHand;
class Writing;

class Composing {
public:
    // Both outlive it.
    Composing(Writing& writing, TextHand& hand) : writing_(writing), hand_(hand) {}

    // The selected text goes when composing begins, and comes back if nothing is typed in its
    // place. Letters beside the caret that are to be replaced are those of its line. All that one
    // composition changes is one step of undo.
    void take(const QInputMethodEvent& event);
    void clear();
    [[nodiscard]] bool isOn() const { return !letters_.isEmpty(); }
    // Of the text around the caret; not valid: another query.
    [[nodiscard]] QVariant answer(Qt::InputMethodQuery query) const;
    // The composed letters at a caret's place. The place of their own caret; nothing: it is hidden.
    // LIMIT: they cover what follows until they are typed.
    [[nodiscard]] std::optional<QRectF> paint(QPainter& painter, QRectF caret, QColor ink,
                                              QColor paper) const;

private:
    void begin();
    [[nodiscard]] bool isLastStep() const;
    void replace(qsizetype from, qsizetype length);
    [[nodiscard]] std::optional<manuscript::LineText> line() const;

    Writing& writing_;
    TextHand& hand_;
    QString letters_;
    std::optional<qsizetype> caret_; // among them; nothing: it is hidden
    QString step_;                   // the group of its steps of undo; "": there is none
};

} // namespace view

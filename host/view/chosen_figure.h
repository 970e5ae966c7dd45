// The figure that is chosen in a view, as a whole: copied and erased with its caption, and left for
// the text around it.
//
// Keys go to its medium first. Keys that the medium sends back are used here: in a writing view
// arrows and Escape lead into the text, and Return begins a paragraph behind the figure.
#pragma once

#include "authoring/authoring.h"

namespace view {

class DocumentView;

class ChosenFigure {
public:
    // The view outlives it.
    explicit ChosenFigure(DocumentView& view) : view_(view) {}

    void copy() const;
    void erase();
    // Of a writing view; false: the key is for something else.
    bool useKey(int key, Qt::KeyboardModifiers modifiers);
    // No figure is chosen then. In a writing view the caret goes beside it, unless it stands in it,
    // as in a new one's caption.
    void leave();
    // The place behind it and its caption; nothing: no figure is chosen.
    [[nodiscard]] std::optional<authoring::Selection> behind() const;

private:
    [[nodiscard]] std::optional<text::Range> range() const; // with the caption; nothing: none
    void goBeside(authoring::Direction side);

    DocumentView& view_;
};

} // namespace view

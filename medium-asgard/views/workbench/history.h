// The changes of a text that can be taken back, and those that were: steps of undo with labels.
// Each knows what was selected before and after it.
#pragma once

#include "editing/element.h"
#include "text/edit.h"

#include <QString>

#include <string>
#include <vector>

namespace views {

class History {
public:
    using Selected = std::vector<editing::Element>;
    struct Step {
        std::string text;
        Selected selected;
    };

    // A change of that text; what was taken back before it is forgotten.
    void add(const std::string& before, const text::Edit& edit, const QString& label,
             const Selected& selected);
    void clear();

    [[nodiscard]] bool canUndo() const { return !done_.empty(); }
    [[nodiscard]] bool canRedo() const { return !undone_.empty(); }
    // Of the next undo, and the next redo; "": there is none.
    [[nodiscard]] QString undoLabel() const;
    [[nodiscard]] QString redoLabel() const;
    // The text without its last change, or with the one that was taken back last: itself where
    // there is none.
    // `selected`: now.
    [[nodiscard]] Step undone(const std::string& text, const Selected& selected);
    [[nodiscard]] Step redone(const std::string& text, const Selected& selected);

private:
    struct Change {
        text::Edit forward, backward;
        QString label;
        Selected before, after;
    };
    static void move(std::vector<Change>& from, std::vector<Change>& to);

    std::vector<Change> done_, undone_;
};

} // namespace views

// The changes of a text that can be taken back, and those that were: steps of undo with labels.
#pragma once

#include "text/edit.h"

#include <QString>

#include <string>
#include <vector>

namespace views {

class History {
public:
    // A change of that text; what was taken back before it is forgotten.
    void add(const std::string& before, const text::Edit& edit, const QString& label);
    void clear();

    [[nodiscard]] bool canUndo() const { return !done_.empty(); }
    [[nodiscard]] bool canRedo() const { return !undone_.empty(); }
    // Of the next undo, and the next redo; "": there is none.
    [[nodiscard]] QString undoLabel() const;
    [[nodiscard]] QString redoLabel() const;
    // The text without its last change, or with the one that was taken back last: itself where
    // there is none.
    [[nodiscard]] std::string undone(const std::string& text);
    [[nodiscard]] std::string redone(const std::string& text);

private:
    struct Change {
        text::Edit forward, backward;
        QString label;
    };
    static void move(std::vector<Change>& from, std::vector<Change>& to);

    std::vector<Change> done_, undone_;
};

} // namespace views

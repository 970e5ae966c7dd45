// The caret and the other end of what is selected, as places in a document's bytes; the note that
// an author's edit leaves on the stack of undo.
#pragma once

#include <QString>

#include <chrono>
#include <cstddef>
#include <optional>

namespace document {

struct Selection {
    std::size_t anchor = 0, caret = 0;
    [[nodiscard]] bool isEmpty() const { return anchor == caret; }
    bool operator==(const Selection&) const = default;
};

struct EditNote {
    QString label; // of the step, for the menu: "Typing"
    // Edits with the same group that follow each other are one step.
    QString group{};
    // The author's selection. Undo restores the one before a step, redo the one after it.
    std::optional<Selection> before{}, after{};
    // When it was typed, by a clock of the caller's; nothing: it is a step of its own. It joins the
    // step before if that one was typed, has the same label, ended where this one begins, and is
    // younger than typingPause.
    std::optional<std::chrono::milliseconds> typed{};
};

inline constexpr std::chrono::milliseconds typingPause{1000};

} // namespace document

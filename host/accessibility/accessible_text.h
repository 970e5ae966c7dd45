// The text of one block for screen readers: letters, caret, what is selected, looks, places.
#pragma once

#include "accessibility/accessible_part.h"
#include "places/carets.h"
#include "reading/block_text.h"

namespace accessibility {

class AccessibleText : public AccessiblePart, public QAccessibleTextInterface {
public:
    AccessibleText(AccessibleView& root, reading::Part& part) : AccessiblePart(root, part) {}

    [[nodiscard]] void* interface_cast(QAccessible::InterfaceType type) override;

    void selection(int index, int* start, int* end) const override;
    [[nodiscard]] int selectionCount() const override;
    void addSelection(int start, int end) override;
    void removeSelection(int index) override;
    void setSelection(int index, int start, int end) override;
    [[nodiscard]] int cursorPosition() const override; // -1: the caret is elsewhere
    void setCursorPosition(int position) override;
    [[nodiscard]] QString text(int start, int end) const override;
    using AccessiblePart::text;
    [[nodiscard]] QString textBeforeOffset(int offset, QAccessible::TextBoundaryType boundary,
                                           int* start, int* end) const override;
    [[nodiscard]] QString textAfterOffset(int offset, QAccessible::TextBoundaryType boundary,
                                          int* start, int* end) const override;
    [[nodiscard]] QString textAtOffset(int offset, QAccessible::TextBoundaryType boundary,
                                       int* start, int* end) const override;
    [[nodiscard]] int characterCount() const override;
    [[nodiscard]] QRect characterRect(int offset) const override;
    [[nodiscard]] int offsetAtPoint(const QPoint& point) const override;
    void scrollToSubstring(int start, int end) override;
    [[nodiscard]] QString attributes(int offset, int* start, int* end) const override;
    [[nodiscard]] QRect rect() const override;

private:
    [[nodiscard]] const reading::BlockText& letters() const;
    [[nodiscard]] places::Carets carets() const;
    [[nodiscard]] std::optional<places::Caret> caretAt(int letter) const;
    // A line of the page around a letter.
    struct Line {
        int from = 0, to = 0;
    };
    [[nodiscard]] Line lineAt(int letter) const;
    QString give(Line line, int* start, int* end) const;

    mutable std::unique_ptr<reading::BlockText> letters_;
};

} // namespace accessibility

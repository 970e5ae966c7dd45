// A document's pages for screen readers: its text, the caret, what is selected.
//
// LIMIT: they are told of the caret and of what is selected, and read the text anew where they
// want it: no event tells which letters came or went.
#pragma once

#include "view/shown_text.h"

#include <QAccessible>
#include <QAccessibleWidget>

namespace view {

class DocumentView;

class AccessibleView : public QAccessibleWidget, public QAccessibleTextInterface {
public:
    explicit AccessibleView(DocumentView& view);
    // Views are accessible from now on. To be called often.
    static void install();
    // The caret or what is selected has changed.
    static void tell(DocumentView& view);

    [[nodiscard]] void* interface_cast(QAccessible::InterfaceType type) override;
    [[nodiscard]] QAccessible::State state() const override;

    void selection(int index, int* start, int* end) const override;
    [[nodiscard]] int selectionCount() const override;
    void addSelection(int start, int end) override;
    void removeSelection(int index) override;
    void setSelection(int index, int start, int end) override;
    [[nodiscard]] int cursorPosition() const override;
    void setCursorPosition(int position) override;
    [[nodiscard]] QString text(int start, int end) const override;
    [[nodiscard]] QString text(QAccessible::Text of) const override;
    [[nodiscard]] int characterCount() const override;
    [[nodiscard]] QRect characterRect(int offset) const override;
    [[nodiscard]] int offsetAtPoint(const QPoint& point) const override;
    void scrollToSubstring(int start, int end) override;
    [[nodiscard]] QString attributes(int offset, int* start, int* end) const override;

private:
    [[nodiscard]] DocumentView& view() const;
    [[nodiscard]] const ShownText& shown() const;

    mutable std::unique_ptr<ShownText> shown_;
};

} // namespace view

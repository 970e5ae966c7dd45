// A document's pages for screen readers: a tree of parts (reading/reading_tree.h), and events of
// what changes in it.
//
// A part of text has the focus where the caret is in it, as in word processors; a figure, where it
// is chosen. Events are told when the pages have followed an edit, of parts that somebody asked for
// and of that with the caret.
#pragma once

#include "reading/reading_tree.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <functional>

namespace view {
class DocumentView;
}

namespace accessibility {

class AccessibleView : public QAccessibleWidget {
public:
    // Views have one from now on, made when somebody asks for it. To be called before the first
    // view is made: who asks for one earlier gets that of any widget.
    static void install();
    explicit AccessibleView(view::DocumentView& view);
    // Hears each event, for tests: Qt drops them where there is no accessibility bus.
    static std::function<void(QAccessibleEvent&)> heard;

    [[nodiscard]] view::DocumentView& view() const;
    // That of the pages as they are now.
    [[nodiscard]] reading::ReadingTree& tree() const;
    [[nodiscard]] QAccessibleInterface* interfaceOf(reading::Part* part) const; // null for null
    // The part with the caret, or the figure that is chosen; null: none.
    [[nodiscard]] reading::Part* focused() const;

    [[nodiscard]] QAccessible::State state() const override;
    [[nodiscard]] QAccessibleInterface* child(int index) const override;
    [[nodiscard]] int childCount() const override;
    [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override;
    [[nodiscard]] QAccessibleInterface* childAt(int x, int y) const override;
    [[nodiscard]] QAccessibleInterface* focusChild() const override;

private:
    // The pages have changed, the caret, what is selected or what has the keys.
    void tell();
    static void send(QAccessibleEvent& event);
    void tellChange(reading::Part& part, const std::shared_ptr<const model::Block>& before) const;
    void tellCaret();

    mutable reading::ReadingTree tree_;
    struct Told { // last, of the caret and what is selected
        QAccessible::Id part = 0;
        bool hadFocus = false;
        int caret = -1, from = 0, to = 0;
        bool operator==(const Told&) const = default;
    };
    Told told_;
};

} // namespace accessibility

// The caret of a view and the other end of what is selected: two places of the document, which
// follow its edits, and how keys and pointer move them over the pages.
#pragma once

#include "document/selection.h"
#include "document/tracker.h"
#include "places/carets.h"

#include <QObject>

namespace view {

class TextCursor : public QObject {
    Q_OBJECT

public:
    // The document outlives it.
    explicit TextCursor(const document::Document& document);

    // Nothing: nobody has clicked in the text yet.
    [[nodiscard]] std::optional<document::Selection> selection() const;
    [[nodiscard]] text::Range interval() const; // what is selected; empty without a selection
    [[nodiscard]] bool selects() const { return !interval().empty(); }
    void set(document::Selection selection);
    void clear();

    // The caret on pages of the document. It is looked for from page() on to both sides.
    [[nodiscard]] std::optional<places::Caret> caret(const places::Carets& carets) const;
    [[nodiscard]] std::size_t page() const { return page_; } // where it was last seen
    void move(const places::Carets& carets, places::Move move, bool extend);
    void moveTo(const places::Carets& carets, const places::Caret& caret, bool extend);
    void selectAll(const places::Carets& carets);

    // By how much a pointer selects at a time.
    enum class Unit { letter, word, paragraph };
    void press(const places::Carets& carets, const places::Caret& at, Unit unit, bool extend);
    void drag(const places::Carets& carets, const places::Caret& at);

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] document::Selection around(const places::Carets& carets, const places::Caret& at,
                                             Unit unit) const;

    document::Tracker tracker_;
    std::shared_ptr<const document::Tracker::Place> anchor_, caret_; // both or none
    mutable std::size_t page_ = 0;
    std::optional<double> wish_;        // where it would like to be, going up and down
    Unit unit_ = Unit::letter;          // of the pointer's selection
    document::Selection pressed_{0, 0}; // what it began with
};

} // namespace view

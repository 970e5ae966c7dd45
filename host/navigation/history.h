// The places that a reader has jumped from, to go back to, and forward again. They follow the
// edits of the document.
#pragma once

#include "document/tracker.h"
#include "view/document_view.h"

namespace navigation {

class History : public QObject {
    Q_OBJECT

public:
    // The view outlives it.
    explicit History(view::DocumentView& view, QObject* parent = nullptr);

    [[nodiscard]] bool canGoBack() const { return !back_.empty(); }
    [[nodiscard]] bool canGoForward() const { return !forward_.empty(); }
    void goBack() { go(back_, forward_); }
    void goForward() { go(forward_, back_); }

    static constexpr std::size_t most = 100; // places; the oldest ones are forgotten

Q_SIGNALS:
    void changed();

private:
    struct Stop {
        std::shared_ptr<const document::Tracker::Place> place;
        double below = 0; // ReadingPlace
    };
    using Stops = std::vector<Stop>;
    [[nodiscard]] std::optional<Stop> here();
    void leave(bool isSearch);
    void go(Stops& from, Stops& to);

    view::DocumentView& view_;
    document::Tracker tracker_;
    Stops back_, forward_;
    // The place of the last hit of a search: the next one joins its jump if the view is still
    // there.
    std::optional<int> searched_;
    bool isSearch_ = false;
};

} // namespace navigation

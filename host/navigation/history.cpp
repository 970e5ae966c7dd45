#include "navigation/history.h"

#include <QScrollBar>

namespace navigation {

History::History(view::DocumentView& view, QObject* parent)
    : QObject(parent), view_(view), tracker_(view.document().document()) {
    connect(&view_, &view::DocumentView::jumping, this, &History::leave);
    connect(&view_, &view::DocumentView::jumped, this, [this] {
        searched_ = isSearch_ ? std::optional(view_.verticalScrollBar()->value()) : std::nullopt;
    });
}

std::optional<History::Stop> History::here() {
    const std::optional<view::ReadingPlace> place = view_.readingPlace();
    if (!place)
        return std::nullopt;
    return Stop{tracker_.track(place->place, text::Gravity::behind), place->below};
}

void History::leave(bool isSearch) {
    isSearch_ = isSearch;
    if (isSearch && searched_ == view_.verticalScrollBar()->value())
        return;
    std::optional<Stop> stop = here();
    if (!stop)
        return;
    back_.push_back(*std::move(stop));
    if (back_.size() > most)
        back_.erase(back_.begin());
    forward_.clear();
    Q_EMIT changed();
}

void History::go(Stops& from, Stops& to) {
    if (from.empty())
        return;
    view_.settle();
    const Stop stop = std::move(from.back());
    from.pop_back();
    if (std::optional<Stop> left = here())
        to.push_back(*std::move(left));
    view_.show({stop.place->offset, stop.below});
    searched_.reset();
    Q_EMIT changed();
}

} // namespace navigation

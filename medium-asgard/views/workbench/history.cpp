#include "workbench/history.h"

#include <utility>

namespace views {

void History::add(const std::string& before, const text::Edit& edit, const QString& label) {
    done_.push_back({edit, text::inverse(before, {edit}).front(), label});
    undone_.clear();
}

void History::clear() {
    done_.clear();
    undone_.clear();
}

QString History::undoLabel() const { return done_.empty() ? QString() : done_.back().label; }

QString History::redoLabel() const { return undone_.empty() ? QString() : undone_.back().label; }

void History::move(std::vector<Change>& from, std::vector<Change>& to) {
    to.push_back(std::move(from.back()));
    from.pop_back();
}

std::string History::undone(const std::string& text) {
    if (done_.empty())
        return text;
    move(done_, undone_);
    return text::applied(text, {undone_.back().backward});
}

std::string History::redone(const std::string& text) {
    if (undone_.empty())
        return text;
    move(undone_, done_);
    return text::applied(text, {done_.back().forward});
}

} // namespace views

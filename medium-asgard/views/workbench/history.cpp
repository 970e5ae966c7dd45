#include "workbench/history.h"

#include <utility>

namespace views {

void History::add(const std::string& before, const text::Edit& edit, const QString& label,
                  const Selected& selected) {
    done_.push_back({edit, text::inverse(before, {edit}).front(), label, selected, {}});
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

History::Step History::undone(const std::string& text, const Selected& selected) {
    if (done_.empty())
        return {text, selected};
    move(done_, undone_);
    Change& change = undone_.back();
    change.after = selected;
    return {text::applied(text, {change.backward}), change.before};
}

History::Step History::redone(const std::string& text, const Selected& selected) {
    if (undone_.empty())
        return {text, selected};
    move(undone_, done_);
    const Change& change = done_.back();
    return {text::applied(text, {change.forward}), change.after};
}

} // namespace views

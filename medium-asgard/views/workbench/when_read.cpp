#include "workbench/when_read.h"

#include "editing/changes.h"

#include <utility>

namespace views {

using editing::Element;

Follow following(const SceneDocument& document, const std::vector<Element>& elements) {
    return [&document, elements, scene = document.shown().scene,
            text = document.shownText()]() -> std::optional<std::vector<Element>> {
        if (document.shown().scene == scene)
            return elements;
        const editing::Changes changes = editing::changesBetween(
            {text, *scene}, {document.shownText(), *document.shown().scene});
        std::vector<Element> now;
        for (const Element& element : elements)
            if (const auto after = changes.now(element))
                now.push_back(*after);
        return now.size() == elements.size() ? std::optional(now) : std::nullopt;
    };
}

WhenRead::WhenRead(SceneDocument& document) : document_(document) {
    connect(&document_, &SceneDocument::wasRead, this, &WhenRead::next);
    connect(&document_, &SceneDocument::opened, this, [this] { later_.clear(); });
}

void WhenRead::take(const QObject* origin, std::function<void()> act) {
    std::erase_if(later_, [&](const Later& one) { // the newest counts
        return one.origin == origin && one.selected == document_.selected();
    });
    later_.push_back({origin, document_.selected(), std::move(act)});
    next();
}

void WhenRead::next() {
    while (!later_.empty() && !document_.isAwaited()) {
        const Later first = std::move(later_.front());
        later_.erase(later_.begin());
        first.act();
    }
}

} // namespace views

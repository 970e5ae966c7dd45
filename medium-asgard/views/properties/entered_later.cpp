#include "properties/entered_later.h"

#include "editing/changes.h"

#include <utility>

namespace views {

using editing::Element;

EnteredLater::EnteredLater(SceneDocument& document) : document_(document) {
    for (const auto signal : {&SceneDocument::sceneChanged, &SceneDocument::workChanged})
        connect(&document_, signal, this, &EnteredLater::next);
    connect(&document_, &SceneDocument::opened, this, [this] { later_.clear(); });
}

EnteredLater::Follow EnteredLater::following(const std::vector<Element>& elements) const {
    return [this, elements, scene = document_.shown().scene,
            text = document_.shownText()]() -> std::optional<std::vector<Element>> {
        if (document_.shown().scene == scene)
            return elements;
        const editing::Changes changes = editing::changesBetween(
            {text, *scene}, {document_.shownText(), *document_.shown().scene});
        std::vector<Element> now;
        for (const Element& element : elements)
            if (const auto after = changes.now(element))
                now.push_back(*after);
        return now.size() == elements.size() ? std::optional(now) : std::nullopt;
    };
}

void EnteredLater::take(const QObject* field, std::function<void()> enter) {
    std::erase_if(later_, [&](const Later& one) { // the newest value counts
        return one.field == field && one.elements == document_.selected();
    });
    later_.push_back({field, document_.selected(), std::move(enter)});
    next();
}

void EnteredLater::next() {
    while (!later_.empty() && !document_.isAwaited()) {
        const Later first = std::move(later_.front());
        later_.erase(later_.begin());
        first.enter();
    }
}

} // namespace views

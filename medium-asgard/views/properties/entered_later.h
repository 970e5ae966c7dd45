// Values that are entered while the text is being read: they are taken when it is, one after the
// other, for the elements that were selected when they were entered.
#pragma once

#include "workbench/scene_document.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace views {

class EnteredLater : public QObject {
    Q_OBJECT
public:
    explicit EnteredLater(SceneDocument& document); // which outlives it

    // Elements of the scene that is shown now, and what they are in a later one; none: one of them
    // is gone.
    using Follow = std::function<std::optional<std::vector<editing::Element>>()>;
    [[nodiscard]] Follow following(const std::vector<editing::Element>& elements) const;

    // At once where no text is being read. Of one field and the same elements the newest counts.
    void take(const QObject* field, std::function<void()> enter);

private:
    void next();

    struct Later {
        const QObject* field;
        std::vector<editing::Element> elements;
        std::function<void()> enter;
    };
    SceneDocument& document_;
    std::vector<Later> later_;
};

} // namespace views

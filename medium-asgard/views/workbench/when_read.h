// Actions that wait for the scene of the text. While a text is being read they stand in a row; then
// they run, one after the other, for the elements that they were meant for, whose places in the
// scene may be others by then.
#pragma once

#include "workbench/scene_document.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace views {

// Elements of the scene that was shown, as they are in the scene that is shown now; none: one of
// them is gone.
using Follow = std::function<std::optional<std::vector<editing::Element>>()>;
// The document outlives it.
[[nodiscard]] Follow following(const SceneDocument& document,
                               const std::vector<editing::Element>& elements);

class WhenRead : public QObject {
    Q_OBJECT
public:
    explicit WhenRead(SceneDocument& document); // which outlives it

    // At once where no text is being read. Of one origin and the same selection the newest counts.
    void take(const QObject* origin, std::function<void()> act);

private:
    void next();

    struct Later {
        const QObject* origin;
        std::vector<editing::Element> selected;
        std::function<void()> act;
    };
    SceneDocument& document_;
    std::vector<Later> later_;
};

} // namespace views

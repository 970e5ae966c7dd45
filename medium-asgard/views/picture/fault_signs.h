// Triangles at the bodies and joints that faults of the text are about. Faults of the motion, which
// have a time, are on the bar of times.
#pragma once

#include "workbench/scene_document.h"

#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace views {

class SceneDisplay;

class FaultSigns {
public:
    FaultSigns(SceneDocument& document, SceneDisplay& display);

    struct Sign {
        QPointF place; // the middle of the triangle
        bool isError = false;
        QString words;
    };
    [[nodiscard]] std::vector<Sign> signs() const;
    [[nodiscard]] std::optional<Sign> at(const QPointF& position) const;
    void paint(QPainter& painter) const;

private:
    struct Fault {
        editing::Element element;
        bool isError;
        QString words;
    };
    [[nodiscard]] const std::vector<Fault>& faults() const;
    [[nodiscard]] std::optional<geometry::Vector> placeOf(const editing::Element& element) const;

    SceneDocument& document_;
    SceneDisplay& display_;
    mutable std::optional<std::vector<Fault>> faults_; // of the text; none: to be found anew
};

} // namespace views

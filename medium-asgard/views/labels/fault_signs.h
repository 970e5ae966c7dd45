// Triangles at the bodies and joints that faults of the text are about; of two bodies that overlap,
// where they do. Faults of the motion, which have a time, are on the bar of times.
#pragma once

#include "labels/seen_picture.h"
#include "workbench/scene_document.h"

#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace views {

class FaultSigns {
public:
    FaultSigns(SceneDocument& document, SeenPicture& picture);

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
        std::optional<std::size_t> other = {}; // the second body that it is about
    };
    [[nodiscard]] const std::vector<Fault>& faults() const;
    [[nodiscard]] std::optional<geometry::Vector> placeOf(const Fault& fault) const;
    [[nodiscard]] std::optional<geometry::Vector> placeOfBody(std::size_t body) const;
    [[nodiscard]] double reachOf(std::size_t body) const;

    SceneDocument& document_;
    SeenPicture& picture_;
    mutable std::optional<std::vector<Fault>> faults_; // of the text; none: to be found anew
};

} // namespace views

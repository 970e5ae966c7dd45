#include "picture/fault_signs.h"

#include "editing/changes.h"
#include "framing/joint_places.h"
#include "picture/scene_display.h"

#include <QLineF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace views {

using editing::Kind;

namespace {

constexpr double half = 8, above = 14, near = 11; // points
constexpr std::size_t most = 60;                  // LIMIT: of more, the first

} // namespace

FaultSigns::FaultSigns(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display) {
    for (const auto signal : {&SceneDocument::sceneChanged, &SceneDocument::diagnosticsChanged})
        QObject::connect(&document_, signal, &display_, [this] {
            faults_.reset();
            display_.update();
        });
}

const std::vector<FaultSigns::Fault>& FaultSigns::faults() const {
    if (faults_)
        return *faults_;
    faults_.emplace();
    if (!document_.sceneIsCurrent())
        return *faults_;
    for (const scene::Diagnostic& one : document_.diagnostics()) {
        if (one.time)
            continue;
        for (const editing::Element& element :
             editing::elementsAt(*document_.shown().scene, one.range))
            if ((element.kind == Kind::body || element.kind == Kind::joint) &&
                faults_->size() < most)
                faults_->push_back({element, one.severity == scene::Severity::error,
                                    QString::fromStdString(one.message)});
    }
    return *faults_;
}

std::optional<geometry::Vector> FaultSigns::placeOf(const editing::Element& element) const {
    const Shown& shown = document_.shown();
    const scene::Scene& scene = *shown.scene;
    if (element.kind == Kind::body)
        return element.index < scene.bodies.size() &&
                       !render::isHidden(display_.display(), scene.bodies[element.index])
                   ? std::optional(display_.centerOf(element.index))
                   : std::nullopt;
    if (element.index >= scene.joints.size())
        return std::nullopt;
    const render::Drawing drawn = display_.drawn();
    const auto place =
        render::JointPlaces(scene, drawn.motion.get()).at(scene.joints[element.index], drawn.time);
    return place ? std::optional(place->ends[0].point) : std::nullopt;
}

std::vector<FaultSigns::Sign> FaultSigns::signs() const {
    std::vector<Sign> signs;
    for (const Fault& fault : faults()) {
        const auto place = placeOf(fault.element);
        if (!place || display_.sight().depth(*place) >= render::eyeOf(display_.camera()))
            continue;
        const QPointF at = display_.fromPixels(display_.sight().pixels(*place)) - QPointF(0, above);
        const auto same = std::ranges::find_if(
            signs, [&](const Sign& other) { return QLineF(other.place, at).length() < near; });
        if (same == signs.end()) {
            signs.push_back({at, fault.isError, fault.words});
        } else if (!same->words.contains(fault.words)) {
            same->isError = same->isError || fault.isError;
            same->words += '\n' + fault.words;
        }
    }
    return signs;
}

std::optional<FaultSigns::Sign> FaultSigns::at(const QPointF& position) const {
    for (const Sign& sign : signs())
        if (QLineF(sign.place, position).length() < near)
            return sign;
    return std::nullopt;
}

void FaultSigns::paint(QPainter& painter) const {
    for (const Sign& sign : signs()) {
        painter.setPen(QPen(Qt::white, 1.2));
        painter.setBrush(sign.isError ? QColor(200, 40, 30) : QColor(226, 150, 20));
        painter.drawPolygon(
            QPolygonF({sign.place + QPointF(0, -half), sign.place + QPointF(half, half - 1),
                       sign.place + QPointF(-half, half - 1)}));
        painter.setPen(QPen(Qt::white, 1.8, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(sign.place + QPointF(0, -2.5), sign.place + QPointF(0, 2));
        painter.drawPoint(sign.place + QPointF(0, 5));
    }
}

} // namespace views

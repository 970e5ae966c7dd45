#include "labels/fault_signs.h"

#include "editing/changes.h"
#include "framing/joint_places.h"

#include <QLineF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace views {

using editing::Kind;

namespace {

constexpr double half = 8, above = 14, near = 11; // points
constexpr std::size_t most = 60;                  // LIMIT: of more, the first

// Faults quote the bodies that they are about: Bodies "a" and "b" overlap.
std::optional<std::size_t> otherBodyIn(const std::string& words, const scene::Scene& scene,
                                       std::size_t body) {
    for (std::size_t from = words.find('"'), to = 0; from != std::string::npos;
         from = words.find('"', to + 1)) {
        to = words.find('"', from + 1);
        if (to == std::string::npos)
            return std::nullopt;
        const std::string name = words.substr(from + 1, to - from - 1);
        const scene::Body* other = scene::findBody(scene, name);
        if (other != nullptr && name != scene.bodies[body].name)
            return static_cast<std::size_t>(other - scene.bodies.data());
    }
    return std::nullopt;
}

} // namespace

FaultSigns::FaultSigns(SceneDocument& document, SeenPicture& picture)
    : document_(document), picture_(picture) {
    for (const auto signal : {&SceneDocument::sceneChanged, &SceneDocument::diagnosticsChanged})
        QObject::connect(&document_, signal, &picture_.widget(), [this] {
            faults_.reset();
            picture_.widget().update();
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
                faults_->push_back(
                    {element, one.severity == scene::Severity::error,
                     QString::fromStdString(one.message),
                     element.kind == Kind::body
                         ? otherBodyIn(one.message, *document_.shown().scene, element.index)
                         : std::nullopt});
    }
    return *faults_;
}

std::optional<geometry::Vector> FaultSigns::placeOfBody(std::size_t body) const {
    const scene::Scene& scene = *document_.shown().scene;
    return body < scene.bodies.size() &&
                   !render::isHidden(picture_.drawn().display, scene.bodies[body])
               ? std::optional(picture_.centerOf(body))
               : std::nullopt;
}

// From its origin; a half space, of which nothing is outlined, has no end.
double FaultSigns::reachOf(std::size_t body) const {
    const scene::Scene& scene = *document_.shown().scene;
    double reach = 0;
    for (const render::Ball& ball : render::outlineOf(scene, scene.bodies[body]))
        reach = std::max(reach, ball.center.norm() + ball.radius);
    return reach > 0 ? reach : 1e9;
}

std::optional<geometry::Vector> FaultSigns::placeOf(const Fault& fault) const {
    const scene::Scene& scene = *document_.shown().scene;
    const editing::Element& element = fault.element;
    if (element.kind == Kind::body) {
        const auto first = placeOfBody(element.index);
        const auto second = fault.other ? placeOfBody(*fault.other) : std::nullopt;
        if (!first || !second)
            return first ? first : second;
        // The place at which two balls touch; of a ball on a wide floor, near the ball.
        const double reach = reachOf(element.index), others = reachOf(*fault.other);
        return geometry::Vector(*first + reach / (reach + others) * (*second - *first));
    }
    if (element.index >= scene.joints.size())
        return std::nullopt;
    const render::Drawing drawn = picture_.drawn();
    const auto place =
        render::JointPlaces(scene, drawn.motion.get()).at(scene.joints[element.index], drawn.time);
    return place ? std::optional(place->ends[0].point) : std::nullopt;
}

std::vector<FaultSigns::Sign> FaultSigns::signs() const {
    std::vector<Sign> signs;
    for (const Fault& fault : faults()) {
        const auto place = placeOf(fault);
        if (!place || picture_.sight().depth(*place) >= render::eyeOf(picture_.sight().camera))
            continue;
        const QPointF at = picture_.fromPixels(picture_.sight().pixels(*place)) - QPointF(0, above);
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

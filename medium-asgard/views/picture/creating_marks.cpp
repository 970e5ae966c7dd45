// The marks of an element that is being made: its ghost, its place in words, the question.
#include "picture/creating.h"

#include "editing/number_text.h"
#include "gestures/wireframe.h"
#include "picture/scene_display.h"
#include "recipes/recipe_words.h"

#include <QPainter>

#include <algorithm>

namespace views {

void Creating::paintOutline(QPainter& painter, const Outline& outline) const {
    const gestures::Sight sight = display_.sight();
    painter.setPen(QPen(QColor(20, 90, 200, 170), 1.5));
    painter.setBrush(Qt::NoBrush);
    for (const auto& line : gestures::wireframeOf(outline.parts)) {
        QPolygonF drawn;
        for (const Vector& point : line)
            drawn.append(display_.fromPixels(sight.pixels(outline.pose.toWorld(point))));
        painter.drawPolyline(drawn);
    }
}

// The thing as it would be, and a ring where it was drawn to another one.
void Creating::paintGhost(QPainter& painter, const Indicated& next) const {
    const gestures::Sight sight = display_.sight();
    paintOutline(painter, {begun_->recipe().ghost, {next.point, next.attitude}});
    painter.setPen(QPen(QColor(20, 90, 200), 2));
    const QPointF place = display_.fromPixels(sight.pixels(next.point));
    painter.drawEllipse(place, 2, 2);
    if (!next.at.empty())
        painter.drawEllipse(place, 7, 7);
    painter.setBrush(QColor(255, 255, 255, 200));
}

void Creating::paintWords(QPainter& painter, const QPointF& place, const QString& words) const {
    QRectF box = painter.boundingRect(QRectF(place + QPointF(12, -22), QSizeF(1, 1)),
                                      Qt::AlignLeft | Qt::TextDontClip, words);
    const QRectF room = QRectF(display_.rect()).adjusted(4, 4, -4, -4); // read whole
    box.moveLeft(std::max(room.left(), std::min(box.left(), room.right() - box.width())));
    box.moveTop(std::max(room.top(), std::min(box.top(), room.bottom() - box.height())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 200));
    painter.drawRoundedRect(box.adjusted(-3, -1, 3, 1), 3, 3);
    painter.setPen(QColor(20, 90, 200));
    painter.drawText(box, Qt::AlignLeft | Qt::TextDontClip, words);
    painter.setPen(QPen(QColor(20, 90, 200), 2));
}

// "0.5 1 0, a corner of b1; 1.12 from the point before"
QString Creating::wordsOf(const Indicated& next) const {
    const double pixel = display_.sight().pixelLength(next.point);
    const std::string place = listed(next.point, std::max(next.resolution, 0.1 * pixel));
    QString words = QString::fromStdString(place.substr(1, place.size() - 2));
    if (!next.at.empty())
        words += ", " + QString::fromStdString(next.at);
    const std::vector<Indicated>& shown = begun_->shown();
    if (!shown.empty() && shown.back().given)
        words += tr("; %1 from the point before")
                     .arg(QString::fromStdString(
                         editing::numberText((next.point - shown.back().point).norm(),
                                             editing::decimalStep(next.resolution))));
    return words;
}

QString Creating::pointedWords() const {
    if (!next_)
        return {};
    if (const auto judged = judge(*next_); judged && !judged->words.isEmpty())
        return judged->words;
    if (begun_->step().wanted != Wanted::hold)
        return wordsOf(*next_);
    if (!next_->body)
        return tr("to the ground: %1").arg(wordsOf(*next_));
    const scene::Body& body = document_.shown().scene->bodies[*next_->body];
    const QString name = QString::fromStdString(body.name);
    return (body.fixed ? tr("to %1, which is fixed: %2") : tr("to %1: %2"))
        .arg(name, wordsOf(*next_));
}

// The body that is meant is outlined, and the ground has its sign: which of them it is must be seen
// before the click.
void Creating::paintHold(QPainter& painter, const Indicated& next) const {
    const scene::Scene& scene = *document_.shown().scene;
    const QPointF place = display_.fromPixels(display_.sight().pixels(next.point));
    const scene::ShapeSet* set =
        next.body ? scene::findShapeSet(scene, scene.bodies[*next.body].shape) : nullptr;
    if (set) {
        const render::Drawing drawing = display_.drawing();
        paintOutline(painter, {set->parts, render::poseOf(scene, drawing.motion.get(), *next.body,
                                                          drawing.time)});
    }
    painter.setPen(QPen(QColor(20, 90, 200), 2));
    if (next.body)
        return;
    const QPointF below = place + QPointF(0, 10);
    painter.drawLine(below - QPointF(12, 0), below + QPointF(12, 0));
    for (const double x : {-8.0, 0.0, 8.0})
        painter.drawLine(below + QPointF(x, 0), below + QPointF(x - 5, 6));
}

void Creating::paint(QPainter& painter) const {
    if (begun_)
        paintSteps(painter);
    if (measured_)
        paintMeasured(painter);
    if (!active())
        return;
    const QRect space = display_.rect().adjusted(12, 10, -12, -10);
    const QString text = prompt();
    const QRect needed = painter.boundingRect(space, Qt::AlignLeft | Qt::TextWordWrap, text);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 90, 200, 230));
    painter.drawRoundedRect(needed.adjusted(-6, -4, 6, 4), 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(space, Qt::AlignLeft | Qt::TextWordWrap, text);
}

void Creating::paintMeasured(QPainter& painter) const {
    const gestures::Sight sight = display_.sight();
    const QPointF from = display_.fromPixels(sight.pixels(measured_->from));
    const QPointF to = display_.fromPixels(sight.pixels(measured_->to));
    painter.setPen(QPen(QColor(20, 90, 200), 2));
    painter.setBrush(QColor(255, 255, 255, 200));
    painter.drawLine(from, to);
    painter.drawEllipse(from, 4, 4);
    painter.drawEllipse(to, 4, 4);
    paintWords(painter, (from + to) / 2, measured_->words);
}

// What was shown, and what the next click would show.
void Creating::paintSteps(QPainter& painter) const {
    const gestures::Sight sight = display_.sight();
    const std::vector<Indicated>& shown = begun_->shown();
    const auto at = [&](const Indicated& one) {
        return display_.fromPixels(sight.pixels(one.point));
    };
    painter.setPen(QPen(QColor(20, 90, 200), 2));
    painter.setBrush(QColor(255, 255, 255, 200));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (!shown[i].given || shown[i].trajectory)
            continue;
        if (i > 0 && shown[i - 1].given)
            painter.drawLine(at(shown[i - 1]), at(shown[i]));
        painter.drawEllipse(at(shown[i]), 4, 4);
    }
    if (next_ && begun_->step().wanted == Wanted::point) {
        if (!shown.empty() && shown.back().given) {
            painter.setPen(QPen(QColor(20, 90, 200), 2, Qt::DashLine));
            painter.drawLine(at(shown.back()), at(*next_));
        }
        paintGhost(painter, *next_);
        paintWords(painter, at(*next_), pointedWords());
    } else if (next_) { // as it would be
        const QPointF place = at(*next_);
        painter.setPen(QPen(QColor(20, 90, 200), 2, Qt::DashLine));
        if (!shown.empty())
            painter.drawLine(at(shown.front()), place);
        painter.setPen(QPen(QColor(20, 90, 200), 2));
        painter.drawEllipse(place, 7, 7);
        painter.drawEllipse(place, 2, 2);
        if (begun_->step().wanted == Wanted::hold)
            paintHold(painter, *next_);
        if (begun_->step().outlines)
            for (const Outline& one : begun_->step().outlines(*document_.shown().scene, *next_))
                paintOutline(painter, one);
        painter.setPen(QPen(QColor(20, 90, 200), 2));
        painter.setBrush(QColor(255, 255, 255, 200));
        paintWords(painter, place, pointedWords());
    }
    if (cross_) {
        painter.drawLine(*cross_ - QPointF(9, 0), *cross_ + QPointF(9, 0));
        painter.drawLine(*cross_ - QPointF(0, 9), *cross_ + QPointF(0, 9));
    }
}

} // namespace views

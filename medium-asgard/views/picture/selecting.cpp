#include "picture/selecting.h"

#include "gestures/grasp.h"
#include "painting/pointer.h"
#include "picture/scene_display.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

using editing::Element;
using editing::Kind;
using gestures::Thing;

namespace {

// The picture may show some of it at this time. A half space is everywhere.
bool isSeen(const render::Drawing& drawing, const gestures::Sight& sight, std::size_t index) {
    const scene::Scene& scene = *drawing.scene;
    const auto outline = render::outlineOf(scene, scene.bodies[index]);
    const geometry::Pose pose = render::poseOf(scene, drawing.motion.get(), index, drawing.time);
    Eigen::AlignedBox2d seen;
    std::size_t behind = 0; // the eye
    for (const render::Ball& ball : outline) {
        const geometry::Vector middle = pose.toWorld(ball.center);
        if (sight.depth(middle) >= render::eyeOf(sight.camera)) {
            ++behind;
            continue;
        }
        const double radius = ball.radius / sight.pixelLength(middle);
        for (const double way : {-radius, radius})
            seen.extend(sight.pixels(middle) + Eigen::Vector2d(way, way));
    }
    const Eigen::AlignedBox2d picture(Eigen::Vector2d(0, 0),
                                      Eigen::Vector2d(sight.size.width, sight.size.height));
    if (behind > 0 && behind < outline.size())
        return true;
    return outline.empty() || (behind == 0 && picture.intersects(seen));
}

QString nameOfFirst(const SceneDocument& document) {
    const auto first = std::ranges::find(document.selected(), Kind::body, &Element::kind);
    return QString::fromStdString(editing::nameOf(*document.shown().scene, *first));
}

} // namespace

bool Selecting::press(const QMouseEvent& event) {
    pressed_.reset();
    if (event.button() != Qt::LeftButton)
        return false;
    const Qt::KeyboardModifiers keys = event.modifiers() & ~Qt::KeypadModifier;
    if (keys & Qt::ControlModifier) {
        band_ = {event.position(), event.position()};
        return true;
    }
    adds_ = keys == Qt::ShiftModifier;
    if (adds_ || keys == Qt::NoModifier)
        pressed_ = event.position();
    return false;
}

bool Selecting::move(const QMouseEvent& event) {
    if (!band_)
        return false;
    band_->second = event.position();
    display_.update();
    return true;
}

bool Selecting::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton)
        return band_.has_value();
    if (band_) {
        const bool isClick = isNear(band_->first, band_->second);
        if (isClick)
            addOrTakeOut(band_->first);
        else
            selectBand(event.modifiers() & Qt::ShiftModifier);
        band_.reset();
        display_.update();
        return true;
    }
    const auto pressed = std::exchange(pressed_, std::nullopt);
    if (!pressed || !isNear(*pressed, event.position()))
        return false;
    if (adds_)
        addOrTakeOut(event.position());
    else
        click(event.position());
    return true;
}

bool Selecting::cancel() {
    pressed_.reset();
    if (!std::exchange(band_, std::nullopt))
        return false;
    display_.update();
    return true;
}

std::optional<std::size_t> Selecting::selectedBodyAt(const QPointF& position) const {
    return gestures::selectedBodyAt(display_.drawn(), display_.sight(), display_.inPixels(position),
                                    document_.selected());
}

std::optional<std::size_t> Selecting::draggedBodyAt(const QPointF& position) const {
    if (const auto body = selectedBodyAt(position))
        return body;
    const auto front =
        gestures::bodyAt(display_.drawn(), display_.sight(), display_.inPixels(position));
    return front && display_.throwing().takesAtOnce(front->body, position)
               ? std::optional(front->body)
               : std::nullopt;
}

std::vector<Thing> Selecting::thingsAt(const QPointF& position) const {
    return gestures::thingsAt(display_.drawn(), display_.handles(), display_.sight(),
                              display_.inPixels(position),
                              gestures::handleReach * display_.devicePixelRatioF());
}

void Selecting::click(const QPointF& position) {
    if (const auto away = tag(); away && away->box.contains(position))
        return display_.bringIn(document_.selected());
    const std::vector<Thing> things = thingsAt(position);
    const auto before = std::exchange(clicked_, position);
    const Thing* thing =
        gestures::meant(things, document_.selected(), before && isNear(*before, position));
    if (!thing)
        return document_.select({});
    if (thing->handle)
        display_.editing().choose(thing->handle->kind, thing->handle->element, thing->handle->part);
    else
        document_.select({thing->element});
}

void Selecting::addOrTakeOut(const QPointF& position) {
    const std::vector<Thing> things = thingsAt(position);
    if (things.empty())
        return;
    const Thing& thing = things.front();
    std::vector<Element> selected = document_.selected();
    const bool was = std::erase(selected, thing.element) > 0;
    if (!was || thing.handle)
        selected.push_back(thing.element);
    document_.select(std::move(selected));
    if (thing.handle)
        display_.editing().mark(*thing.handle);
}

void Selecting::selectAll() {
    const render::Drawing drawing = display_.drawn();
    std::vector<Element> all;
    for (std::size_t i = 0; i < drawing.scene->bodies.size(); ++i)
        if (!render::isHidden(drawing.display, drawing.scene->bodies[i]))
            all.push_back({Kind::body, i});
    document_.select(std::move(all));
}

void Selecting::selectBand(bool adds) {
    std::vector<Element> selected = adds ? document_.selected() : std::vector<Element>();
    for (const std::size_t body :
         gestures::bodiesWithin(display_.drawn(), display_.sight(), display_.inPixels(band_->first),
                                display_.inPixels(band_->second)))
        selected.push_back({Kind::body, body});
    document_.select(std::move(selected));
}

std::optional<Selecting::Tag> Selecting::tag() const {
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawing = display_.drawn();
    const QRectF picture = display_.rect();
    std::optional<geometry::Vector> first;
    std::size_t count = 0;
    for (const Element& element : document_.selected()) {
        if (element.kind != Kind::body)
            continue;
        if (isSeen(drawing, sight, element.index))
            return std::nullopt;
        ++count;
        if (!first)
            first =
                render::poseOf(*drawing.scene, drawing.motion.get(), element.index, drawing.time)
                    .position;
    }
    if (!first || drawing.scene->bodies.empty())
        return std::nullopt;
    // Behind the eye it is seen turned about.
    const QPointF middle = picture.center();
    QPointF way = display_.fromPixels(sight.pixels(*first)) - middle;
    if (sight.depth(*first) > render::eyeOf(sight.camera))
        way = -way;
    Tag tag;
    tag.words = count == 1
                    ? SceneDisplay::tr("%1 is out of the picture. A click here, or Shift+F, "
                                       "shows it.")
                          .arg(nameOfFirst(document_))
                    : SceneDisplay::tr("%1 selected bodies are out of the picture. A click here, "
                                       "or Shift+F, shows them.")
                          .arg(count);
    constexpr double margin = 10;
    const int narrow = std::max(120, display_.width() / 3); // the middle is for the bodies
    tag.box = display_.fontMetrics()
                  .boundingRect(QRect(0, 0, narrow, 1000), Qt::TextWordWrap, tag.words)
                  .toRectF()
                  .marginsAdded({6, 3, 6, 3});
    const double across = picture.width() / 2 - tag.box.width() / 2 - 2 * margin;
    const double along = picture.height() / 2 - tag.box.height() / 2 - 2 * margin;
    const double far = std::max({std::abs(way.x()) / std::max(across, 1.0),
                                 std::abs(way.y()) / std::max(along, 1.0), 1e-9});
    tag.box.moveCenter(middle + way / far);
    for (const QWidget* over : display_.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        if (over->isVisible() && tag.box.intersects(over->geometry()) &&
            over->geometry().top() > tag.box.height() + 2 * margin)
            tag.box.moveBottom(over->geometry().top() - margin);
    const double length = std::max(std::hypot(way.x(), way.y()), 1e-9);
    tag.end = way / length;
    return tag;
}

// An arrow leads from the words to where the body is.
void Selecting::paintTag(QPainter& painter, const Tag& tag) const {
    const QColor blue(20, 90, 200);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(blue.red(), blue.green(), blue.blue(), 230));
    painter.drawRoundedRect(tag.box, 4, 4);
    const QPointF way = tag.end, side(-way.y(), way.x());
    const double out = std::min(tag.box.width() / 2 / std::max(std::abs(way.x()), 1e-9),
                                tag.box.height() / 2 / std::max(std::abs(way.y()), 1e-9));
    const QPointF foot = tag.box.center() + way * out;
    painter.drawPolygon(QPolygonF{foot + side * 6, foot - side * 6, foot + way * 9});
    painter.setPen(Qt::white);
    painter.drawText(tag.box, Qt::AlignCenter | Qt::TextWordWrap, tag.words);
}

void Selecting::paint(QPainter& painter) const {
    if (const auto away = tag())
        paintTag(painter, *away);
    if (!band_ || isNear(band_->first, band_->second))
        return;
    painter.setPen(QPen(QColor(20, 90, 200), 1));
    painter.setBrush(QColor(20, 90, 200, 40));
    painter.drawRect(QRectF(band_->first, band_->second).normalized());
}

} // namespace views

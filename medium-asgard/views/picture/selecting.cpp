#include "picture/selecting.h"

#include "gestures/grasp.h"
#include "gestures/handle_meaning.h"
#include "picture/scene_display.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace views {

using editing::Element;
using editing::Kind;

namespace {

constexpr double still = 4; // pixels: not yet a drag

bool isNear(const QPointF& one, const QPointF& other) {
    return (one - other).manhattanLength() < still;
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
    const auto& selected = document_.selected();
    if (std::ranges::find(selected, Kind::body, &Element::kind) == selected.end())
        return std::nullopt;
    for (const gestures::Picked& picked :
         gestures::bodiesAt(display_.drawing(), display_.sight(), display_.inPixels(position)))
        if (std::ranges::find(selected, Element{Kind::body, picked.body}) != selected.end())
            return picked.body;
    return std::nullopt;
}

std::vector<Selecting::Thing> Selecting::thingsAt(const QPointF& position) const {
    std::vector<Thing> things;
    const auto add = [&](const Element& element, std::optional<render::Handle> handle = {}) {
        if (std::ranges::find(things, element, &Thing::element) == things.end())
            things.push_back({element, std::move(handle)});
    };
    const Eigen::Vector2d pixels = display_.inPixels(position);
    const double reach = gestures::handleReach * display_.devicePixelRatioF();
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawing = display_.drawing();
    const render::HandleSet& set = display_.handles();
    if (const auto index = gestures::handleAt(set, sight, pixels, reach))
        add(gestures::elementOf(set.handles[*index]), set.handles[*index]);
    if (const auto sign = gestures::jointAt(drawing, sight, pixels, reach))
        add(gestures::elementOf(*sign), *sign);
    for (const gestures::Picked& picked : gestures::bodiesAt(drawing, sight, pixels))
        add({Kind::body, picked.body});
    if (drawing.display.trajectories)
        if (const auto path = gestures::trajectoryAt(*drawing.scene, sight, pixels, reach))
            add({Kind::trajectory, *path});
    return things;
}

void Selecting::click(const QPointF& position) {
    const std::vector<Thing> things = thingsAt(position);
    const auto before = std::exchange(clicked_, position);
    if (things.empty())
        return document_.select({});
    std::size_t which = 0;
    const auto& selected = document_.selected();
    if (before && isNear(*before, position) && selected.size() == 1) {
        const auto now = std::ranges::find(things, selected.front(), &Thing::element);
        if (now != things.end())
            which = (static_cast<std::size_t>(now - things.begin()) + 1) % things.size();
    }
    const Thing& thing = things[which];
    if (thing.handle)
        display_.editing().choose(thing.handle->kind, thing.handle->element, thing.handle->part);
    else
        document_.select({thing.element});
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

void Selecting::selectBand(bool adds) {
    std::vector<Element> selected = adds ? document_.selected() : std::vector<Element>();
    for (const std::size_t body :
         gestures::bodiesWithin(display_.drawing(), display_.sight(),
                                display_.inPixels(band_->first), display_.inPixels(band_->second)))
        selected.push_back({Kind::body, body});
    document_.select(std::move(selected));
}

void Selecting::paint(QPainter& painter) const {
    if (!band_ || isNear(band_->first, band_->second))
        return;
    painter.setPen(QPen(QColor(20, 90, 200), 1));
    painter.setBrush(QColor(20, 90, 200, 40));
    painter.drawRect(QRectF(band_->first, band_->second).normalized());
}

} // namespace views

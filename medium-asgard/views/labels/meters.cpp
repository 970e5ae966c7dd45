#include "labels/meters.h"

#include "framing/body_places.h"
#include "framing/joint_places.h"
#include "painting/pointer.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

constexpr std::size_t mostMeters = 60;

// Between two samples; NaN where there is none.
double valueAt(const charts::Plot& plot, double time) {
    if (plot.curves.empty() || plot.curves.front().values.size() != plot.times.size() ||
        plot.times.empty() || time > plot.times.back())
        return std::nan("");
    const auto& values = plot.curves.front().values;
    const auto after =
        static_cast<std::size_t>(std::ranges::lower_bound(plot.times, time) - plot.times.begin());
    if (after == 0)
        return values.front();
    const double from = plot.times[after - 1], to = plot.times[after];
    const double share = to > from ? (time - from) / (to - from) : 1;
    return values[after - 1] + share * (values[after] - values[after - 1]);
}

// All of it, as far as it fits.
QRectF inside(QRectF rect, const QSizeF& room) {
    const auto at = [](double wish, double length, double all) {
        return std::clamp(wish, 0.0, std::max(0.0, all - length));
    };
    rect.moveTo(at(rect.x(), rect.width(), room.width()),
                at(rect.y(), rect.height(), room.height()));
    return rect;
}

} // namespace

Meters::Meters(SceneDocument& document, SeenPicture& picture)
    : document_(document), picture_(picture),
      sampler_(
          [this](const charts::PlotSampler::Wish&, std::vector<charts::Plot> plots) {
              QMetaObject::invokeMethod(
                  this, [this, plots = std::move(plots)] { take(plots); }, Qt::QueuedConnection);
          },
          mostMeters) {
    connect(&document_, &SceneDocument::elementsRenamed, this, &Meters::rename);
    connect(&document_, &SceneDocument::motionChanged, this, &Meters::ask);
}

void Meters::set(std::vector<Meter> meters) {
    held_.reset();
    meters_ = std::move(meters);
    if (meters_.size() > mostMeters)
        meters_.resize(mostMeters);
    ask();
    Q_EMIT changed();
}

void Meters::rename(const std::vector<editing::Renamed>& renamed) {
    std::vector<Meter> meters = meters_;
    for (Meter& meter : meters)
        for (const editing::Renamed& one : renamed) {
            if (meter.kind != one.element.kind || meter.element != one.before)
                continue;
            const auto all = commands::quantitiesOf(*document_.shown().scene, one.element);
            const auto same =
                std::ranges::find(all, meter.quantity.label, &commands::Quantity::label);
            meter.element = one.now;
            if (same != all.end())
                meter.quantity = *same;
        }
    set(std::move(meters));
}

bool Meters::has(const commands::Quantity& quantity) const {
    return std::ranges::any_of(
        meters_, [&](const Meter& one) { return one.quantity.expression == quantity.expression; });
}

void Meters::toggle(const editing::Element& element, const commands::Quantity& quantity) {
    std::vector<Meter> meters = meters_;
    const auto gone = std::erase_if(
        meters, [&](const Meter& one) { return one.quantity.expression == quantity.expression; });
    if (gone == 0)
        meters.push_back(
            {element.kind, editing::nameOf(*document_.shown().scene, element), quantity});
    set(std::move(meters));
}

// A copy of the scene has them as its plots.
void Meters::ask() {
    if (meters_.empty() || !document_.shown().motion)
        return;
    auto scene = std::make_shared<scene::Scene>(*document_.shown().scene);
    scene->plots.clear();
    for (const Meter& meter : meters_) {
        scene::Plot& plot = scene->plots.emplace_back();
        plot.name = meter.quantity.expression;
        plot.values = {meter.quantity.expression};
    }
    sampler_.sample({std::move(scene), document_.shown().motion});
}

void Meters::take(std::vector<charts::Plot> plots) {
    sampled_.clear();
    for (charts::Plot& plot : plots) {
        std::string expression = plot.title;
        sampled_.emplace(std::move(expression), std::move(plot));
    }
    Q_EMIT changed();
}

QString Meters::words(const Meter& meter, double time) const {
    const QString label = QString::fromStdString(meter.quantity.label).remove('&');
    const auto found = sampled_.find(meter.quantity.expression);
    if (found == sampled_.end())
        return label + QStringLiteral(" …");
    const double value = valueAt(found->second, time);
    if (!std::isfinite(value))
        return label + QStringLiteral(" –");
    const charts::Range range = charts::rangeOf(found->second);
    const double noise = 1e-9 * std::max(std::abs(range.low), std::abs(range.high));
    const QString number = QString::number(std::abs(value) <= noise ? 0 : value, 'g', 3);
    const auto& curves = found->second.curves;
    const QString unit = curves.empty() ? QString() : QString::fromStdString(curves.front().unit);
    return QStringLiteral("%1 %2 %3").arg(label, number, unit).trimmed();
}

std::optional<Meters::Place> Meters::placeOf(const Meter& meter) const {
    const render::Drawing drawing = picture_.drawn();
    const scene::Scene& scene = *drawing.scene;
    const gestures::Sight sight = picture_.sight();
    const auto named = [&](const auto& all) {
        return std::ranges::find(all, meter.element, [](const auto& one) { return one.name; });
    };
    std::string body = meter.element;
    if (meter.kind == editing::Kind::joint) {
        const auto joint = named(scene.joints);
        if (joint == scene.joints.end())
            return std::nullopt;
        const auto at = render::JointPlaces(scene, drawing.motion.get()).at(*joint, drawing.time);
        return at ? std::optional(Place{picture_.fromPixels(sight.pixels(at->ends[0].point))})
                  : std::nullopt;
    }
    if (meter.kind == editing::Kind::link) {
        const auto link = named(scene.links);
        body = link == scene.links.end() ? std::string() : link->first.body;
    }
    if (meter.kind == editing::Kind::rope)
        if (const auto rope = named(scene.ropes); rope != scene.ropes.end()) {
            const auto held = std::ranges::find_if(
                rope->points, [](const scene::Rope::Point& one) { return one.body.has_value(); });
            body = held == rope->points.end() ? std::string() : *held->body;
        }
    if (meter.kind == editing::Kind::contact)
        if (const auto contact = named(scene.contacts); contact != scene.contacts.end()) {
            const auto first = std::ranges::find(scene.bodies, contact->body1, &scene::Body::name);
            const bool isFixed = first != scene.bodies.end() && first->fixed;
            body = isFixed ? contact->body2 : contact->body1;
        }
    const auto found = std::ranges::find(scene.bodies, body, &scene::Body::name);
    if (found == scene.bodies.end() || render::isHidden(drawing.display, *found))
        return std::nullopt;
    const auto index = static_cast<std::size_t>(found - scene.bodies.begin());
    const geometry::Pose pose = render::poseOf(scene, drawing.motion.get(), index, drawing.time);
    Place place{picture_.fromPixels(sight.pixels(pose.position))};
    constexpr double farthest = 60; // pixels: a value on a large body is near its middle
    for (const render::Ball& ball : render::outlineOf(scene, *found)) {
        const geometry::Vector at = pose.toWorld(ball.center);
        const double pixel = sight.pixelLength(at) * picture_.widget().devicePixelRatioF();
        const double right = picture_.fromPixels(sight.pixels(at)).x() + ball.radius / pixel;
        place.reach = std::clamp(right - place.at.x(), place.reach, farthest);
    }
    return place;
}

// Those of one thing stand below each other, at its right; all of each is in the picture.
std::vector<Meters::Box> Meters::boxes() const {
    std::map<std::string, double> below;
    std::vector<Box> all;
    const QFontMetricsF font(picture_.widget().font());
    const double height = font.height() + 2;
    for (std::size_t i = 0; i < meters_.size(); ++i) {
        const Meter& meter = meters_[i];
        const auto place = placeOf(meter);
        if (!place)
            continue;
        const QString words = this->words(meter, picture_.drawn().time);
        const double width = font.horizontalAdvance(words) + 12;
        const QSizeF size = meter.isChart ? QSizeF(std::max(width, 13 * height), 6 * height)
                                          : QSizeF(width, height);
        const QPointF beside = place->at + QPointF(place->reach + 6, 7);
        QRectF rect(beside + meter.aside, size);
        if (meter.aside.isNull()) {
            rect.translate(0, below[meter.element]);
            below[meter.element] += size.height();
        }
        if (!meter.aside.isNull() || QRectF(picture_.widget().rect()).contains(place->at))
            rect = inside(rect, picture_.widget().size());
        all.push_back({i, place->at, beside, rect, words});
    }
    return all;
}

void Meters::paint(QPainter& painter) const {
    const QColor ink = picture_.widget().palette().color(QPalette::Text);
    QColor paper = picture_.widget().palette().color(QPalette::Base);
    paper.setAlpha(215);
    for (const Box& box : boxes()) {
        const Meter& meter = meters_[box.meter];
        if (!meter.aside.isNull()) { // a line tells of what it is
            QColor faint = ink;
            faint.setAlpha(110);
            painter.setPen(QPen(faint, 1));
            const QPointF nearest(std::clamp(box.place.x(), box.rect.left(), box.rect.right()),
                                  std::clamp(box.place.y(), box.rect.top(), box.rect.bottom()));
            painter.drawLine(box.place, nearest);
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(paper);
        painter.drawRoundedRect(box.rect, 3, 3);
        painter.setPen(ink);
        if (meter.isChart)
            paintChart(painter, box);
        else
            painter.drawText(box.rect, Qt::AlignCenter, box.words);
    }
}

void Meters::paintChart(QPainter& painter, const Box& box) const {
    const QFontMetricsF font(painter.font());
    painter.drawText(box.rect.adjusted(6, 1, -6, 0), Qt::AlignLeft | Qt::AlignTop, box.words);
    const auto found = sampled_.find(meters_[box.meter].quantity.expression);
    if (found == sampled_.end() || found->second.times.size() < 2 || found->second.curves.empty())
        return;
    const charts::Plot& plot = found->second;
    const auto& values = plot.curves.front().values;
    const charts::Range range = charts::rangeOf(plot);
    const auto number = [](double value) { return QString::number(value, 'g', 3); };
    const QString low = number(range.low), high = number(range.high);
    const double beside = std::max(font.horizontalAdvance(low), font.horizontalAdvance(high));
    const QRectF room = box.rect.adjusted(10 + beside, font.height() + 6, -8, -6);
    const double from = plot.times.front(), length = std::max(plot.times.back() - from, 1e-12);
    const double height = range.high - range.low;
    const auto x = [&](double time) { return room.left() + room.width() * (time - from) / length; };
    const auto y = [&](double value) {
        const double share = height > 0 ? (value - range.low) / height : 0.5;
        return room.bottom() - room.height() * share;
    };
    QPainterPath curve;
    bool isBegun = false;
    for (std::size_t i = 0; i < std::min(values.size(), plot.times.size()); ++i) {
        const bool isThere = std::isfinite(values[i]);
        const QPointF point(x(plot.times[i]), isThere ? y(values[i]) : 0);
        if (isThere)
            isBegun ? curve.lineTo(point) : curve.moveTo(point);
        isBegun = isThere;
    }
    const QColor ink = painter.pen().color();
    QColor faint = ink;
    faint.setAlpha(70);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(faint, 1));
    painter.drawRect(room);
    const QRectF numbers(box.rect.left() + 4, room.top(), 3 + beside, room.height());
    faint.setAlpha(170);
    painter.setPen(faint);
    painter.drawText(numbers.adjusted(0, -2, 0, 2), Qt::AlignRight | Qt::AlignTop, high);
    painter.drawText(numbers.adjusted(0, -2, 0, 2), Qt::AlignRight | Qt::AlignBottom, low);
    faint.setAlpha(70);
    painter.setPen(faint);
    if (range.low < 0 && range.high > 0)
        painter.drawLine(QPointF(room.left(), y(0)), QPointF(room.right(), y(0)));
    painter.setPen(QPen(picture_.widget().palette().color(QPalette::Highlight), 1.5));
    painter.drawPath(curve);
    const double now = std::clamp(x(picture_.drawn().time), room.left(), room.right());
    painter.setPen(QPen(ink, 1));
    painter.drawLine(QPointF(now, room.top()), QPointF(now, room.bottom()));
}

// --- the pointer -------------------------------------------------------------------------------

std::optional<Meters::Box> Meters::boxAt(const QPointF& position) const {
    std::optional<Box> last;
    if (!meters_.empty())
        for (const Box& box : boxes())
            if (box.rect.contains(position))
                last = box;
    return last;
}

std::optional<std::size_t> Meters::at(const QPointF& position) const {
    const auto box = boxAt(position);
    return box ? std::optional(box->meter) : std::nullopt;
}

bool Meters::press(const QPointF& position) {
    const auto box = boxAt(position);
    if (box)
        held_ = Held{box->meter, position, position - box->rect.topLeft(),
                     meters_[box->meter].aside, false};
    return box.has_value();
}

// It stays under the pointer as far as the picture reaches, and is where it is seen.
bool Meters::move(const QPointF& position) {
    if (!held_)
        return false;
    held_->isDrag = held_->isDrag || !isNear(position, held_->from);
    if (held_->isDrag)
        for (const Box& box : boxes())
            if (box.meter == held_->meter) {
                const QRectF wish(position - held_->grip, box.rect.size());
                meters_[box.meter].aside =
                    inside(wish, picture_.widget().size()).topLeft() - box.beside;
                Q_EMIT changed();
            }
    return true;
}

bool Meters::release() { return std::exchange(held_, std::nullopt).has_value(); }

bool Meters::cancel() {
    const auto held = std::exchange(held_, std::nullopt);
    if (held && held->meter < meters_.size()) {
        meters_[held->meter].aside = held->aside;
        Q_EMIT changed();
    }
    return held.has_value();
}

bool Meters::doubleClick(const QPointF& position) {
    const auto box = boxAt(position);
    if (!box)
        return false;
    meters_[box->meter].isChart = !meters_[box->meter].isChart;
    Q_EMIT changed();
    return true;
}

} // namespace views

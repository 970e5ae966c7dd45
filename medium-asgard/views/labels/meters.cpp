#include "labels/meters.h"

#include "commands/beside.h"
#include "painting/pointer.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

Eigen::Vector2d vector(const QPointF& point) { return {point.x(), point.y()}; }
Eigen::Vector2d vector(const QSizeF& size) { return {size.width(), size.height()}; }
QPointF point(const Eigen::Vector2d& vector) { return {vector.x(), vector.y()}; }
QRectF rect(const Eigen::AlignedBox2d& box) { return {point(box.min()), point(box.max())}; }

} // namespace

Meters::Meters(SceneDocument& document, SeenPicture& picture)
    : document_(document), picture_(picture),
      sampler_(
          [this](const charts::PlotSampler::Wish& of, std::vector<charts::Plot> plots) {
              auto take = [this, sampled = meters::Sampled{of.scene, std::move(plots)}] {
                  sampled_ = sampled;
                  Q_EMIT changed();
              };
              QMetaObject::invokeMethod(this, std::move(take), Qt::QueuedConnection);
          },
          meters::most) {
    connect(&document_, &SceneDocument::elementsRenamed, this, &Meters::rename);
    connect(&document_, &SceneDocument::sceneChanged, this, [this] {
        held_.reset();
        ask();
        Q_EMIT changed();
    });
    connect(&document_, &SceneDocument::motionChanged, this, &Meters::ask);
}

std::vector<Meter> Meters::all() const {
    const scene::Scene& scene = *document_.shown().scene;
    std::vector<Meter> all;
    for (meters::Meter& of : meters::metersOf(scene)) {
        MeterName name{scene.plots[of.plot].name, of.value};
        const auto look = looks_.find(name);
        all.push_back(
            {std::move(of), std::move(name), look == looks_.end() ? MeterLook() : look->second});
    }
    return all;
}

void Meters::setLooks(MeterLooks looks) {
    held_.reset();
    looks_ = std::move(looks);
    Q_EMIT changed();
}

void Meters::rename(const std::vector<editing::Renamed>& renamed) {
    MeterLooks looks;
    for (auto& [name, look] : looks_) {
        MeterName now = name;
        for (const editing::Renamed& one : renamed)
            if (one.element.kind == editing::Kind::plot && name.plot == one.before)
                now.plot = one.now;
        looks.emplace(now, look);
    }
    looks_ = std::move(looks);
}

QString Meters::toggle(const commands::Quantity& quantity) {
    if (QString why = document_.whyNotCurrent(); !why.isEmpty())
        return why;
    const auto& scene = document_.shown().scene;
    const editing::Answer answer = commands::withBeside(document_.text(), scene, quantity);
    if (answer.possible())
        document_.setText(text::applied(document_.text(), answer.edits),
                          QString::fromStdString(commands::labelOfBeside(*scene, quantity)));
    return QString::fromStdString(answer.reason);
}

void Meters::ask() {
    const Shown& shown = document_.shown();
    if (shown.motion && !meters::metersOf(*shown.scene).empty())
        sampler_.sample({shown.scene, shown.motion});
}

const charts::Plot* Meters::sampledOf(const Meter& meter) const {
    return sampled_.of(document_.shown().scene->plots[meter.of.plot]);
}

QString Meters::words(const Meter& meter, double time) const {
    return QString::fromStdString(meters::wordsOf(meter.of, sampledOf(meter), time));
}

std::vector<Eigen::AlignedBox2d> Meters::taken() const {
    std::vector<Eigen::AlignedBox2d> taken;
    for (const Box& box : boxes())
        taken.emplace_back(vector(box.rect.topLeft()), vector(box.rect.bottomRight()));
    return taken;
}

std::vector<Meters::Box> Meters::boxes() const {
    std::vector<Meter> meters = this->all();
    if (meters.empty())
        return {};
    const render::Drawing drawn = picture_.drawn();
    const gestures::Sight sight = picture_.sight();
    const QWidget& widget = picture_.widget();
    const QFontMetricsF font(widget.font());
    const double height = font.height() + 2;
    std::vector<Box> all;
    std::vector<meters::Wish> wishes;
    for (Meter& meter : meters) {
        const auto place = meters::placeOf(drawn, sight, meter.of.of, widget.devicePixelRatioF());
        if (!place)
            continue;
        const QString words = this->words(meter, drawn.time);
        const double width = font.horizontalAdvance(words) + 12;
        const QSizeF size = meter.look.isChart ? QSizeF(std::max(width, 13 * height), 6 * height)
                                               : QSizeF(width, height);
        wishes.push_back({meter.of.of, *place, vector(size), vector(meter.look.aside)});
        all.push_back({std::move(meter), point(place->at), {}, {}, words});
    }
    const auto boxes = meters::boxesFor(wishes, vector(QSizeF(widget.size())));
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].beside = point(boxes[i].beside);
        all[i].rect = rect(boxes[i].rect);
    }
    return all;
}

void Meters::paint(QPainter& painter) const {
    const QColor ink = picture_.widget().palette().color(QPalette::Text);
    QColor paper = picture_.widget().palette().color(QPalette::Base);
    paper.setAlpha(215);
    for (const Box& box : boxes()) {
        if (!box.meter.look.aside.isNull()) { // a line tells of what it is
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
        if (box.meter.look.isChart)
            paintChart(painter, box);
        else
            painter.drawText(box.rect, Qt::AlignCenter, box.words);
    }
}

void Meters::paintChart(QPainter& painter, const Box& box) const {
    const QFontMetricsF font(painter.font());
    painter.drawText(box.rect.adjusted(6, 1, -6, 0), Qt::AlignLeft | Qt::AlignTop, box.words);
    const charts::Plot* sampled = sampledOf(box.meter);
    const std::size_t which = box.meter.of.value;
    if (!sampled || sampled->times.size() < 2 || which >= sampled->curves.size())
        return;
    const charts::Plot plot{
        .title = {}, .times = sampled->times, .curves = {sampled->curves[which]}};
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
    for (Box& box : boxes())
        if (box.rect.contains(position))
            last = std::move(box);
    return last;
}

std::optional<Meter> Meters::at(const QPointF& position) const {
    auto box = boxAt(position);
    return box ? std::optional(std::move(box->meter)) : std::nullopt;
}

bool Meters::press(const QPointF& position) {
    const auto box = boxAt(position);
    if (box)
        held_ = Held{box->meter.name, position, position - box->rect.topLeft(),
                     box->meter.look.aside, false};
    return box.has_value();
}

// It stays under the pointer as far as the picture reaches, and is where it is seen.
bool Meters::move(const QPointF& position) {
    if (!held_)
        return false;
    held_->isDrag = held_->isDrag || !isNear(position, held_->from);
    if (held_->isDrag)
        for (const Box& box : boxes())
            if (box.meter.name == held_->meter) {
                const QPointF corner = position - held_->grip;
                const Eigen::AlignedBox2d wish(vector(corner),
                                               vector(corner) + vector(box.rect.size()));
                const QSizeF picture = picture_.widget().size();
                looks_[held_->meter].aside =
                    point(meters::inside(wish, vector(picture)).min()) - box.beside;
                Q_EMIT changed();
            }
    return true;
}

bool Meters::release() { return std::exchange(held_, std::nullopt).has_value(); }

bool Meters::cancel() {
    const auto held = std::exchange(held_, std::nullopt);
    if (held) {
        looks_[held->meter].aside = held->aside;
        Q_EMIT changed();
    }
    return held.has_value();
}

bool Meters::doubleClick(const QPointF& position) {
    const auto box = boxAt(position);
    if (!box)
        return false;
    looks_[box->meter.name].isChart = !box->meter.look.isChart;
    Q_EMIT changed();
    return true;
}

} // namespace views

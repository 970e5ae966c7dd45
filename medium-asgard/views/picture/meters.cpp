#include "picture/meters.h"

#include "framing/joint_places.h"
#include "picture/scene_display.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

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

} // namespace

Meters::Meters(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display),
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

std::optional<QPointF> Meters::placeOf(const Meter& meter) const {
    const render::Drawing drawing = display_.drawn();
    const scene::Scene& scene = *drawing.scene;
    const gestures::Sight sight = display_.sight();
    const auto named = [&](const auto& all) {
        return std::ranges::find(all, meter.element, [](const auto& one) { return one.name; });
    };
    std::string body = meter.element;
    if (meter.kind == editing::Kind::joint) {
        const auto joint = named(scene.joints);
        if (joint == scene.joints.end())
            return std::nullopt;
        const auto at = render::JointPlaces(scene, drawing.motion.get()).at(*joint, drawing.time);
        return at ? std::optional(display_.fromPixels(sight.pixels(at->ends[0].point)))
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
    return display_.fromPixels(
        sight.pixels(render::poseOf(scene, drawing.motion.get(), index, drawing.time).position));
}

// Those of one thing stand below each other, at its right.
void Meters::paint(QPainter& painter) const {
    std::map<std::string, int> lines;
    QColor paper = display_.palette().color(QPalette::Base);
    paper.setAlpha(215);
    for (const Meter& meter : meters_) {
        const auto place = placeOf(meter);
        if (!place)
            continue;
        const QString words = this->words(meter, display_.drawn().time);
        const double height = painter.fontMetrics().height() + 2;
        const QPointF corner = *place + QPointF(16, -height / 2 + height * lines[meter.element]++);
        const QRectF box(corner,
                         QSizeF(painter.fontMetrics().horizontalAdvance(words) + 12, height));
        painter.setPen(Qt::NoPen);
        painter.setBrush(paper);
        painter.drawRoundedRect(box, 3, 3);
        painter.setPen(display_.palette().color(QPalette::Text));
        painter.drawText(box, Qt::AlignCenter, words);
    }
}

} // namespace views

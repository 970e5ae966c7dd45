// Values beside their bodies and joints while the motion plays: a state of one picture, no part of
// the scene.
//
// They are sampled over the motion on a thread of their own, as charts are, and read between two
// samples: three digits of them are shown.
#pragma once

#include "charts/plot_sampler.h"
#include "commands/quantities.h"
#include "workbench/scene_document.h"

#include <QObject>

#include <map>
#include <vector>

class QPainter;
class QPointF;

namespace views {

class SceneDisplay;

struct Meter {
    editing::Kind kind = editing::Kind::body;
    std::string element; // its name
    commands::Quantity quantity;
};

class Meters : public QObject {
    Q_OBJECT
public:
    Meters(SceneDocument& document, SceneDisplay& display);

    [[nodiscard]] const std::vector<Meter>& all() const { return meters_; }
    void set(std::vector<Meter> meters);
    [[nodiscard]] bool has(const commands::Quantity& quantity) const;
    void toggle(const editing::Element& element, const commands::Quantity& quantity);
    // "Speed 1.25" of each that is known at that time; "…" while it is computed.
    [[nodiscard]] QString words(const Meter& meter, double time) const;
    void paint(QPainter& painter) const;

Q_SIGNALS:
    void changed();

private:
    void ask();
    void rename(const std::vector<editing::Renamed>& renamed);
    void take(std::vector<charts::Plot> plots);
    // In the display; none: it is gone or hidden.
    [[nodiscard]] std::optional<QPointF> placeOf(const Meter& meter) const;

    SceneDocument& document_;
    SceneDisplay& display_;
    std::vector<Meter> meters_;
    std::map<std::string, charts::Plot> sampled_; // by the expression
    charts::PlotSampler sampler_;                 // the first to go
};

} // namespace views

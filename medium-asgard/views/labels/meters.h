// Values beside their bodies and joints while the motion plays: those of the scene's plots with
// `-beside 1`, which documents show, too (meters/meters.h).
//
// They are sampled over the motion on a thread of their own, as charts are, and read between two
// samples. A double click makes one a small chart against time, and again a number; a drag puts it
// elsewhere beside its body, which it follows: that is a state of one picture, no part of the
// scene.
#pragma once

#include "charts/plot_sampler.h"
#include "commands/quantities.h"
#include "labels/seen_picture.h"
#include "meters/meters.h"
#include "workbench/scene_document.h"

#include <QObject>
#include <QPointF>
#include <QRectF>

#include <map>
#include <optional>
#include <vector>

class QPainter;

namespace views {

struct MeterName {
    std::string plot;
    std::size_t value = 0; // of the plot
    auto operator<=>(const MeterName&) const = default;
};
struct MeterLook {        // in one picture
    QPointF aside = {};   // from the first place beside its body; 0: nobody has dragged it
    bool isChart = false; // against time, with a line at the moment
};
using MeterLooks = std::map<MeterName, MeterLook>;

struct Meter {
    meters::Meter of; // the scene that is shown
    MeterName name;
    MeterLook look;
};

class Meters : public QObject {
    Q_OBJECT
public:
    Meters(SceneDocument& document, SeenPicture& picture);

    [[nodiscard]] std::vector<Meter> all() const;
    // Of those that are not there, too: they may come back.
    [[nodiscard]] const MeterLooks& looks() const { return looks_; }
    void setLooks(MeterLooks looks);
    // In the text: it is there, or not any more. "" or why not.
    QString toggle(const commands::Quantity& quantity);
    // "Speed 1.25 m/s" at that time; "…" while it is computed.
    [[nodiscard]] QString words(const Meter& meter, double time) const;
    void paint(QPainter& painter) const;
    [[nodiscard]] std::vector<Eigen::AlignedBox2d> taken() const;         // the room of all
    [[nodiscard]] std::optional<Meter> at(const QPointF& position) const; // in the widget

    // Of the left button. False: none is there, or none is held.
    bool press(const QPointF& position);
    bool move(const QPointF& position);
    bool release();
    bool doubleClick(const QPointF& position);
    bool cancel(); // it is where it was
    [[nodiscard]] bool holds() const { return held_.has_value(); }

Q_SIGNALS:
    void changed();

private:
    void ask();
    void rename(const std::vector<editing::Renamed>& renamed);
    [[nodiscard]] const charts::Plot* sampledOf(const Meter& meter) const;
    struct Box {
        Meter meter;
        QPointF place;  // of its body
        QPointF beside; // the first place at its right, below the arrow of a selected one
        QRectF rect;
        QString words;
    };
    [[nodiscard]] std::vector<Box> boxes() const; // as they are painted, one over the other
    [[nodiscard]] std::optional<Box> boxAt(const QPointF& position) const; // the one on top
    void paintChart(QPainter& painter, const Box& box) const;

    SceneDocument& document_;
    SeenPicture& picture_;
    MeterLooks looks_;
    struct Held {
        MeterName meter;
        QPointF from;  // of the pointer, when it was taken
        QPointF grip;  // from the corner of the box to the pointer
        QPointF aside; // when it was taken
        bool isDrag;   // the pointer has left that place
    };
    std::optional<Held> held_;
    meters::Sampled sampled_;
    charts::PlotSampler sampler_; // the first to go
};

} // namespace views

// Values beside their bodies and joints while the motion plays: a state of one picture, no part of
// the scene.
//
// They are sampled over the motion on a thread of their own, as charts are, and read between two
// samples: three digits of them are shown. A double click makes one a small chart against time, and
// again a number; a drag puts it elsewhere beside its body, which it follows.
#pragma once

#include "charts/plot_sampler.h"
#include "commands/quantities.h"
#include "labels/seen_picture.h"
#include "workbench/scene_document.h"

#include <QObject>
#include <QPointF>
#include <QRectF>

#include <map>
#include <optional>
#include <vector>

class QPainter;

namespace views {

struct Meter {
    editing::Kind kind = editing::Kind::body;
    std::string element; // its name
    commands::Quantity quantity;
    QPointF aside = {};   // from the first place beside its body; 0: nobody has dragged it
    bool isChart = false; // against time, with a line at the moment
};

class Meters : public QObject {
    Q_OBJECT
public:
    Meters(SceneDocument& document, SeenPicture& picture);

    [[nodiscard]] const std::vector<Meter>& all() const { return meters_; }
    void set(std::vector<Meter> meters);
    [[nodiscard]] bool has(const commands::Quantity& quantity) const;
    void toggle(const editing::Element& element, const commands::Quantity& quantity);
    // "Speed 1.25" of each that is known at that time; "…" while it is computed.
    [[nodiscard]] QString words(const Meter& meter, double time) const;
    void paint(QPainter& painter) const;
    [[nodiscard]] std::optional<std::size_t> at(const QPointF& position) const; // in the widget

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
    void take(std::vector<charts::Plot> plots);
    // In the widget; none: it is gone or hidden.
    struct Place {
        QPointF at;        // of its body or joint
        double reach = 10; // how far that is seen to the right
    };
    [[nodiscard]] std::optional<Place> placeOf(const Meter& meter) const;
    struct Box {
        std::size_t meter = 0;
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
    std::vector<Meter> meters_;
    struct Held {
        std::size_t meter;
        QPointF from;  // of the pointer, when it was taken
        QPointF grip;  // from the corner of the box to the pointer
        QPointF aside; // when it was taken
        bool isDrag;   // the pointer has left that place
    };
    std::optional<Held> held_;
    std::map<std::string, charts::Plot> sampled_; // by the expression
    charts::PlotSampler sampler_;                 // the first to go
};

} // namespace views

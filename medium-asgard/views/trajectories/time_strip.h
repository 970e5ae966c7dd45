// The scale above the time scrollbar: when the points of the selected trajectory are passed
// (dissertation 4.1.4).
//
// A mark for each point on the curve. Dragging one retimes its point, never past its neighbours,
// as one change of its number in the text; the place stays. At first the scale is the scrollbar's
// own; the wheel or the controls at its left zoom in, dragging beside the marks pans. Keys: Page Up
// and Page Down go from mark to mark, the arrows retime (with Shift ten times as far, one step of
// undo until the key is let go), Return asks for the exact time, plus, minus and 0 zoom.
#pragma once

#include "trajectories/time_scale.h"
#include "trajectories/trajectory_drag.h"

#include <QPointer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

class QLineEdit;

namespace views {

class TimeStrip : public QWidget {
    Q_OBJECT
public:
    explicit TimeStrip(SceneDocument& document);

    // Beside it, in the viewer's layout; shown and hidden with it.
    [[nodiscard]] QWidget* controls() const { return controls_; }
    // The scrollbar's.
    void setRange(double start, double finish);
    void setTime(double time);
    // It is there for the selected trajectory, and wherever trajectories are shown.
    void setTrajectoriesShown(bool shown);
    // While that is so it neither comes nor goes: the picture above would change its size under
    // the pointer.
    void setHeld(std::function<bool()> held) { held_ = std::move(held); }

    // The selected one, in the scene that is shown.
    [[nodiscard]] std::optional<std::size_t> trajectory() const { return trajectory_; }
    // One of editing::controlPointsOf().
    void setChosen(std::optional<std::size_t> point);
    [[nodiscard]] std::optional<std::size_t> chosen() const { return chosen_; }
    [[nodiscard]] double position(double time) const; // in this widget
    void zoom(double factor, double about);           // about a time
    void showAll();                                   // the whole motion and all marks
    [[nodiscard]] double from() const { return scale_.from(); }
    [[nodiscard]] double to() const { return scale_.to(); }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void markChosen(std::size_t trajectory, std::size_t point);
    void says(const QString& sentence, bool isFault); // "": nothing any more

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    using Points = std::vector<editing::ControlPoint>;

    void buildControls();
    void follow(); // another scene, or another selection
    void updateVisibility();
    [[nodiscard]] Points points() const;
    [[nodiscard]] const std::vector<scene::BezierCurve>& curves() const;
    [[nodiscard]] QString name() const;
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double timeStep() const { return timeAt(1) - timeAt(0); } // of a pixel
    [[nodiscard]] std::optional<std::size_t> markAt(const QPointF& position) const;
    [[nodiscard]] std::optional<QPoint> placeOfChosen() const;
    void scaled(bool isOther); // the scale shows another time
    void choose(std::size_t point);
    void chooseNext(int step);
    [[nodiscard]] bool begin();
    void retime(double time);
    void nudge(double steps);
    void finish();
    void cancel();
    void askForTime();
    void takeTime();
    void leaveField();
    void removeChosen();
    void paintScale(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;

    SceneDocument& document_;
    QWidget* controls_;
    std::optional<std::size_t> trajectory_, chosen_;
    TimeScale scale_;
    double now_ = 0;
    bool trajectoriesShown_ = false;
    std::function<bool()> held_;
    std::unique_ptr<TrajectoryDrag> gesture_;
    enum class Grip { none, mark, scale };
    struct Press { // of a button that is held
        Grip grip = Grip::none;
        QPointF at;
        bool left = false; // the pointer has left that place clearly
        double offset = 0; // pixels from the pointer to the mark
        double time = 0;   // that was under it
    };
    Press press_;
    QPointer<QLineEdit> field_;
};

} // namespace views

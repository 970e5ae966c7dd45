// The time scrollbar: its slider's left edge is now, its length one second (dissertation 4.1).
//
// The trough is filled as far as the motion is computed, and shows from when on the motion is not
// predictable, and where bodies hit. A QAbstractSlider, so that keys, wheel and screen readers work
// as on any slider.
#pragma once

#include <QAbstractSlider>

#include <optional>
#include <vector>

namespace views {

class TimeBar : public QAbstractSlider {
    Q_OBJECT
public:
    explicit TimeBar(QWidget* parent = nullptr);

    void setRange(double start, double finish, double computed);
    [[nodiscard]] double computed() const { return computed_; } // filled to there
    void setMarks(std::optional<double> predictableUntil, std::vector<double> impacts);
    struct Fault {
        double time = 0;
        bool isError = false;
        QString words;
    };
    void setFaults(std::vector<Fault> faults);             // marks with their words as tips
    [[nodiscard]] QString faultsAt(double position) const; // "" where there is no mark
    // The words of all marks there: of faults, and of where bodies hit.
    [[nodiscard]] QString wordsAt(double position) const;
    void setTime(double time); // emits nothing
    void setStale(bool stale); // the motion is an older scene's

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

    // Of the time, in this widget: the slider's left edge.
    [[nodiscard]] double position(double time) const;

Q_SIGNALS:
    void timeChosen(double time);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void sliderChange(SliderChange change) override;

private:
    [[nodiscard]] double timeAt(double position) const;
    [[nodiscard]] QRectF trough() const;
    [[nodiscard]] QRectF slider() const;
    [[nodiscard]] QColor faint(int alpha) const;
    void paintTrough(QPainter& painter) const;
    void paintFaults(QPainter& painter) const;
    void paintScale(QPainter& painter) const;
    void paintSlider(QPainter& painter) const;

    double start_ = 0, finish_ = 1, computed_ = 0, time_ = 0;
    std::optional<double> predictableUntil_;
    std::vector<double> impacts_;
    std::vector<Fault> faults_;
    bool isStale_ = false;
    double grip_ = 0;               // where the slider was taken, from its left edge
    std::optional<double> pressed_; // there, and the pointer has not left that place
    bool setting_ = false;          // the value changes because the time does
};

} // namespace views

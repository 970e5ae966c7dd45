// The picture of one window: asked of the thread that draws, waited for as long as nobody notices,
// coarse while something moves and fine once it rests.
#pragma once

#include "painting/picture_thread.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>

class QPainter;
class QWidget;

namespace views {

class WindowPicture : public QObject {
    Q_OBJECT
public:
    // The scene, the time, the display and the viewpoint that the window is to show; the size, the
    // fineness and the paper's colour are this class's.
    using Wish = std::function<PictureWish()>;
    // False: nobody wants that picture any more, and the last one stays.
    using MayTake = std::function<bool(const Picture&)>;

    WindowPicture(QWidget& window, std::shared_ptr<PictureThread> thread, Wish wish,
                  MayTake mayTake = {});
    ~WindowPicture() override;

    // How long a window waits for a picture before it goes on without.
    static void setPatience(std::chrono::milliseconds patience);

    // Another picture is wanted; `moving`: soon one more.
    void redraw(bool moving);
    [[nodiscard]] bool isMoving() const { return isMoving_; }
    // The newest wish is asked for, and waited for as long as there is patience.
    void bringUpToDate();
    // The last one, maybe of something older; null: none yet.
    [[nodiscard]] const Picture* last() const { return picture_.get(); }
    [[nodiscard]] bool isNewest() const { return !isOld_ && isOfLastWish(); }
    [[nodiscard]] bool isOfLastWish() const { return picture_ && picture_->of.serial == wished_; }

    [[nodiscard]] render::Size pixelSize() const;
    [[nodiscard]] Eigen::Vector2d inPixels(const QPointF& position) const; // of the window
    [[nodiscard]] QPointF fromPixels(const Eigen::Vector2d& pixels) const;

    // False: there can be no picture, and the reason is painted.
    bool paint(QPainter& painter) const;
    [[nodiscard]] const std::shared_ptr<PictureThread>& thread() const { return thread_; }

Q_SIGNALS:
    void taken(); // another picture is the last one
    void came();  // a picture, later than the window waited

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void ask();
    void take();
    void ready(); // the thread has drawn a picture

    QWidget& window_;
    std::shared_ptr<PictureThread> thread_;
    Wish wish_;
    MayTake mayTake_;
    PictureThread::PicturePointer picture_;
    unsigned wished_ = 0, waitedFor_ = 0; // serials
    bool isOld_ = true;                   // what is shown is not what was wished for last
    bool isMoving_ = false;
    int slow_ = 0;  // pictures with shadows in a row that would not move smoothly
    QTimer settle_; // then the fine picture is drawn
};

} // namespace views

#include "painting/window_picture.h"

#include <QEvent>
#include <QPainter>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

// Long enough for most pictures, and shorter than what one notices.
std::chrono::milliseconds patience{12};

// While something moves a picture with shadows may take that long: 20 of them a second.
constexpr std::chrono::milliseconds smooth{50};
// So many slower ones in a row, and shadows wait for the rest: one alone is a busy machine's.
constexpr int mostSlow = 8;

} // namespace

WindowPicture::WindowPicture(QWidget& window, std::shared_ptr<PictureThread> thread, Wish wish,
                             MayTake mayTake)
    : window_(window), thread_(std::move(thread)), wish_(std::move(wish)),
      mayTake_(std::move(mayTake)) {
    thread_->open(this, [this] {
        QMetaObject::invokeMethod(this, &WindowPicture::ready, Qt::QueuedConnection);
    });
    window_.installEventFilter(this);
    settle_.setSingleShot(true);
    settle_.setInterval(180);
    connect(&settle_, &QTimer::timeout, this, [this] { redraw(false); });
}

WindowPicture::~WindowPicture() { thread_->forget(this); }

void WindowPicture::setPatience(std::chrono::milliseconds most) { patience = most; }

render::Size WindowPicture::pixelSize() const {
    const QSizeF size = QSizeF(window_.size()) * window_.devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(size.width()))),
            std::max(1, static_cast<int>(std::lround(size.height()))), window_.devicePixelRatioF()};
}

Eigen::Vector2d WindowPicture::inPixels(const QPointF& position) const {
    return Eigen::Vector2d(position.x(), position.y()) * window_.devicePixelRatioF();
}

QPointF WindowPicture::fromPixels(const Eigen::Vector2d& pixels) const {
    return QPointF(pixels.x(), pixels.y()) / window_.devicePixelRatioF();
}

bool WindowPicture::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize)
        isOld_ = true;
    else if (event->type() == QEvent::PaletteChange)
        redraw(false);
    return QObject::eventFilter(watched, event);
}

void WindowPicture::redraw(bool moving) {
    isMoving_ = moving;
    isOld_ = true;
    if (moving)
        settle_.start();
    window_.update();
}

void WindowPicture::ask() {
    if (!isOld_)
        return;
    isOld_ = false;
    PictureWish wish = wish_();
    if (!picture_ || picture_->of.shown.scene->bodies.size() != wish.shown.scene->bodies.size())
        slow_ = 0; // a scene with other bodies is tried again
    wish.serial = ++wished_;
    wish.display.samples = isMoving_ ? 1 : 4;
    wish.display.shadows = wish.display.shadows && !(isMoving_ && slow_ >= mostSlow);
    const QColor paper = window_.palette().color(QPalette::Base);
    wish.display.background = {paper.redF(), paper.greenF(), paper.blueF()};
    wish.size = pixelSize();
    thread_->draw(this, std::move(wish));
}

void WindowPicture::take() {
    auto last = thread_->last(this);
    if (!last || last == picture_ || (picture_ && mayTake_ && !mayTake_(*last)))
        return;
    if (auto old = std::exchange(picture_, std::move(last)))
        thread_->drop(std::move(old));
    if (const render::Display& display = picture_->of.display;
        display.shadows && display.samples == 1)
        slow_ = picture_->lasted > smooth ? slow_ + 1 : 0;
    Q_EMIT taken();
}

void WindowPicture::bringUpToDate() {
    ask();
    const bool isSlow = picture_ && picture_->lasted > 2 * patience;
    if (waitedFor_ != wished_ && !isSlow) { // once for each: many may ask before it comes
        waitedFor_ = wished_;
        thread_->wait(this, wished_, patience);
    }
    take();
}

void WindowPicture::ready() {
    take();
    window_.update();
    Q_EMIT came();
}

bool WindowPicture::paint(QPainter& painter) const {
    const QRect all = window_.rect();
    if (picture_ && !picture_->fault.isEmpty()) {
        painter.fillRect(all, window_.palette().base());
        painter.setPen(window_.palette().color(QPalette::Text));
        painter.drawText(all.adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         picture_->fault);
        return false;
    }
    const QImage image = picture_ ? picture_->image : QImage();
    if (image.isNull() || image.deviceIndependentSize().toSize() != window_.size())
        painter.fillRect(all, window_.palette().base());
    painter.drawImage(QPointF(0, 0), image);
    return true;
}

} // namespace views

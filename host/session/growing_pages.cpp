#include "session/growing_pages.h"

#include <QElapsedTimer>

namespace session {

namespace {

constexpr int sliceMs = 8;

} // namespace

GrowingPages::GrowingPages() {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &GrowingPages::slice);
}

GrowingPages::~GrowingPages() = default;

void GrowingPages::startAnew() {
    pagination_.reset();
    timer_.start(0);
}

void GrowingPages::stop() {
    pagination_.reset();
    timer_.stop();
}

void GrowingPages::setBase(const layout::Pages& base) {
    base_ = pages_ = base;
    told_ = 0;
}

void GrowingPages::layOut(const layout::ModelPointer& model, const paragraphs::Objects& objects) {
    told_ = 0;
    pagination_ = std::make_unique<layout::Pagination>(model, objects, base_);
}

bool GrowingPages::step() {
    if (pagination_->step())
        return true;
    timer_.stop();
    base_ = pages_ = pagination_->take();
    pagination_.reset();
    Q_EMIT complete();
    return false;
}

void GrowingPages::slice() {
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < sliceMs)
        if (!step())
            return;
    goOn();
}

void GrowingPages::settle(int mostMs) {
    QElapsedTimer time;
    time.start();
    while (timer_.isActive() && time.elapsed() < mostMs && step()) {
    }
}

// Told seldom enough that whoever looks at all pages each time does not look at too many.
void GrowingPages::goOn() {
    timer_.start(0); // first, so that whoever is told knows that more is to come
    if (!pagination_ || pagination_->count() < told_ + told_ / 4 + 1)
        return;
    told_ = pagination_->count();
    pages_ = pagination_->pages();
    Q_EMIT grown();
}

} // namespace session

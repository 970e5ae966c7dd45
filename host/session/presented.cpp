#include "session/presented.h"

#include "layout/measure.h"
#include "layout/typeface.h"

namespace session {

namespace {

constexpr int sliceMs = 8;
constexpr int nodesAtOnce = 25;
// So long a picture file is not looked at again: each edit asks for the sizes of all.
constexpr int imagesMs = 1000;

} // namespace

Presented::Presented(OpenDocument& document, QString presentation)
    : document_(document), presentation_(std::move(presentation)) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Presented::slice);
    connect(&document_.document(), &document::Document::edited, this, &Presented::follow);
    connect(&document_.document(), &document::Document::fileNameChanged, this, [this] {
        imagesAsked_.invalidate(); // they are looked for in another folder
        require(Due::layout);
    });
    connect(&document_, &OpenDocument::resized, this, [this] { require(Due::layout); });
    begin();
}

Presented::~Presented() = default;

// From nothing.
void Presented::begin() {
    className_ = document_.document().className();
    by_ = &document_.schemas().presentation(className_, presentation_);
    builder_ =
        std::make_unique<model::ModelBuilder>(document_.document(), *by_, document_.schemas());
    base_ = {};
    pages_ = {};
    pages_.size = {layout::fromPoints(page().width), layout::fromPoints(page().height)};
    pages_.paper = layout::colorOf(page().background);
    pagination_.reset();
    due_ = Due::model;
    told_ = 0;
    for (int i = 0; i < firstSteps; ++i)
        if (!step())
            return;
    timer_.start(0); // first, so that whoever is told knows that more is to come
    tell();
}

void Presented::follow(const sgml::Change& change) {
    builder_->follow(change);
    require(Due::model);
}

// What is being made is of an older state; what it is compared with is complete.
void Presented::require(Due due) {
    due_ = std::max(due_, due);
    pagination_.reset();
    timer_.start(0);
}

// False: all is made.
bool Presented::step() {
    if (due_ == Due::model) {
        if (builder_->step(nodesAtOnce))
            return true;
        title_ = QString::fromStdString(builder_->model()->title);
        due_ = Due::layout;
        return true;
    }
    if (due_ == Due::layout) {
        due_ = Due::nothing;
        told_ = 0;
        pagination_ = std::make_unique<layout::Pagination>(builder_->model(), objects(), base_);
        return true;
    }
    if (pagination_->step())
        return true;
    finish();
    return false;
}

void Presented::slice() {
    if (document_.document().className() != className_)
        return begin(); // another class has other presentations
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < sliceMs)
        if (!step())
            return;
    timer_.start(0); // first, so that whoever is told knows that more is to come
    tell();
}

void Presented::settle(int mostMs) {
    if (document_.document().className() != className_)
        begin();
    QElapsedTimer time;
    time.start();
    while (timer_.isActive() && time.elapsed() < mostMs && step()) {
    }
}

// Seldom enough that whoever looks at all pages each time does not look at too many.
void Presented::tell() {
    if (!pagination_ || pagination_->count() < told_ + told_ / 4 + 1)
        return;
    told_ = pagination_->count();
    pages_ = pagination_->pages();
    Q_EMIT grown();
}

void Presented::finish() {
    timer_.stop();
    base_ = pages_ = pagination_->take();
    pagination_.reset();
    Q_EMIT complete();
}

layout::Objects Presented::objects() {
    return {[this](document::SubdocumentId id) { return layout::fromPixels(document_.sizeOf(id)); },
            [this](const std::string& source) { return imageSize(source); }};
}

QSize Presented::imageSize(const std::string& source) {
    if (!imagesAsked_.isValid() || imagesAsked_.hasExpired(imagesMs)) {
        imageSizes_.clear();
        imagesAsked_.start();
    }
    const auto [known, isNew] = imageSizes_.try_emplace(source);
    if (isNew)
        known->second = document_.images().size(source);
    return known->second;
}

} // namespace session

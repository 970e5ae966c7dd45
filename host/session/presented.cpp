#include "session/presented.h"

#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

namespace session {

namespace {

constexpr int nodesAtOnce = 25;
// So long a picture file is not looked at again: each edit asks for the sizes of all.
constexpr int imagesMs = 1000;

} // namespace

Presented::Presented(OpenDocument& document, QString presentation)
    : document_(document), presentation_(std::move(presentation)) {
    connect(&document_.document(), &document::Document::edited, this, &Presented::follow);
    connect(&document_.document(), &document::Document::fileNameChanged, this, [this] {
        imagesAsked_.invalidate(); // they are looked for in another folder
        require(Due::layout);
    });
    connect(&document_, &OpenDocument::resized, this, [this] { require(Due::layout); });
    connect(&document_.values(), &Values::changed, this, &Presented::followValues);
    connect(&document_, &OpenDocument::presentedAnew, this, [this] {
        readAnew(); // the old pages are shown meanwhile
        startAnew();
    });
    begin();
}

Presented::~Presented() = default;

// From nothing.
void Presented::begin() {
    readAnew();
    layout::Pages none;
    none.size = {paragraphs::fromPoints(page().width), paragraphs::fromPoints(page().height)};
    none.paper = paragraphs::colorOf(page().background);
    stop();
    setBase(none);
    for (int i = 0; i < firstSteps; ++i)
        if (!step())
            return;
    goOn();
}

void Presented::readAnew() {
    className_ = document_.document().className();
    by_ = &document_.schemas().presentation(className_, presentation_);
    builder_ =
        std::make_unique<model::ModelBuilder>(document_.document(), *by_, document_.schemas());
    builder_->setValues(&document_.values());
    due_ = Due::model;
}

void Presented::follow(const sgml::Change& change) {
    builder_->follow(change);
    require(Due::model);
}

void Presented::require(Due due) {
    due_ = std::max(due_, due);
    startAnew();
}

// Not while pages are being made: numbers that change on and on would never let them be finished.
void Presented::followValues() {
    areValuesDue_ = due_ != Due::nothing || !isComplete();
    if (!areValuesDue_ && builder_->followValues())
        require(Due::layout);
}

bool Presented::step() {
    if (due_ == Due::nothing) {
        if (GrowingPages::step())
            return true;
        if (areValuesDue_)
            followValues();
        return !isComplete();
    }
    if (due_ == Due::model) {
        if (document_.document().className() != className_) {
            begin(); // another class has other presentations
            return !isComplete();
        }
        if (builder_->step(nodesAtOnce))
            return true;
        title_ = QString::fromStdString(builder_->model()->title);
        due_ = Due::layout;
        return true;
    }
    due_ = Due::nothing;
    layOut(builder_->model(), objects());
    Q_EMIT modelled();
    return true;
}

void Presented::settleModel(int mostMs) {
    QElapsedTimer time;
    time.start();
    while (!isModelled() && time.elapsed() < mostMs && step()) {
    }
}

paragraphs::Objects Presented::objects() {
    return {
        [this](document::SubdocumentId id) { return paragraphs::fromPixels(document_.sizeOf(id)); },
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

#include "session/presented.h"

#include "document/model_builder.h"
#include "layout/measure.h"
#include "layout/typeface.h"

#include <QElapsedTimer>

namespace session {

namespace {

constexpr int sliceMs = 8;
constexpr int nodesAtOnce = 25;

} // namespace

struct Presented::Making {
    explicit Making(const OpenDocument& document, const document::Presentation& presentation)
        : builder(std::make_unique<document::ModelBuilder>(document.document(), presentation,
                                                           document.schemas())) {}
    std::unique_ptr<document::ModelBuilder> builder; // until the model is complete
    layout::Objects objects;
    std::unique_ptr<layout::Pagination> pagination;
};

Presented::Presented(OpenDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Presented::slice);
    // A model is of one state of the document. Pages need the document no more.
    connect(&document_.document(), &document::Document::changed, this, [this] {
        if (making_ && making_->builder)
            begin(presentation_);
    });
}

Presented::~Presented() = default;

void Presented::begin(const QString& presentation) {
    fresh_ = !begun_ || (fresh_ && making_) || presentation != presentation_;
    begun_ = true;
    presentation_ = presentation;
    const document::Presentation& by =
        document_.schemas().presentation(document_.document().className(), presentation);
    page_ = by.page();
    making_ = std::make_unique<Making>(document_, by);
    making_->objects.subdocumentSize = [this](document::SubdocumentId id) {
        return layout::fromPixels(document_.sizeOf(id));
    };
    making_->objects.imageSize = [this](const std::string& source) {
        return document_.images().size(source);
    };
    if (fresh_) {
        pages_ = {};
        pages_.size = {layout::fromPoints(page_.width), layout::fromPoints(page_.height)};
        pages_.paper = layout::colorOf(page_.background);
    }
    told_ = 0;
    for (int i = 0; i < firstSteps; ++i)
        if (!step())
            return finish();
    tell();
    timer_.start(0);
}

// False: all is made.
bool Presented::step() {
    Making& making = *making_;
    if (making.pagination)
        return making.pagination->step();
    if (making.builder->step(nodesAtOnce))
        return true;
    const auto model = std::make_shared<const document::Model>(making.builder->take());
    title_ = QString::fromStdString(model->title);
    making.builder.reset();
    making.pagination = std::make_unique<layout::Pagination>(model, making.objects, pages_);
    return true;
}

void Presented::slice() {
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < sliceMs)
        if (!step())
            return finish();
    tell();
    timer_.start(0);
}

// Seldom enough that whoever looks at all pages each time does not look at too many.
void Presented::tell() {
    const std::size_t now = making_->pagination ? making_->pagination->count() : 0;
    if (!fresh_ || now < told_ + told_ / 4 + 1)
        return;
    told_ = now;
    pages_ = making_->pagination->pages();
    Q_EMIT grown();
}

void Presented::finish() {
    timer_.stop();
    pages_ = making_->pagination->take();
    making_.reset();
    Q_EMIT complete();
}

} // namespace session

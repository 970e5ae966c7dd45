#include "session/samples.h"

#include "files/read.h"
#include "ipc/bounds.h"
#include "text/characters.h"

#include <QFile>
#include <QFileInfo>

namespace session {

MediumText readMediumText(const QString& file) {
    const files::ReadFile read = files::readFile(
        files::FileSystem::real(), QFile::encodeName(file).toStdString(), ipc::longestText.most);
    const QString name = QFileInfo(file).fileName();
    if (!read.read)
        return {
            {},
            QObject::tr("%1 cannot be read: %2.").arg(name, QString::fromStdString(read.reason))};
    if (!text::isUtf8(read.bytes))
        return {{}, QObject::tr("%1 is no text in UTF-8.").arg(name)};
    std::string bytes = read.bytes;
    if (bytes.starts_with(text::byteOrderMark))
        bytes.erase(0, text::byteOrderMark.size());
    return {std::move(bytes), {}};
}

SamplePictures::SamplePictures(media::LiveMedia& media, const media::Manifest& manifest,
                               QSize pixels, double scale, QObject* parent)
    : QObject(parent), media_(media), manifest_(manifest), pixels_(pixels), scale_(scale) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, [this] {
        done({{}, tr("%1 did not draw it in time.").arg(manifest_.name)});
    });
}

SamplePictures::~SamplePictures() = default;

void SamplePictures::add(int sample) {
    waiting_.insert(waiting_.begin(), sample);
    if (!current_)
        QMetaObject::invokeMethod(this, &SamplePictures::next, Qt::QueuedConnection);
}

// The text of the next one follows the last one's in the same process.
void SamplePictures::next() {
    if (current_)
        return;
    if (waiting_.empty()) {
        live_.reset();
        return;
    }
    current_ = waiting_.back();
    waiting_.pop_back();
    isLoaded_ = isAsked_ = false;
    timer_.start(mostMs);
    const MediumText text = readMediumText(fileOf(manifest_, manifest_.samples[*current_]));
    if (!text.fault.isEmpty())
        return done({{}, text.fault});
    if (!live_) {
        live_ = media_.create(manifest_.documentClass);
        live_->setMode(media::Mode::batch);
        connect(live_.get(), &media::LiveSubdocument::loaded, this, [this] {
            isLoaded_ = true;
            shoot();
        });
        // Before it has said this, its presentations are not known.
        connect(live_.get(), &media::LiveSubdocument::preferredSizeChanged, this,
                &SamplePictures::shoot);
        connect(live_.get(), &media::LiveSubdocument::conditionChanged, this, [this] {
            if (live_->condition() == media::Condition::failed && current_)
                done({{}, live_->reason()});
        });
    }
    live_->setText(QByteArray::fromStdString(text.text));
    // Nearer than anything that is seen: the user waits for it.
    media_.setDistance(*live_, this, -1);
    if (live_->condition() == media::Condition::failed)
        live_->startAgain();
}

void SamplePictures::shoot() {
    if (!current_ || !isLoaded_ || !live_->preferredSize() || std::exchange(isAsked_, true))
        return;
    const QPointer<SamplePictures> self(this);
    const int asked = ++asked_;
    live_->snapshot(pixels_, scale_, manifest_.samples[*current_].time,
                    [self, asked](const media::LiveSubdocument::Snapshot& snapshot) {
                        if (self && self->asked_ == asked)
                            self->done(snapshot);
                    });
}

void SamplePictures::done(const media::LiveSubdocument::Snapshot& snapshot) {
    if (!current_)
        return;
    timer_.stop();
    ++asked_; // an answer that comes later is for nobody
    const int sample = *std::exchange(current_, std::nullopt);
    QMetaObject::invokeMethod(this, &SamplePictures::next, Qt::QueuedConnection);
    if (snapshot.error.isEmpty() && !snapshot.picture.isNull())
        Q_EMIT drawn(sample, snapshot.picture);
    else
        Q_EMIT failed(sample, snapshot.error);
}

} // namespace session

#include "session/pictures.h"

#include <algorithm>

namespace session {

namespace {

constexpr std::size_t atOnce = 4;
constexpr double largestPixels = 8192;

// Of one colour everywhere: what a medium draws that has nothing to show.
bool isEmpty(const QImage& image) {
    const QRgb first = image.isNull() ? 0 : image.pixel(0, 0);
    for (int y = 0; y < image.height(); ++y) {
        const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x)
            if (line[x] != first)
                return false;
    }
    return true;
}

} // namespace

Pictures::Pictures(OpenDocument& document, std::vector<document::SubdocumentId> wanted,
                   double scale, bool posters, QObject* parent)
    : QObject(parent), document_(document), queue_(wanted.rbegin(), wanted.rend()), scale_(scale),
      posters_(posters), all_(static_cast<int>(wanted.size())) {}

Pictures::~Pictures() {
    for (const document::SubdocumentId id : document_.document().subdocuments())
        if (media::LiveSubdocument* live = document_.live(id))
            document_.media().setDistance(*live, this, media::LiveMedia::notNeeded);
}

void Pictures::start() { QMetaObject::invokeMethod(this, &Pictures::next, Qt::QueuedConnection); }

void Pictures::next() {
    while (running_ < atOnce && !queue_.empty()) {
        const document::SubdocumentId wanted = queue_.back();
        queue_.pop_back();
        ++running_;
        take(wanted);
    }
    if (running_ == 0 && queue_.empty())
        Q_EMIT finished();
}

void Pictures::take(document::SubdocumentId wanted) {
    media::LiveSubdocument* live = document_.live(wanted);
    if (!live) {
        done(wanted, {{}, document_.whyNotLive(wanted)});
        return;
    }
    // Lives as long as this picture is on its way, and takes its connections with it.
    auto* watch = new QObject(this);
    const auto look = [this, wanted, live, watch] {
        if (live->hasLoaded() && live->preferredSize()) {
            watch->deleteLater();
            watch->disconnect();
            live->disconnect(watch);
            shoot(wanted, *live);
        } else if (live->condition() == media::Condition::failed) {
            watch->deleteLater();
            live->disconnect(watch);
            done(wanted, {{}, live->reason()});
        }
    };
    connect(live, &media::LiveSubdocument::loaded, watch, look);
    connect(live, &media::LiveSubdocument::preferredSizeChanged, watch, look);
    connect(live, &media::LiveSubdocument::conditionChanged, watch, look);
    QTimer::singleShot(mostMs, watch, [this, wanted, live, watch] {
        watch->deleteLater();
        live->disconnect(watch);
        done(wanted, {{}, tr("%1 was not ready in time.").arg(live->name())});
    });
    // Nearer than anything that is seen: it is needed for the paper now.
    document_.media().setDistance(*live, this, -1);
    look();
}

void Pictures::shoot(document::SubdocumentId wanted, media::LiveSubdocument& live) {
    const QSizeF size = document_.sizeOf(wanted);
    const double scale =
        std::min({scale_, largestPixels / size.width(), largestPixels / size.height()});
    const QSize pixels = (size * scale).toSize().expandedTo({1, 1});
    const document::Subdocument* subdocument = document_.document().subdocument(wanted);
    const std::optional<double> time =
        posters_ && subdocument ? subdocument->poster : std::optional<double>();
    const QPointer<Pictures> guard(this);
    const auto open = std::make_shared<bool>(true);
    const auto answer = [guard, wanted, open](media::LiveSubdocument::Snapshot snapshot) {
        if (!std::exchange(*open, false) || !guard)
            return;
        guard->done(wanted, {snapshot.picture, snapshot.error});
    };
    QTimer::singleShot(mostMs, this, [answer] {
        answer({{}, tr("The picture was not finished in time.")});
    });
    live.snapshot(pixels, scale, time, answer);
}

void Pictures::done(document::SubdocumentId wanted, Picture picture) {
    if (picture.image.isNull() && picture.error.isEmpty())
        picture.error = tr("The medium drew no picture.");
    for (const ListedFault& fault : document_.faultsOf(wanted))
        if (fault.isError && picture.error.isEmpty())
            picture.error = tr("line %1: %2").arg(fault.position.line).arg(fault.message);
    picture.note = picture.error.isEmpty() ? document_.emptyNotice(wanted) : picture.error;
    if (!picture.note.isEmpty() && (picture.error.isEmpty() || isEmpty(picture.image)))
        picture.image = {};
    pictures_[wanted] = std::move(picture);
    if (media::LiveSubdocument* live = document_.live(wanted))
        document_.media().setDistance(*live, this, media::LiveMedia::notNeeded);
    --running_;
    Q_EMIT progressed(all_ - static_cast<int>(remaining()), all_);
    QMetaObject::invokeMethod(this, &Pictures::next, Qt::QueuedConnection);
}

} // namespace session

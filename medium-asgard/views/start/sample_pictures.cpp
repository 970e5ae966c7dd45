#include "start/sample_pictures.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTimer>

#include <utility>

namespace views {

namespace {

constexpr int longestMs = 20'000; // for one picture

} // namespace

SamplePictures::SamplePictures(QString program, QString folder, QObject* parent)
    : QObject(parent), program_(std::move(program)), folder_(std::move(folder)) {
    connect(&process_, &QProcess::finished, this, &SamplePictures::take);
    // Queued: it may come within start().
    connect(
        &process_, &QProcess::errorOccurred, this,
        [this](QProcess::ProcessError error) {
            if (error == QProcess::FailedToStart)
                take();
        },
        Qt::QueuedConnection);
}

SamplePictures::~SamplePictures() {
    process_.disconnect(this);
    if (process_.state() != QProcess::NotRunning) {
        process_.kill();
        process_.waitForFinished();
    }
}

// A scene that was changed has another picture, and so has a program that was installed anew.
QString SamplePictures::pathOf(const Sample& sample, const QSize& pixels,
                               const QColor& background) const {
    QFile file(sample.path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (file.open(QIODevice::ReadOnly))
        hash.addData(file.readAll());
    const QFileInfo program(program_);
    hash.addData(QStringLiteral("%1 %2")
                     .arg(program.size())
                     .arg(program.lastModified().toMSecsSinceEpoch())
                     .toUtf8());
    const QString name = QStringLiteral("%1-%2-%3x%4-%5.png")
                             .arg(QString::fromLatin1(hash.result().toHex().left(16)))
                             .arg(sample.time)
                             .arg(pixels.width())
                             .arg(pixels.height())
                             .arg(background.name().mid(1));
    return QDir(folder_).filePath(name);
}

void SamplePictures::ask(QList<Sample> samples, const QSize& pixels, const QColor& background) {
    const bool idle = waiting_.isEmpty();
    waiting_.resize(idle ? 0 : 1);
    if (!idle)
        waiting_.front().isWanted = false;
    for (Sample& sample : samples) {
        const QString path = pathOf(sample, pixels, background);
        if (const QImage kept(path); !kept.isNull())
            Q_EMIT drawn(sample, kept);
        else if (!idle && waiting_.front().path == path)
            waiting_.front().isWanted = true;
        else
            waiting_.push_back({std::move(sample), pixels, background, path});
    }
    if (idle)
        next();
}

void SamplePictures::next() {
    if (waiting_.isEmpty())
        return;
    const Wish& wish = waiting_.front();
    QDir().mkpath(folder_);
    process_.start(program_,
                   {"render", wish.sample.path, "--time", QString::number(wish.sample.time),
                    "--size",
                    QStringLiteral("%1x%2").arg(wish.pixels.width()).arg(wish.pixels.height()),
                    "--background", wish.background.name(), "--output", wish.path});
    QTimer::singleShot(longestMs, &process_, [this, path = wish.path] {
        if (!waiting_.isEmpty() && waiting_.front().path == path)
            process_.kill();
    });
}

void SamplePictures::take() {
    const Wish wish = waiting_.takeFirst();
    if (!wish.isWanted) // it is kept for another time
        return next();
    if (const QImage image(wish.path); !image.isNull())
        Q_EMIT drawn(wish.sample, image);
    else
        Q_EMIT failed(wish.sample);
    next();
}

} // namespace views

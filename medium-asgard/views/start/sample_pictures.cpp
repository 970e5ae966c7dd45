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
QString SamplePictures::pathOf(const Sample& sample) const {
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
                             .arg(pixels_.width())
                             .arg(pixels_.height())
                             .arg(background_.name().mid(1));
    return QDir(folder_).filePath(name);
}

void SamplePictures::ask(QList<Sample> samples, const QSize& pixels, const QColor& background) {
    pixels_ = pixels;
    background_ = background;
    const bool idle = waiting_.isEmpty();
    for (Sample& sample : samples) {
        if (const QImage kept(pathOf(sample)); !kept.isNull())
            Q_EMIT drawn(sample, kept);
        else
            waiting_.push_back(std::move(sample));
    }
    if (idle)
        next();
}

void SamplePictures::next() {
    if (waiting_.isEmpty())
        return;
    const Sample& sample = waiting_.front();
    QDir().mkpath(folder_);
    process_.start(program_,
                   {"render", sample.path, "--time", QString::number(sample.time), "--size",
                    QStringLiteral("%1x%2").arg(pixels_.width()).arg(pixels_.height()),
                    "--background", background_.name(), "--output", pathOf(sample)});
    QTimer::singleShot(longestMs, &process_, [this, path = sample.path] {
        if (!waiting_.isEmpty() && waiting_.front().path == path)
            process_.kill();
    });
}

void SamplePictures::take() {
    const Sample sample = waiting_.takeFirst();
    if (const QImage image(pathOf(sample)); !image.isNull())
        Q_EMIT drawn(sample, image);
    else
        Q_EMIT failed(sample);
    next();
}

} // namespace views

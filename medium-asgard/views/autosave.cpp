#include "views/autosave.h"

#include "plain/plain.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPushButton>
#include <QSaveFile>
#include <QStandardPaths>

namespace views {

namespace {

const QString aboutEnding = QStringLiteral(".json");
const QString lockEnding = QStringLiteral(".lock");
const QString textEnding = QStringLiteral(".al");

QString with(const QString& textFile, const QString& ending) {
    return textFile.chopped(textEnding.size()) + ending;
}

// "" or why not. Written beside it and renamed: what was there stays until the new is whole.
QString write(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return file.errorString();
    return {};
}

std::shared_ptr<QLockFile> lockOf(const QString& textFile) {
    auto lock = std::make_shared<QLockFile>(with(textFile, lockEnding));
    lock->setStaleLockTime(0); // held as long as its process lives, however long that is
    return lock;
}

QString sceneOf(const LeftBehind& left) {
    return left.scene.isEmpty() ? Autosave::tr("a scene that was never saved")
                                : QFileInfo(left.scene).fileName();
}

QMessageBox::StandardButton ask(QWidget* over, const LeftBehind& left) {
    plain::Message box(QMessageBox::Question, Autosave::tr("Recover"),
                       Autosave::tr("Changes to %1 were not saved.").arg(sceneOf(left)),
                       QMessageBox::NoButton, over);
    box.setSecondText(Autosave::tr("Asgard ended before they could be, on %1. Recover them?")
                          .arg(QLocale().toString(left.at.toLocalTime(), QLocale::ShortFormat)));
    QPushButton* recover = box.addButton(Autosave::tr("&Recover"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(Autosave::tr("&Discard"), QMessageBox::DestructiveRole);
    box.addButton(Autosave::tr("&Later"), QMessageBox::RejectRole);
    box.setDefaultButton(recover);
    box.exec();
    if (box.clickedButton() == recover)
        return QMessageBox::Yes;
    return box.clickedButton() == discard ? QMessageBox::Discard : QMessageBox::Cancel;
}

} // namespace

QString autosaveFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
           QStringLiteral("/unsaved");
}

Autosave::Autosave(SceneDocument& document, const QString& folder, int quiet, int longest)
    : document_(document), folder_(folder) {
    quiet_.setSingleShot(true);
    quiet_.setInterval(quiet);
    longest_.setSingleShot(true);
    longest_.setInterval(longest);
    connect(&quiet_, &QTimer::timeout, this, &Autosave::keep);
    connect(&longest_, &QTimer::timeout, this, &Autosave::keep);
    connect(&document_, &SceneDocument::nameChanged, this, &Autosave::documentChanged);
}

Autosave::~Autosave() { forget(); }

// A text that changed, or became the file's.
void Autosave::documentChanged() {
    if (!document_.isModified())
        return forget();
    quiet_.start();
    if (!longest_.isActive())
        longest_.start();
}

bool Autosave::claim() {
    if (lock_)
        return true;
    if (!QDir().mkpath(folder_))
        return false;
    const qint64 process = QCoreApplication::applicationPid();
    for (int i = 0; i < 1000; ++i) {
        const QString file = folder_ + QStringLiteral("/%1-%2").arg(process).arg(i) + textEnding;
        auto lock = lockOf(file);
        if (QFile::exists(file) || !lock->tryLock())
            continue;
        file_ = file;
        lock_ = std::move(lock);
        return true;
    }
    return false;
}

void Autosave::keep() {
    quiet_.stop();
    longest_.stop();
    QString fault = claim() ? QString() : tr("there is no place for them");
    if (fault.isEmpty()) {
        const QJsonObject about{{QStringLiteral("scene"), document_.path()}};
        fault = write(with(file_, aboutEnding), QJsonDocument(about).toJson());
    }
    if (fault.isEmpty())
        fault = write(file_, QByteArray::fromStdString(document_.text()));
    if (fault.isEmpty())
        hasFailed_ = false;
    else if (!std::exchange(hasFailed_, true))
        Q_EMIT failed(tr("Unsaved changes cannot be kept in %1: %2.").arg(folder_, fault));
}

void Autosave::forget() {
    quiet_.stop();
    longest_.stop();
    if (!lock_)
        return;
    QFile::remove(file_);
    QFile::remove(with(file_, aboutEnding));
    lock_->unlock(); // last: with it goes the claim
    lock_.reset();
    file_.clear();
}

QString Autosave::recover(const LeftBehind& left) {
    QFile file(left.file);
    if (!file.open(QIODevice::ReadOnly))
        return tr("Cannot read %1: %2.").arg(left.file, file.errorString());
    const QByteArray text = file.readAll();
    // Without its file (it was moved, or never was) the text is a scene that was never saved.
    if (left.scene.isEmpty() || !document_.open(left.scene).isEmpty())
        document_.reset();
    forget();
    file_ = left.file;
    lock_ = left.lock;
    document_.setText(text.toStdString(), tr("Recover"));
    documentChanged(); // it may be what the file has
    return {};
}

QList<LeftBehind> leftBehind(const QString& folder) {
    QList<LeftBehind> result;
    const auto files =
        QDir(folder).entryInfoList({QLatin1Char('*') + textEnding}, QDir::Files, QDir::Time);
    for (const QFileInfo& info : files) {
        auto lock = lockOf(info.filePath());
        if (!lock->tryLock() || !QFile::exists(info.filePath()))
            continue; // its process lives, or has just recovered it
        QFile about(with(info.filePath(), aboutEnding));
        QString scene;
        if (about.open(QIODevice::ReadOnly))
            scene = QJsonDocument::fromJson(about.readAll())[QStringLiteral("scene")].toString();
        result.push_back({info.filePath(), scene, info.lastModified(), std::move(lock)});
    }
    return result;
}

void discard(const LeftBehind& left) {
    QFile::remove(left.file);
    QFile::remove(with(left.file, aboutEnding));
    left.lock->unlock();
}

bool offerRecovery(QWidget* over, Autosave& autosave, const QString& folder, const QString& scene) {
    for (const LeftBehind& left : leftBehind(folder)) {
        if (!scene.isEmpty() &&
            QFileInfo(left.scene).canonicalFilePath() != QFileInfo(scene).canonicalFilePath())
            continue;
        const auto answer = ask(over, left);
        if (answer == QMessageBox::Discard)
            discard(left);
        if (answer != QMessageBox::Yes)
            continue;
        const QString fault = autosave.recover(left);
        if (fault.isEmpty())
            return true;
        plain::Message::tell(QMessageBox::Warning, over, Autosave::tr("Recover"), fault);
    }
    return false;
}

} // namespace views

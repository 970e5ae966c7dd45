#include "start/samples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace views {

QList<Sample> samplesOf(const QString& manifest) {
    QFile file(manifest);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonArray listed = QJsonDocument::fromJson(file.readAll()).object()["samples"].toArray();
    const QDir folder = QFileInfo(manifest).absoluteDir();
    QList<Sample> samples;
    for (const auto& value : listed) {
        const QJsonObject one = value.toObject();
        const Sample sample{folder.filePath(one["file"].toString()), one["title"].toString(),
                            one["about"].toString(), one["group"].toString(),
                            one["time"].toDouble()};
        if (!sample.title.isEmpty() && QFileInfo(sample.path).isFile())
            samples.push_back(sample);
    }
    return samples;
}

QString manifestOfProgram() {
    const QDir program(QCoreApplication::applicationDirPath());
    for (const char* place : {"asgard.medium.json", "../share/ensemble/media/asgard.medium.json"})
        if (const QString path = program.filePath(QString::fromLatin1(place));
            QFileInfo(path).isFile())
            return path;
    return {};
}

} // namespace views

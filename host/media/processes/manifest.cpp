#include "processes/manifest.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <algorithm>

namespace media {

namespace {

QStringList strings(const QJsonValue& value) {
    QStringList result;
    for (const auto& item : value.toArray())
        if (item.isString())
            result << item.toString();
    return result;
}

QString wrongMember(const QJsonObject& object) {
    for (const char* member : {"name", "class", "storage"})
        if (object[QLatin1String(member)].toString().isEmpty())
            return QStringLiteral("\"%1\" must be a string that is not empty").arg(member);
    if (strings(object["command"]).isEmpty() ||
        strings(object["command"]).size() != object["command"].toArray().size())
        return QStringLiteral("\"command\" must be a list of strings: the program, its arguments");
    const QJsonArray protocol = object["protocol"].toArray();
    if (protocol.size() != 2 || protocol[0].toInt(-1) < 1 ||
        protocol[1].toInt(-1) < protocol[0].toInt(-1))
        return QStringLiteral("\"protocol\" must be [lowest version, highest version]");
    return {};
}

// Of what may be left out.
QString wrongOption(const QJsonObject& object) {
    for (const char* member : {"title", "newText", "newEditor"})
        if (const QJsonValue value = object[QLatin1String(member)];
            !value.isUndefined() && !value.isString())
            return QStringLiteral("\"%1\" must be a string").arg(member);
    const QJsonValue size = object["size"];
    const auto length = [&](int i) { return size.toArray()[i].toDouble(0); };
    constexpr double longest = 20'000;
    if (!size.isUndefined() && (size.toArray().size() != 2 || length(0) < 1 || length(1) < 1 ||
                                std::max(length(0), length(1)) > longest))
        return QStringLiteral("\"size\" must be [width, height], in 1/96 inch");
    const QJsonValue files = object["files"];
    if (!files.isUndefined() && (!files["title"].isString() || strings(files["endings"]).isEmpty()))
        return QStringLiteral("\"files\" must have a \"title\" and a list of \"endings\"");
    return {};
}

// A path that leaves the folder is a fault, as it would read any file.
QString wrongSample(const QJsonValue& samples) {
    constexpr int most = 100;
    if (samples.isUndefined())
        return {};
    if (!samples.isArray() || samples.toArray().size() > most)
        return QStringLiteral("\"samples\" must be a list of at most %1").arg(most);
    for (const auto& each : samples.toArray()) {
        const QJsonValue sample = each;
        const QString file = QDir::cleanPath(sample["file"].toString());
        if (file.isEmpty() || file.startsWith('/') || file.startsWith("..") ||
            sample["title"].toString().isEmpty())
            return QStringLiteral(
                "each of \"samples\" must have a \"title\", and a \"file\" in the "
                "manifest's folder or below it");
        if (const QJsonValue group = sample["group"]; !group.isUndefined() && !group.isString())
            return QStringLiteral("the \"group\" of a sample must be a string");
    }
    return {};
}

void addFolders(QStringList& folders, const QString& list, const QString& below) {
    for (const QString& folder : list.split(':', Qt::SkipEmptyParts))
        folders << QDir::cleanPath(below.isEmpty() ? folder : folder + '/' + below);
}

} // namespace

std::optional<Manifest> readManifest(const QByteArray& json, QString& fault) {
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError) {
        fault = QStringLiteral("byte %1: %2").arg(error.offset).arg(error.errorString());
        return std::nullopt;
    }
    const QJsonObject object = document.object();
    for (const QString& wrong :
         {wrongMember(object), wrongOption(object), wrongSample(object["samples"])})
        if (!wrong.isEmpty()) {
            fault = wrong;
            return std::nullopt;
        }
    Manifest manifest;
    manifest.name = object["name"].toString();
    manifest.documentClass = object["class"].toString();
    manifest.storage = object["storage"].toString();
    manifest.command = strings(object["command"]);
    manifest.protocolMin = object["protocol"].toArray()[0].toInt();
    manifest.protocolMax = object["protocol"].toArray()[1].toInt();
    manifest.title = object["title"].toString(manifest.name);
    manifest.newText = object["newText"].toString();
    manifest.newEditor = object["newEditor"].toString();
    if (const QJsonArray size = object["size"].toArray(); size.size() == 2)
        manifest.size = {size[0].toDouble(), size[1].toDouble()};
    for (const auto& each : object["samples"].toArray()) {
        const QJsonValue sample = each;
        manifest.samples << Sample{
            sample["file"].toString(), sample["title"].toString(), sample["about"].toString(),
            sample["time"].isDouble() ? std::optional(sample["time"].toDouble()) : std::nullopt,
            sample["group"].toString()};
    }
    manifest.filesTitle = object["files"]["title"].toString();
    manifest.fileEndings = strings(object["files"]["endings"]);
    return manifest;
}

Registry Registry::read(const QStringList& folders) {
    Registry registry;
    for (const QString& folder : folders) {
        const QDir dir(folder);
        for (const QString& name : dir.entryList({"*.medium.json"}, QDir::Files, QDir::Name))
            registry.readFile(dir.filePath(name));
    }
    return registry;
}

void Registry::readFile(const QString& path) {
    constexpr qint64 mostBytes = 1 << 20;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > mostBytes) {
        faults_ << QStringLiteral("%1: cannot be read").arg(path);
        return;
    }
    QString fault;
    std::optional<Manifest> manifest = readManifest(file.readAll(), fault);
    if (!manifest) {
        faults_ << QStringLiteral("%1: %2").arg(path, fault);
        return;
    }
    manifest->file = path;
    add(*manifest);
}

void Registry::add(const Manifest& manifest) {
    if (!forClass(manifest.documentClass))
        media_ << manifest;
}

const Manifest* Registry::forClass(const QString& documentClass) const {
    for (const Manifest& manifest : media_)
        if (manifest.documentClass == documentClass)
            return &manifest;
    return nullptr;
}

QStringList registryFolders(const QString& executableFolder) {
    const QString below = QStringLiteral("ensemble/media");
    QStringList folders;
    addFolders(folders, qEnvironmentVariable("ENSEMBLE_MEDIA"), {});
    addFolders(folders, qEnvironmentVariable("XDG_DATA_HOME", QDir::homePath() + "/.local/share"),
               below);
    addFolders(folders, qEnvironmentVariable("XDG_DATA_DIRS", "/usr/local/share:/usr/share"),
               below);
    folders << executableFolder << executableFolder + "/media"
            << QDir::cleanPath(executableFolder + "/../share/" + below);
    return folders;
}

QString fileOf(const Manifest& manifest, const Sample& sample) {
    return QFileInfo(manifest.file).absoluteDir().filePath(sample.file);
}

QString programOf(const Manifest& manifest, const QString& executableFolder) {
    const QString& program = manifest.command.first();
    if (QDir::isAbsolutePath(program))
        return QFileInfo(program).isExecutable() ? program : QString();
    for (const QString& folder : {QFileInfo(manifest.file).absolutePath(), executableFolder}) {
        const QFileInfo beside(QDir(folder).filePath(program));
        if (beside.isFile() && beside.isExecutable())
            return beside.absoluteFilePath();
    }
    return program.contains('/') ? QString() : QStandardPaths::findExecutable(program);
}

} // namespace media

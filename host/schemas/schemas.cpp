#include "schemas/schemas.h"

#include "files/read.h"
#include "schemas/builtin_schemas.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace schemas {

namespace {

// Every class inherits these: the looks of TEXT, PARAGRAPH, LIST, ...
const QString baseFile = QStringLiteral("COMMON.base.presentation");
const QString presentationSuffix = QStringLiteral(".presentation");
const QString structureSuffix = QStringLiteral(".structure");
const QString defaultName = QStringLiteral("default");

// The files that others inherit from come first.
int rankOf(const QString& name) {
    const QString stem = name.chopped(presentationSuffix.size());
    const bool isDefault =
        !stem.contains(QLatin1Char('.')) || stem.section(QLatin1Char('.'), 1) == defaultName;
    return name == baseFile ? 0 : isDefault ? 1 : 2;
}

std::string classOf(const QString& file) {
    return file.section(QLatin1Char('.'), 0, 0).toStdString();
}

} // namespace

Schemas Schemas::builtIn() { return load({}); }

QStringList Schemas::standardFolders() {
    QStringList folders;
    for (const QString& place :
         QStandardPaths::standardLocations(QStandardPaths::GenericDataLocation))
        folders << place + QStringLiteral("/ensemble/schemas");
    // The files installed with this program, under whatever prefix.
    if (QCoreApplication::instance())
        folders << QDir::cleanPath(QCoreApplication::applicationDirPath() +
                                   QStringLiteral("/../share/ensemble/schemas"));
    return folders;
}

Schemas Schemas::load(const QStringList& folders) {
    Schemas schemas;
    std::map<QString, std::string> builtIns;
    for (const BuiltInSchema& file : builtInSchemas())
        builtIns[QString::fromUtf8(file.name)] = file.text;
    // Name of a schema file -> the first file of that name.
    std::map<QString, QString> paths;
    for (const QString& folder : folders)
        for (const QString& name : QDir(folder).entryList(
                 {QStringLiteral("*.structure"), QStringLiteral("*.presentation")}, QDir::Files))
            paths.try_emplace(name, folder + QLatin1Char('/') + name);
    std::map<std::pair<int, QString>, QString> names;
    const auto add = [&](const QString& name) { names[{rankOf(name), name}] = name; };
    for (const auto& [name, text] : builtIns)
        add(name);
    for (const auto& [name, path] : paths)
        add(name);
    for (const auto& [rank, name] : names)
        schemas.addNamed(name, builtIns, paths);
    return schemas;
}

// The user's file of that name if anything can be read in it, else the built-in one.
void Schemas::addNamed(const QString& name, const std::map<QString, std::string>& builtIns,
                       const std::map<QString, QString>& paths) {
    const auto path = paths.find(name);
    if (path != paths.end()) {
        const files::ReadFile file = files::readFile(
            files::FileSystem::real(), QFile::encodeName(path->second).toStdString(), longestFile);
        if (!file.read) {
            sgml::Fault fault;
            fault.severity = sgml::Severity::warning;
            fault.position = {1, 1};
            fault.message = "This schema cannot be read: " + file.reason + ".";
            faults_.push_back({path->second, fault});
        } else if (addFile(path->second, name, file.bytes)) {
            return;
        }
    }
    const auto builtIn = builtIns.find(name);
    if (builtIn != builtIns.end())
        (void)addFile(QStringLiteral(":/") + name, name, builtIn->second);
}

// False: nothing could be read in it, and it is not used.
bool Schemas::addFile(const QString& path, const QString& name, const std::string& text) {
    std::vector<sgml::Fault> faults;
    bool used = false;
    if (name.endsWith(structureSuffix)) {
        StructureSchema schema = StructureSchema::parse(text, faults);
        used = schema.saysSomething();
        if (used)
            structures_[name.chopped(structureSuffix.size()).toStdString()] = std::move(schema);
    } else {
        const File file{.name = name, .path = path, .text = text};
        used = addPresentation(file, faults);
        if (used)
            files_[name] = file;
    }
    reportFaults(path, std::move(faults));
    return used;
}

void Schemas::reportFaults(const QString& path, std::vector<sgml::Fault> faults) {
    for (sgml::Fault& fault : faults) {
        fault.severity = sgml::Severity::warning;
        faults_.push_back({path, std::move(fault)});
    }
}

// False: nothing could be read in it that it does not inherit, and it was not there before.
bool Schemas::addPresentation(const File& file, std::vector<sgml::Fault>& faults) {
    const QString stem = file.name.chopped(presentationSuffix.size());
    const std::string className = classOf(stem);
    const QString own = stem.section(QLatin1Char('.'), 1);
    const bool isBase = file.name == baseFile, isKnown = files_.contains(file.name);
    const bool isDefault = own.isEmpty() || own == defaultName;
    const Presentation* base = isBase ? nullptr : &plain_;
    if (const auto known = presentations_.find(className);
        known != presentations_.end() && !isDefault)
        if (const auto ofClass = known->second.find(defaultName); ofClass != known->second.end())
            base = &ofClass->second;
    Presentation presentation = Presentation::parse(file.text, faults, base);
    if (!presentation.saysSomething() && !isKnown)
        return false;
    if (isBase)
        plain_ = std::move(presentation);
    else
        presentations_[className][isDefault ? defaultName : own] = std::move(presentation);
    return true;
}

// --- a file that is being edited ---------------------------------------------------------------

const Schemas::File& Schemas::fileOf(std::string_view className,
                                     const QString& presentation) const {
    const QString prefix = QString::fromUtf8(className) + QLatin1Char('.');
    const QStringList names = presentations(className);
    const QString asked = names.contains(presentation) ? presentation : names.first();
    for (const QString& name :
         {prefix + asked + presentationSuffix, prefix.chopped(1) + presentationSuffix})
        if (const auto found = files_.find(name); found != files_.end())
            return found->second;
    return files_.at(baseFile);
}

std::optional<Schemas::File> Schemas::suppliedFile(const QString& name) {
    for (const QString& folder : standardFolders().mid(1)) {
        const QString path = folder + QLatin1Char('/') + name;
        files::ReadFile file = files::readFile(files::FileSystem::real(),
                                               QFile::encodeName(path).toStdString(), longestFile);
        if (file.read)
            return File{name, path, std::move(file.bytes)};
    }
    for (const BuiltInSchema& file : builtInSchemas())
        if (name == QString::fromUtf8(file.name))
            return File{name, QStringLiteral(":/") + name, std::string(file.text)};
    return std::nullopt;
}

void Schemas::setText(const QString& name, const QString& path, std::string text) {
    const auto edited = files_.find(name);
    if (edited == files_.end())
        return;
    const auto forgetFaults = [this](const QString& of) {
        std::erase_if(faults_, [&](const FileFault& fault) { return fault.file == of; });
    };
    forgetFaults(std::exchange(edited->second.path, path));
    edited->second.text = std::move(text);
    const auto follows = [&](const QString& other) {
        return other == name || name == baseFile ||
               (rankOf(name) == 1 && rankOf(other) > 1 && classOf(other) == classOf(name));
    };
    for (int rank = rankOf(name); rank <= 2; ++rank)
        for (const auto& [other, file] : files_) {
            if (rankOf(other) != rank || !follows(other))
                continue;
            forgetFaults(file.path);
            std::vector<sgml::Fault> faults;
            (void)addPresentation(file, faults);
            reportFaults(file.path, std::move(faults));
        }
}

bool Schemas::isText(std::string_view className) const {
    return presentations_.contains(className);
}

QStringList Schemas::presentations(std::string_view className) const {
    QStringList names;
    const auto found = presentations_.find(className);
    if (found == presentations_.end())
        return {defaultName};
    for (const auto& [name, presentation] : found->second)
        if (name == defaultName)
            names.prepend(name);
        else
            names.append(name);
    return names;
}

const Presentation& Schemas::presentation(std::string_view className, const QString& name) const {
    const auto found = presentations_.find(className);
    if (found == presentations_.end())
        return plain_;
    auto own = found->second.find(name);
    if (own == found->second.end())
        own = found->second.find(defaultName);
    return own == found->second.end() ? found->second.begin()->second : own->second;
}

const StructureSchema* Schemas::structure(std::string_view className) const {
    const auto found = structures_.find(className);
    return found == structures_.end() ? nullptr : &found->second;
}

} // namespace schemas

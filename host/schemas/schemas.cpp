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

// What every class inherits: the looks of TEXT, PARAGRAPH, LIST, ...
const QString baseFile = QStringLiteral("COMMON.base.presentation");
const QString presentationSuffix = QStringLiteral(".presentation");
const QString structureSuffix = QStringLiteral(".structure");
const QString defaultName = QStringLiteral("default");

// LIMIT: a longer schema file is not read.
constexpr std::size_t longestFile = 1 << 20;

} // namespace

Schemas Schemas::builtIn() { return load({}); }

QStringList Schemas::standardFolders() {
    QStringList folders;
    for (const QString& place :
         QStandardPaths::standardLocations(QStandardPaths::GenericDataLocation))
        folders << place + QStringLiteral("/ensemble/schemas");
    // What is installed with this program, under whatever prefix.
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
    // What others inherit from comes first.
    std::map<std::pair<int, QString>, QString> names;
    const auto add = [&](const QString& name) {
        const QString stem = name.chopped(presentationSuffix.size());
        const bool isDefault =
            !stem.contains(QLatin1Char('.')) || stem.section(QLatin1Char('.'), 1) == defaultName;
        names[{name == baseFile ? 0 : isDefault ? 1 : 2, name}] = name;
    };
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
        const QString stem = name.chopped(presentationSuffix.size());
        const std::string className = stem.section(QLatin1Char('.'), 0, 0).toStdString();
        const QString own = stem.section(QLatin1Char('.'), 1);
        const bool isBase = name == baseFile;
        const Presentation* base = isBase ? nullptr : &plain_;
        if (const auto known = presentations_.find(className); known != presentations_.end())
            if (const auto ofClass = known->second.find(defaultName);
                ofClass != known->second.end())
                base = &ofClass->second;
        Presentation presentation = Presentation::parse(text, faults, base);
        used = presentation.saysSomething();
        if (used && isBase)
            plain_ = std::move(presentation);
        else if (used)
            presentations_[className][own.isEmpty() ? defaultName : own] = std::move(presentation);
    }
    for (sgml::Fault& fault : faults) {
        fault.severity = sgml::Severity::warning;
        faults_.push_back({path, std::move(fault)});
    }
    return used;
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

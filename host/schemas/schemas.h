// The schemas that there are: files of users, else the program's own.
//
// Looked for in $XDG_DATA_HOME/ensemble/schemas, $XDG_DATA_DIRS/ensemble/schemas, then the folder
// given, then those compiled in. The first file of a name counts. Its faulty parts are left out and
// reported by line; the built-in file replaces one in which nothing can be read.
//
// A presentation of a class inherits from the class's default one, that one from COMMON.base.
#pragma once

#include "schemas/presentation.h"
#include "schemas/structure.h"

#include <QString>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace schemas {

class Schemas {
public:
    [[nodiscard]] static Schemas builtIn();
    // Those of the folders, in order, before the built-in ones.
    [[nodiscard]] static Schemas load(const QStringList& folders);
    [[nodiscard]] static QStringList standardFolders();

    // Has the class a presentation, so that it is text and no medium?
    [[nodiscard]] bool isText(std::string_view className) const;
    // Names, "default" first.
    [[nodiscard]] QStringList presentations(std::string_view className) const;
    // Never fails: an unknown name gives the class's default, an unknown class the plain one.
    [[nodiscard]] const Presentation& presentation(std::string_view className,
                                                   const QString& name = {}) const;
    [[nodiscard]] const StructureSchema* structure(std::string_view className) const;

    // A file of a presentation, as it counts: "REPORT.default.presentation".
    struct File {
        QString name;
        QString path; // ":/NAME": compiled in
        std::string text;
    };
    // The one that gives a class's presentation of that name.
    [[nodiscard]] const File& fileOf(std::string_view className, const QString& presentation) const;
    // The one that would count without the user's own of that name; nothing: there is none.
    [[nodiscard]] static std::optional<File> suppliedFile(const QString& name);
    // Another text counts in the place of a presentation's file from now on, and what inherits from
    // it follows. Presentations stay where they are: a reference to one is one to the new one.
    void setText(const QString& name, const QString& path, std::string text);
    // LIMIT: a longer file is not read.
    static constexpr std::size_t longestFile = 1 << 20;

    struct FileFault {
        QString file;
        sgml::Fault fault;
    };
    [[nodiscard]] const std::vector<FileFault>& faults() const { return faults_; } // warnings

private:
    void addNamed(const QString& name, const std::map<QString, std::string>& builtIns,
                  const std::map<QString, QString>& paths);
    [[nodiscard]] bool addFile(const QString& path, const QString& name, const std::string& text);
    [[nodiscard]] bool addPresentation(const File& file, std::vector<sgml::Fault>& faults);
    void reportFaults(const QString& path, std::vector<sgml::Fault> faults);

    std::map<std::string, StructureSchema, std::less<>> structures_;
    // Class, then name.
    std::map<std::string, std::map<QString, Presentation>, std::less<>> presentations_;
    Presentation plain_;
    std::map<QString, File> files_; // of presentations, by name
    std::vector<FileFault> faults_;
};

} // namespace schemas

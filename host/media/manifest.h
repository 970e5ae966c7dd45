// Which media are installed, and which of them serves a document class?
// A medium is a file NAME.medium.json and a program that speaks the medium protocol; the host knows
// no other way to name one. Folders are searched in order and the first manifest of a class wins. A
// faulty manifest is a sentence in faults(), never an exception: the other media go on.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <optional>

namespace media {

struct Manifest {
    QString name;
    QString documentClass; // the class of the subdocuments that it serves
    QString storage;       // the element that holds their text
    QStringList command;   // program and arguments; a relative program is resolved by programOf()
    int protocolMin = 1;
    int protocolMax = 1;
    QString newText; // what a new subdocument holds
    QString file;    // where the manifest was read
};

class Registry {
public:
    [[nodiscard]] static Registry read(const QStringList& folders);

    [[nodiscard]] const Manifest* forClass(const QString& documentClass) const;
    [[nodiscard]] const QList<Manifest>& media() const { return media_; }
    [[nodiscard]] const QStringList& faults() const { return faults_; } // "file: text"
    void add(const Manifest& manifest);

private:
    void readFile(const QString& path);

    QList<Manifest> media_;
    QStringList faults_;
};

// $ENSEMBLE_MEDIA, $XDG_DATA_HOME, $XDG_DATA_DIRS, then beside the executable.
[[nodiscard]] QStringList registryFolders(const QString& executableFolder);

// The manifest in `json`, or what is wrong with it in `fault`.
[[nodiscard]] std::optional<Manifest> readManifest(const QByteArray& json, QString& fault);

// The program as a path: as it stands when absolute, else beside the manifest, beside the
// executable, then in PATH; empty when there is none.
[[nodiscard]] QString programOf(const Manifest& manifest, const QString& executableFolder);

} // namespace media

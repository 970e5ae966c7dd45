// Which media are installed, and which of them serves a document class?
// A medium is a file NAME.medium.json and a program that speaks the medium protocol; the host knows
// no other way to name one. Folders are searched in order and the first manifest of a class wins. A
// faulty manifest is a sentence in faults(), never an exception: the other media go on.
#pragma once

#include <QList>
#include <QSizeF>
#include <QString>
#include <QStringList>
#include <optional>

namespace media {

// A text that one may begin with.
struct Sample {
    QString file;                 // in the manifest's folder or below it
    QString title;                // "Pendulum"
    QString about;                // one line
    std::optional<double> time{}; // of its picture, in s
    QString group{};              // "Vibrations"; "": none
};

struct Manifest {
    QString name;
    QString documentClass; // the class of the subdocuments that it serves
    QString storage;       // the element that holds their text
    QStringList command;   // program and arguments; a relative program is resolved by programOf()
    int protocolMin = 1;
    int protocolMax = 1;
    QString file; // where the manifest was read

    // New subdocuments.
    QString title;           // what a user calls one: "Animation"; else the name
    QString newText;         // what an empty one holds
    QString newEditor;       // the entry of the menu in which an empty one is built; "": none
    QSizeF size{480, 360};   // that one is shown in at first, in 1/96 inch
    QList<Sample> samples;   // to choose from
    QString filesTitle;      // what files with such texts are called: "Scenes"
    QStringList fileEndings; // their endings without a dot; none: it has no files of its own
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

// The file of a sample as a path.
[[nodiscard]] QString fileOf(const Manifest& manifest, const Sample& sample);

// The program as a path: as it stands when absolute, else beside the manifest, beside the
// executable, then in PATH; empty when there is none.
[[nodiscard]] QString programOf(const Manifest& manifest, const QString& executableFolder);

} // namespace media

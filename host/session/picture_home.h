// The home of the pictures of a document that came in by paste, drop or a dialog: the folder
// `pictures` beside the document. A document that has no file yet keeps them in a folder of the
// user's, and they are beside it when it is saved.
//
// A picture's name there ends in a part of a checksum of its bytes: the same picture twice is one
// file, and a name never stands for two pictures, so nothing is overwritten, and a picture that
// undo takes back can come again. The document names it relative to its folder and moves with it.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QStringList>

#include <string>
#include <vector>

#include <sys/stat.h>

namespace session {

class PictureHome {
public:
    // Of the document's file; "": it has none, and its pictures are in the folder `unsaved`.
    explicit PictureHome(const QString& fileName, const QString& unsaved = usualFolder());
    [[nodiscard]] static QString usualFolder();

    // The folder that the names of its pictures are relative to.
    [[nodiscard]] const QString& folder() const { return folder_; }

    struct Kept {
        std::string source{}; // as IMAGE's FILE names it
        QString fault{};      // a sentence, when it is not kept
    };
    // `name`: of the file that the picture is from, "" for one of the clipboard. Bytes of a format
    // that documents do not show are refused.
    [[nodiscard]] Kept keep(const QByteArray& bytes, const QString& name) const;
    // The same of a file: a regular one of bounded size.
    [[nodiscard]] Kept keepFile(const QString& path) const;

    // Copies those pictures of the document that are missing in its folder from the one that it
    // came from; a sentence for each that could not be copied.
    [[nodiscard]] QStringList bring(const std::vector<std::string>& sources,
                                    const QString& from) const;

private:
    QString folder_;
};

// The bytes of a regular file of bounded size; else a sentence says why not.
[[nodiscard]] QByteArray pictureBytes(const QString& path, QString& fault);
// Formats that are pixels and nothing else: a drawing, such as SVG, may name other files.
[[nodiscard]] bool isPixels(const QByteArray& format);
// Opens a file for reading if it is a regular one; others are not waited for.
[[nodiscard]] bool openRegular(const QString& path, QFile& file, struct stat& status);

} // namespace session

// A presentation's file while it is edited: what was read, what it says now, where it is saved.
//
// The user's own file is changed. One of the program or of the system is not: saving writes a copy
// of the same name into the user's folder of schemas, which counts before all others
// (schemas::Schemas); a file beside a document is no schema, since a document of a stranger must
// not bring its own looks.
#pragma once

#include "files/save.h"
#include "schemas/schemas.h"

namespace source {

// The user's own file of that name, and whether it is there.
[[nodiscard]] QString ownPresentation(const QString& name);
[[nodiscard]] bool hasOwnPresentation(const QString& name);
// Gives it another name, NAME~, in the place of one from before. "": it is done; else the reason
// why not.
[[nodiscard]] QString putOwnPresentationAside(const QString& name);

class PresentationDraft {
public:
    // `own`: the user's folder of schemas.
    PresentationDraft(const schemas::Schemas::File& file, const QString& own);

    [[nodiscard]] const QString& name() const { return name_; } // "REPORT.default.presentation"
    [[nodiscard]] QString path() const;                         // where it is saved
    [[nodiscard]] bool isCopy() const { return isCopy_; }       // nothing is saved there yet
    // As it was read or saved.
    [[nodiscard]] const std::string& savedText() const { return saved_; }
    [[nodiscard]] files::SaveResult save(const std::string& text, files::SaveOptions options);

private:
    QString name_;
    files::KnownFile file_;
    std::string saved_;
    bool isCopy_ = true;
};

} // namespace source

// A document that is open, once, however many windows show it.
//
// The document holds the text; each subdocument of an installed medium has one LiveSubdocument. An
// edit of a subdocument's text, by whomever, reaches its medium; an edit that a medium asks for
// becomes a step of the document's one undo stack.
#pragma once

#include "document/document.h"
#include "document/faults.h"
#include "document/uses.h"
#include "media/live_media.h"
#include "schemas/schemas.h"
#include "session/file_follower.h"
#include "session/formula_faults.h"
#include "session/images.h"
#include "session/unsaved.h"
#include "session/values.h"
#include "text/edit.h"
#include "text/places.h"

#include <QObject>
#include <QSizeF>
#include <map>
#include <memory>
#include <set>

namespace session {

struct ListedFault {
    text::Position position; // line 0: no place is known
    bool isError = false;
    QString message;
    document::SubdocumentId subdocument = document::noSubdocument;
    QString file{}; // of a schema, when it is not in the document
    bool operator==(const ListedFault&) const = default;
};

class Presented;

class OpenDocument : public QObject {
    Q_OBJECT

public:
    OpenDocument(std::unique_ptr<document::Document> document, const schemas::Schemas& schemas,
                 media::LiveMedia& media);
    ~OpenDocument() override;

    [[nodiscard]] document::Document& document() { return *document_; }
    [[nodiscard]] const document::Document& document() const { return *document_; }
    [[nodiscard]] const schemas::Schemas& schemas() const { return schemas_; }
    [[nodiscard]] media::LiveMedia& media() { return media_; }
    [[nodiscard]] Images& images() { return images_; }
    // The numbers of subdocuments that stand in its texts and formulas.
    [[nodiscard]] Values& values() { return *values_; }

    // Presentations say something else now (Schemas::setText): its pages follow. LIMIT: what is a
    // picture, a formula or a reference, for commands and faults, is as it was when it was opened.
    void presentAnew();
    // Its pages by that presentation ("": the class's own), the same for all who ask while one of
    // them keeps it.
    [[nodiscard]] std::shared_ptr<Presented> presented(const QString& presentation);

    // Nothing for one whose medium is not installed, or that is text.
    [[nodiscard]] media::LiveSubdocument* live(document::SubdocumentId id) const;
    // Why a subdocument has no medium, as a sentence.
    [[nodiscard]] QString whyNotLive(document::SubdocumentId id) const;
    // That its text is empty; "": it is not.
    [[nodiscard]] QString emptyNotice(document::SubdocumentId id) const;

    // How large it is shown, in 1/96 inch: by its WIDTH and HEIGHT, else as its medium would like.
    [[nodiscard]] QSizeF sizeOf(document::SubdocumentId id) const;
    // The media in whose windows something was typed that is not in the document yet.
    [[nodiscard]] QStringList drafts() const;
    // Whether all of these can be made changes of the document, and does it; draftsChanged() tells.
    [[nodiscard]] bool takesDrafts() const;
    void takeDrafts();

    // All that is known to be wrong: of the format, of what its schemas do not allow, references to
    // nothing, formulas and pictures that cannot be read, parameters that sliders do not find,
    // values that are not known, of subdocuments as their media say, and why media failed; in order
    // of place. Before these, what is wrong in the files of its schemas.
    [[nodiscard]] std::vector<ListedFault> faults();
    // Faults that a subdocument's medium finds, and why it failed, placed in the file.
    [[nodiscard]] const std::vector<ListedFault>& faultsOf(document::SubdocumentId id) const;
    // Of values that stand in its texts and formulas and have no number.
    [[nodiscard]] std::vector<ListedFault> valueFaults() const;
    // Are there sliders for its parameters?
    [[nodiscard]] bool hasSliders(document::SubdocumentId id) const { return driven_.contains(id); }

    // Unsaved work is kept in that folder's journal from now on.
    Unsaved& keepUnsavedIn(const std::string& folder);
    // Changes of its file by other programs are followed from now on, where they are not yet.
    FileFollower& followFile();
    [[nodiscard]] Unsaved* unsaved() const { return unsaved_.get(); } // null: it is not kept

Q_SIGNALS:
    void structureChanged(); // something else than the text of subdocuments
    void resized();          // a medium would like another size
    void presentedAnew();    // presentations say something else
    void faultsChanged();
    void draftsChanged(); // what was typed in windows of media, or whether anything was
    void message(const QString& text);
    void figureSaid(document::SubdocumentId figure, const QString& text);

private:
    void readSubdocuments();
    void connectLive(document::SubdocumentId id, media::LiveSubdocument& live);
    [[nodiscard]] std::vector<sgml::Fault> ofDocument();
    [[nodiscard]] std::vector<sgml::Fault> ofImages();
    [[nodiscard]] std::vector<sgml::Fault> ofSliders() const;
    [[nodiscard]] std::vector<sgml::Fault> ofPresentations() const;
    [[nodiscard]] std::vector<sgml::Fault> ofFormulas();
    [[nodiscard]] std::vector<PlacedValue> placedValues();
    [[nodiscard]] std::vector<sgml::Fault> saidBy(document::SubdocumentId id) const;
    [[nodiscard]] std::vector<ListedFault> ofSchemas() const;
    void nameSubdocuments(); // for the windows of media
    void documentChanged();
    void textChanged(document::SubdocumentId id, const text::Edits& edits, const QString& label);
    [[nodiscard]] std::optional<QString> applyChange(document::SubdocumentId id,
                                                     const ipc::SubdocumentChanged& change);

    std::unique_ptr<document::Document> document_;
    const schemas::Schemas& schemas_;
    media::LiveMedia& media_;
    Images images_;
    document::Uses uses_;
    FormulaFaults formulas_;
    std::unique_ptr<document::Faults> judged_; // null: nobody asked yet
    std::map<document::SubdocumentId, std::unique_ptr<media::LiveSubdocument>> live_;
    std::set<document::SubdocumentId> driven_;                                   // by sliders
    mutable std::map<document::SubdocumentId, std::vector<ListedFault>> placed_; // what media said
    std::unique_ptr<Values> values_;
    bool onlyText_ = false; // the change that is being announced
    std::unique_ptr<Unsaved> unsaved_;
    std::map<QString, std::weak_ptr<Presented>> presented_;
    std::unique_ptr<FileFollower> file_;
};

} // namespace session

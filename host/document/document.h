// A compound document: its bytes, its tree, its subdocuments, one undo stack for all views.
//
// The bytes are the truth. Every edit replaces ranges of them, whoever makes it (a view, a medium,
// undo), is one step on the stack, and is announced to all. Reading never fails: a broken file
// yields a document with faults. No widgets, no processes, nothing that waits.
#pragma once

#include "document/selection.h"
#include "document/subdocument.h"
#include "files/save.h"
#include "sgml/change.h"
#include "text/edit.h"
#include "text/places.h"

#include <QObject>
#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace document {

// The result of an edit.
enum class EditResult {
    applied,
    nothing, // it would change nothing
    stale,   // made for another revision; nothing was changed
    invalid, // ranges outside the text or not in order; nothing was changed
    unknown, // no such subdocument, or it has no text, or no brace closes its text
};

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(std::string bytes = {}, QObject* parent = nullptr);
    ~Document() override;

    // --- what it is
    [[nodiscard]] const sgml::Tree& tree() const { return tree_; }
    [[nodiscard]] const std::string& bytes() const { return tree_.bytes(); }
    [[nodiscard]] std::string className() const;
    [[nodiscard]] bool isBroken() const { return tree_.isBroken(); }
    // Of the format, in order of place. For violations of a schema: Faults.
    [[nodiscard]] const std::vector<sgml::Fault>& faults() const { return tree_.faults(); }

    // --- subdocuments, nested ones included, in document order
    [[nodiscard]] std::vector<SubdocumentId> subdocuments() const;
    [[nodiscard]] const Subdocument* subdocument(SubdocumentId id) const; // null: not there now
    [[nodiscard]] SubdocumentId subdocumentOf(sgml::NodeId documentElement) const;
    [[nodiscard]] SubdocumentId subdocumentNamed(const std::string& name) const;
    [[nodiscard]] std::string text(SubdocumentId id) const; // unescaped
    [[nodiscard]] bool isBlank(SubdocumentId id) const;     // it has a text, of blanks alone
    // The place in the file of a place in a subdocument's text, escapes counted.
    [[nodiscard]] text::Position filePosition(SubdocumentId id, text::Position inText) const;
    // The bytes of the file at many places, in any order: reads the text once. Those of a text that
    // is not there are where its element begins.
    [[nodiscard]] std::vector<std::size_t>
    fileOffsets(SubdocumentId id, const std::vector<text::Position>& inText) const;

    // --- edits
    [[nodiscard]] int revision() const { return revision_; } // of the whole; grows with each change
    // Ranges are bytes of the unescaped text. `base` is the subdocument's revision that they were
    // made for. `group`: EditNote::group.
    EditResult editText(SubdocumentId id, int base, const text::Edits& edits, const QString& label,
                        const QString& group = {});
    // Ranges are bytes of the file.
    EditResult edit(const text::Edits& edits, const EditNote& note);
    EditResult edit(const text::Edits& edits, const QString& label, const QString& group = {}) {
        return edit(edits, EditNote{.label = label, .group = group});
    }

    // --- undo: to the start gives the first bytes, redo to the end the last
    [[nodiscard]] bool canUndo() const { return undo_.done > 0; }
    [[nodiscard]] bool canRedo() const { return undo_.done < undo_.steps.size(); }
    [[nodiscard]] std::size_t steps() const { return undo_.done; } // that can be undone
    // That are kept for undo and redo: letters typed one behind the other are one.
    [[nodiscard]] std::size_t keptChanges() const;
    [[nodiscard]] QString lastGroup() const; // EditNote::group of the step that undo() takes back
    [[nodiscard]] QString undoLabel() const;
    [[nodiscard]] QString redoLabel() const;
    void undo();
    void redo();

    // --- its file
    [[nodiscard]] const QString& fileName() const { return fileName_; }
    [[nodiscard]] bool isModified() const { return undo_.done != undo_.clean || fileIsLost_; }
    // A broken document, and a file that another program changed, are replaced only when allowed.
    [[nodiscard]] files::SaveResult save(files::SaveOptions options = {});
    [[nodiscard]] files::SaveResult saveAs(const QString& fileName,
                                           files::SaveOptions options = {});
    // Was the file changed by another program since it was read or saved?
    [[nodiscard]] files::FileState fileState() const;
    [[nodiscard]] files::ReadFile readFile() const;
    // The version before the last save, where there is one.
    [[nodiscard]] bool hasBackup() const;
    [[nodiscard]] files::ReadFile readBackup() const;
    // Another program wrote `file`, which is the file as it is known from now on. The edits that
    // bring its text here, or the part of it that is wanted, are one step of undo: undone, they
    // leave the text from before, which is not saved then.
    void follow(const text::Edits& edits, const files::ReadFile& file, const QString& label);
    // There is no file any more, or none that can be read: then the text is not saved.
    void setFileLost(bool lost);
    // The file's text as it was read or saved last; nothing: it is not known.
    [[nodiscard]] const std::optional<std::string>& savedText() const { return saved_; }
    // The file as it was read or saved last.
    [[nodiscard]] const files::KnownFile& knownFile() const { return file_; }

    struct Loaded;
    [[nodiscard]] static Loaded load(const QString& fileName, files::FileSystem* files = nullptr);
    // A document with the text that a program had not saved when it ended. The program knew its
    // file as `file`; the file itself is as it was. The text is one change of the file's content;
    // without the file it is a document that was never saved.
    [[nodiscard]] static std::unique_ptr<Document> recover(const files::KnownFile& file,
                                                           std::string text);
    // The same of one that is open, with the file's content as it was read.
    void recoverText(const files::KnownFile& file, const std::string& text);

Q_SIGNALS:
    void changed(); // after an edit, an undo or a redo, however many changes that is
    // After each single change of the bytes, before all else is told: tree and subdocuments have
    // followed.
    // `back` undoes its edits. `number` names the change: an undo and a redo have the number of
    // the edit, or of the first of letters that were typed one behind the other.
    void edited(const sgml::Change& change, const text::Edits& back, std::uint64_t number);
    void textChanged(document::SubdocumentId id, const text::Edits& edits, int revision,
                     const QString& label); // unescaped edits; undo and redo too
    void subdocumentsChanged(); // some came or went, or elements or attributes changed somewhere
    void undoChanged();         // labels, canUndo, canRedo
    // After an undo or a redo of a step that has a selection, when all else is told.
    void selectionRestored(const document::Selection& selection);
    void modifiedChanged(bool modified);
    void fileNameChanged();

private:
    // One change of the bytes, and what it did to the subdocuments.
    struct Change {
        std::uint64_t number = 0;
        text::Edits forward, backward;
        SubdocumentId id = noSubdocument; // whose text it changes and nothing else
        text::Edits textForward, textBackward;
        std::map<std::size_t, SubdocumentId> lost, found; // by offset before and after
    };
    struct Step {
        EditNote note;
        std::vector<Change> changes;
    };
    struct Undo {
        std::vector<Step> steps;
        std::size_t done = 0;      // steps that are in force
        std::size_t clean = 0;     // those in force when saved; noStep: that state is gone
        bool isOpen = false;       // the last step may take more edits: no undo came after it
        std::uint64_t changes = 0; // numbers that were given
    };
    enum class Direction { forward, backward };

    EditResult perform(Change change, const EditNote& note);
    void play(Change& change, Direction direction, const QString& label);
    void push(Change change, const EditNote& note);
    // Makes `change`, which follows `last`, a part of it. False: that cannot be.
    [[nodiscard]] static bool extends(Change& last, const Change& change);
    [[nodiscard]] bool joinsLast(const EditNote& note) const;
    void announce(bool wasModified, std::optional<Selection> selection = {});
    // A subdocument before a change.
    struct Remembered {
        SubdocumentId id = noSubdocument;
        std::size_t at = 0;    // of its element
        text::Range spelled{}; // its text in the file
        std::string text{};    // if the change edits it
        bool isEdited = false;
    };
    [[nodiscard]] std::vector<Remembered> rememberSubdocuments(const text::Edits& edits) const;
    [[nodiscard]] std::string textBefore(const Remembered& was, const text::Edits& edits) const;
    // The subdocuments whose text may have changed.
    std::set<SubdocumentId> followStructure(const sgml::Change& told,
                                            const std::vector<Remembered>& before, Change& change,
                                            Direction direction);
    std::set<SubdocumentId> forgetSubdocuments(const sgml::Change& told);
    void readSubdocuments(sgml::NodeId top, std::map<std::size_t, SubdocumentId>& known);
    void describe(SubdocumentId id, sgml::NodeId element);
    void orderSubdocuments();
    // The innermost subdocuments that these nodes belong to.
    [[nodiscard]] std::set<SubdocumentId> ownersOf(const std::vector<sgml::NodeId>& nodes) const;
    int nextRevision(SubdocumentId id);
    [[nodiscard]] Subdocument described(sgml::NodeId element) const;

    static constexpr std::size_t noStep = static_cast<std::size_t>(-1);
    sgml::Tree tree_;
    std::map<SubdocumentId, Subdocument> subdocuments_;
    std::vector<SubdocumentId> order_;
    std::unordered_map<sgml::NodeId, SubdocumentId> byElement_;
    std::map<SubdocumentId, int> revisions_; // of those that are gone too
    SubdocumentId lastId_ = noSubdocument;
    int revision_ = 0;
    Undo undo_;
    QString fileName_;
    files::KnownFile file_;
    std::optional<std::string> saved_; // what is in it
    bool fileIsLost_ = false;
    files::FileSystem* files_ = &files::FileSystem::real();
};

struct Document::Loaded {
    std::unique_ptr<Document> document; // null when the file could not be read
    QString failure;                    // a sentence
};

} // namespace document

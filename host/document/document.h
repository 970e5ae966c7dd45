// A compound document: its bytes, its tree, its subdocuments, one undo stack for all views.
//
// The bytes are the truth. Every edit replaces ranges of them, whoever makes it (a view, a medium,
// undo), is one step on the stack, and is announced to all. Reading never fails: a broken file
// yields a document with faults. No widgets, no processes, nothing that waits.
#pragma once

#include "document/file.h"
#include "document/schemas.h"
#include "document/subdocument.h"
#include "sgml/edit.h"

#include <QObject>
#include <QString>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace document {

// What became of an edit that was asked for.
enum class EditResult {
    applied,
    nothing, // it would change nothing
    stale,   // made for another revision; nothing was changed
    invalid, // ranges outside the text or not in order; nothing was changed
    unknown, // no such subdocument, or it has no text
};

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(std::string bytes = {}, QObject *parent = nullptr);
    ~Document() override;

    // --- what it is
    [[nodiscard]] const sgml::Tree &tree() const { return tree_; }
    [[nodiscard]] const std::string &bytes() const { return tree_.bytes(); }
    [[nodiscard]] std::string className() const;
    [[nodiscard]] bool isBroken() const { return tree_.isBroken(); }
    // Of the format, in order of place. What a schema does not allow: structureFaults().
    [[nodiscard]] const std::vector<sgml::Fault> &faults() const { return tree_.faults(); }

    // --- subdocuments, nested ones included, in document order
    [[nodiscard]] std::vector<SubdocumentId> subdocuments() const;
    [[nodiscard]] const Subdocument *subdocument(SubdocumentId id) const; // null: not there now
    [[nodiscard]] SubdocumentId subdocumentOf(sgml::NodeId documentElement) const;
    [[nodiscard]] SubdocumentId subdocumentNamed(const std::string &name) const;
    [[nodiscard]] std::string text(SubdocumentId id) const; // unescaped
    // The place in the file of a place in a subdocument's text, escapes counted.
    [[nodiscard]] sgml::Position filePosition(SubdocumentId id, sgml::Position inText) const;

    // --- edits
    [[nodiscard]] int revision() const { return revision_; } // of the whole; grows with each change
    // Ranges are bytes of the unescaped text. `base` is the subdocument's revision that they were
    // made for. Edits with the same `group` that follow each other are one step of undo.
    EditResult editText(SubdocumentId id, int base, const sgml::Edits &edits, const QString &label,
                        const QString &group = {});
    // Ranges are bytes of the file. `within`: a content, when they come from sgml::contentEdits().
    EditResult edit(const sgml::Edits &edits, const QString &label, const QString &group = {},
                    sgml::NodeId within = sgml::noNode);

    // --- undo: to the start gives the first bytes, redo to the end the last
    [[nodiscard]] bool canUndo() const { return done_ > 0; }
    [[nodiscard]] bool canRedo() const { return done_ < steps_.size(); }
    [[nodiscard]] QString undoLabel() const;
    [[nodiscard]] QString redoLabel() const;
    void undo();
    void redo();

    // --- its file
    [[nodiscard]] const QString &fileName() const { return fileName_; }
    [[nodiscard]] bool isModified() const { return done_ != clean_; }
    // A broken document replaces the file that it was read from only when told that it may.
    enum class Overwrite { onlySound, evenBroken };
    [[nodiscard]] SaveResult save(Overwrite overwrite = Overwrite::onlySound);
    [[nodiscard]] SaveResult saveAs(const QString &fileName,
                                    Overwrite overwrite = Overwrite::onlySound);
    // Was the file changed by another program since it was read or saved?
    [[nodiscard]] FileState fileState() const;
    void setFileSystem(FileSystem *files); // for tests; not owned

    struct Loaded;
    [[nodiscard]] static Loaded load(const QString &fileName, FileSystem *files = nullptr);

Q_SIGNALS:
    void changed(); // after any change of the bytes
    void textChanged(document::SubdocumentId id, const sgml::Edits &edits, int revision,
                     const QString &label); // unescaped edits; undo and redo too
    void subdocumentsChanged();             // some came or went, or an attribute changed
    void undoChanged();                     // labels, canUndo, canRedo
    void modifiedChanged(bool modified);
    void fileNameChanged();

private:
    struct Step;
    struct Place;
    void replace(const sgml::Edits &edits, sgml::NodeId within, const QString &label, Step *step,
                 bool backwards);
    void announce(bool wasModified);
    void readSubdocuments(const std::map<std::size_t, SubdocumentId> &known);
    [[nodiscard]] Subdocument describe(sgml::NodeId element) const;
    void push(Step step, const QString &group);

    sgml::Tree tree_;
    std::map<SubdocumentId, Subdocument> subdocuments_;
    std::vector<SubdocumentId> order_;
    SubdocumentId lastId_ = noSubdocument;
    int revision_ = 0;
    std::vector<Step> steps_;
    std::size_t done_ = 0;
    std::size_t clean_ = 0; // npos: the saved state is no longer on the stack
    QString group_;
    QString fileName_;
    FileStamp stamp_;
    FileSystem *files_;
};

struct Document::Loaded {
    std::unique_ptr<Document> document; // null when the file could not be read
    QString failure;                    // a sentence
};

} // namespace document

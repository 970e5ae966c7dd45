// The text of a document in a text widget, in step both ways.
//
// The bytes come in slices, so that a long document keeps nobody waiting; until all are there,
// nobody types. From then on an edit of the document becomes one of the widget's text, where it
// stands: the caret, what is selected and what is seen stay. Typed text becomes an edit of
// the document, letter by letter, however broken the document is meanwhile: reading it never fails,
// and what cannot be understood is kept. The document has the one stack of undo.
//
// Work: an edit reads the lines that it begins in and what it changes; LIMIT: one of more than
// sliceBytes has the text from there on come in slices again.
#pragma once

#include "document/document.h"
#include "source/stretches.h"

#include <QPlainTextEdit>
#include <QTimer>

namespace source {

class DocumentMirror : public QObject {
    Q_OBJECT

public:
    // Both outlive it. The text is empty until start().
    DocumentMirror(document::Document& document, QPlainTextEdit& edit);

    void start();
    void stop(); // empty again
    // All of the document is in the text.
    [[nodiscard]] bool isComplete() const;
    // The text is being changed, or its caret, by the document.
    [[nodiscard]] bool isFollowing() const { return following_ > 0; }

    // The document's byte at a place of the text, and back: the end, where it is not there yet.
    [[nodiscard]] std::size_t offsetOf(int position) const;
    [[nodiscard]] int positionOf(std::size_t offset) const;
    // The byte that a line begins with.
    [[nodiscard]] std::size_t lineStart(int line) const; // from 0
    [[nodiscard]] document::Selection selection() const;
    // Scrolls to its caret.
    void select(const document::Selection& selection);

    static constexpr std::size_t sliceBytes = std::size_t{64} << 10;
    // Slices that came in, for tests.
    [[nodiscard]] int slices() const { return slices_; }

Q_SIGNALS:
    void completed(); // all is there, perhaps again
    void typed();     // an edit of the text became one of the document

private:
    // An edit of the text that the document does not have yet: letters.
    struct Typed {
        int from = 0, removed = 0, added = 0;
    };
    void fill();
    void emptyFrom(std::size_t offset);
    void follow(const sgml::Change& change, const text::Edits& back);
    void take();
    void enter(const text::Edit& edit, const Typed& letters, std::size_t caret);
    void check(text::Range came, const Typed& letters);
    void show(const Stretch& stretch);
    void replace(int from, const QString& letters, const QString& by);
    void change(const std::function<void()>& how);

    document::Document& document_;
    QPlainTextEdit& edit_;
    QTimer timer_;
    bool isOn_ = false;
    std::size_t filled_ = 0; // so many bytes are in the text, up to the start of a line
    std::optional<Typed> typed_;
    bool isOwn_ = false; // the change that comes next was typed here
    int following_ = 0;
    document::Selection selected_;              // before what is being typed
    std::optional<document::Selection> wanted_; // when all is there again
    int slices_ = 0;
};

} // namespace source

// The file of an open document, which another program may write at any time.
//
// A change is noticed within a moment, and made an edit of the document, stretch by stretch: what
// did not change stays as it is, the media of its figures too. Edits that are not saved are merged
// with it; where both touch, and where the file cannot be read well, somebody must choose.
#pragma once

#include "document/document.h"
#include "text/merge.h"

#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QTimer>

namespace session {

class FileFollower : public QObject {
    Q_OBJECT

public:
    // In ms: from a sign of a change to the look at the file; from that look to the next one, where
    // the file seems to be half written; how long it may seem so.
    struct Waits {
        int soon = 100, again = 400, patience = 3000;
    };
    explicit FileFollower(document::Document& document); // which outlives it
    FileFollower(document::Document& document, Waits waits);

    enum class State {
        quiet,    // the document knows the file as it is
        disputed, // both changed the same places
        damaged,  // the file can be read only in part, which it could be wholly before
        lost,     // there is no file that can be read
    };
    [[nodiscard]] State state() const { return state_; }
    [[nodiscard]] const QString& sentence() const { return sentence_; } // "" while quiet

    // The places at which the answers to a dispute or a damage differ, in order.
    struct Choice {
        int line = 0;         // of the text that Keep Mine leads to
        QString mine, theirs; // with some words around them, as one reads them
        bool operator==(const Choice&) const = default;
    };
    [[nodiscard]] const std::vector<Choice>& choices() const { return choices_; }
    // LIMIT: so many are listed.
    static constexpr std::size_t mostChoices = 20;

    void look();
    // The answers to what is disputed or damaged. If only one of both changed something, that
    // change is taken either way. The other's text can be had back by undo.
    void keepMine();
    void takeTheirs();
    [[nodiscard]] int looks() const { return looks_; } // for tests

Q_SIGNALS:
    void aboutToFollow(); // the document's text is going to be the file's
    void stateChanged();
    void told(const QString& sentence); // what was done without a question

private:
    void watch();
    void set(State state, const QString& sentence = {});
    void lose(const QString& sentence);
    void read();
    [[nodiscard]] bool isHalfWritten();
    void merge();
    void dispute();
    // The text that each answer leads to.
    [[nodiscard]] std::string keepingMine() const;
    [[nodiscard]] std::string takingTheirs() const;
    void follow(const text::Edits& edits);
    [[nodiscard]] QString name() const;

    document::Document& document_;
    Waits waits_;
    QFileSystemWatcher watcher_;
    QTimer timer_;
    State state_ = State::quiet;
    QString sentence_;
    std::vector<Choice> choices_;
    files::ReadFile theirs_;            // as it was read last
    std::optional<std::uint64_t> half_; // hash of what seems to be half written
    QElapsedTimer sinceHalf_;
    bool missed_ = false; // by the last look
    int looks_ = 0;
};

} // namespace session

#include "session/file_follower.h"

#include "text/difference.h"

#include <QFileInfo>

#include <algorithm>

namespace session {

namespace {

bool isBroken(const std::string& bytes) { return sgml::Tree::parse(bytes).isBroken(); }

} // namespace

FileFollower::FileFollower(document::Document& document) : FileFollower(document, Waits{}) {}

FileFollower::FileFollower(document::Document& document, Waits waits)
    : document_(document), waits_(waits) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &FileFollower::look);
    // One write makes several signs. A file that is written all the time is looked at, too.
    const auto soon = [this] {
        if (!timer_.isActive())
            timer_.start(waits_.soon);
    };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, soon);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, soon);
    connect(&document, &document::Document::fileNameChanged, this, [this, soon] {
        watch();
        soon();
    });
    connect(&document, &document::Document::modifiedChanged, this, soon);
    watch();
}

// The folder as well: most programs write another file and rename it. A link's file has a folder
// of its own.
void FileFollower::watch() {
    QStringList wanted;
    const QString named = document_.fileName();
    for (const QString& path : {named, QFileInfo(named).canonicalFilePath()}) {
        const QFileInfo file(path);
        if (path.isEmpty() || !QFileInfo::exists(file.absolutePath()))
            continue;
        wanted << file.absolutePath();
        if (file.exists())
            wanted << file.absoluteFilePath();
    }
    wanted.removeDuplicates();
    QStringList left = watcher_.files() + watcher_.directories();
    QStringList added;
    for (const QString& path : wanted)
        if (!left.removeOne(path))
            added << path;
    if (!left.isEmpty())
        watcher_.removePaths(left);
    if (!added.isEmpty())
        watcher_.addPaths(added);
}

QString FileFollower::name() const { return QFileInfo(document_.fileName()).fileName(); }

void FileFollower::set(State state, const QString& sentence) {
    if (state == State::quiet) {
        half_.reset();
        missed_ = false;
        document_.setFileLost(false);
    }
    if (state == state_ && sentence == sentence_)
        return;
    state_ = state;
    sentence_ = sentence;
    Q_EMIT stateChanged();
}

// A program that replaces a file may take it away for a moment.
void FileFollower::lose(const QString& sentence) {
    if (!std::exchange(missed_, true))
        return timer_.start(waits_.again);
    document_.setFileLost(true);
    set(State::lost, sentence);
}

void FileFollower::look() {
    ++looks_;
    watch();
    switch (document_.fileState()) {
    case files::FileState::noFile:
    case files::FileState::unchanged:
        return set(State::quiet);
    case files::FileState::removed:
        return lose(tr("%1 was removed by another program. Its text is still here: save it to "
                       "write the file again.")
                        .arg(name()));
    case files::FileState::changed:
        return read();
    }
}

void FileFollower::read() {
    theirs_ = document_.readFile();
    if (!theirs_.read)
        return lose(tr("%1 cannot be read any more: %2. Its text is still here: save it under "
                       "another name to keep it.")
                        .arg(name(), QString::fromStdString(theirs_.reason)));
    missed_ = false;
    if (isHalfWritten())
        return;
    if (half_)
        return set(State::damaged, tr("%1 was changed by another program, and only a part of it "
                                      "can be read now. The text here is the one from before.")
                                       .arg(name()));
    merge();
}

// What was sound and is not may be half of what another program writes: it is given some time.
bool FileFollower::isHalfWritten() {
    if (document_.isBroken() || !isBroken(theirs_.bytes)) {
        half_.reset();
        return false;
    }
    if (half_ != theirs_.stamp.hash) {
        half_ = theirs_.stamp.hash;
        sinceHalf_.start();
    }
    if (sinceHalf_.elapsed() >= waits_.patience)
        return false;
    timer_.start(waits_.again);
    return true;
}

void FileFollower::merge() {
    if (!document_.isModified()) {
        follow(text::editsBetween(document_.bytes(), theirs_.bytes));
        Q_EMIT told(tr("%1 was changed by another program; this is its text now").arg(name()));
        return;
    }
    if (!document_.savedText())
        return dispute({});
    const text::Merge both = text::merged(*document_.savedText(), document_.bytes(), theirs_.bytes);
    const bool breaks =
        !document_.isBroken() && isBroken(text::applied(document_.bytes(), both.edits));
    if (breaks || !both.conflicts.empty())
        return dispute(both);
    follow(both.edits);
    Q_EMIT told(document_.isModified()
                    ? tr("%1 was changed by another program: its changes are here, too, beside "
                         "yours, which are not saved yet")
                          .arg(name())
                    : tr("%1 was changed by another program; this is its text now").arg(name()));
}

void FileFollower::dispute(const text::Merge& merge) {
    const std::string merged = text::applied(document_.bytes(), merge.edits);
    const text::Places places(merged);
    QStringList lines;
    for (const text::Range& conflict : merge.conflicts)
        lines << QString::number(places.at(conflict.from).line);
    lines.removeDuplicates();
    constexpr qsizetype most = 5;
    if (lines.size() > most)
        lines = lines.mid(0, most) << tr("others");
    set(State::disputed,
        lines.isEmpty()
            ? tr("%1 was changed by another program, and so was the text here.").arg(name())
            : tr("%1 was changed by another program, also where you changed it (line %2).")
                  .arg(name(), lines.join(tr(", "))));
}

void FileFollower::follow(const text::Edits& edits) {
    Q_EMIT aboutToFollow();
    document_.follow(edits, theirs_, tr("Changes by Another Program"));
    set(State::quiet);
}

void FileFollower::keepMine() {
    const auto& base = document_.savedText();
    const std::string& mine = document_.bytes();
    const bool merges = state_ == State::disputed && base;
    text::Edits edits = merges ? text::merged(*base, mine, theirs_.bytes).edits : text::Edits{};
    if (!document_.isBroken() && isBroken(text::applied(mine, edits)))
        edits.clear();
    follow(edits);
}

void FileFollower::takeTheirs() {
    const auto& base = document_.savedText();
    const std::string& mine = document_.bytes();
    std::string wanted = theirs_.bytes;
    if (state_ == State::disputed && base)
        wanted = text::applied(wanted, text::merged(*base, wanted, mine).edits);
    if (isBroken(wanted))
        wanted = theirs_.bytes;
    follow(text::editsBetween(mine, wanted));
}

} // namespace session

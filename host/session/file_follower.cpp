#include "session/file_follower.h"

#include "text/characters.h"
#include "text/difference.h"
#include "text/lines.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace session {

namespace {

bool isBroken(const std::string& bytes) { return sgml::Tree::parse(bytes).isBroken(); }

// With the text around it, up to the next tags or line ends, but of a long text only what is near.
text::Range withWordsAround(std::string_view bytes, text::Range range) {
    constexpr std::size_t most = 80;
    const std::size_t first = range.from - std::min(range.from, most);
    const std::size_t last = std::min(range.to + most, bytes.size());
    const auto isEdge = [&](std::size_t at) { return bytes[at] == '\n' || bytes[at] == '>'; };
    const auto isEnd = [&](std::size_t at) { return bytes[at] == '\n' || bytes[at] == '<'; };
    std::size_t from = range.from, to = range.to;
    while (from > first && !isEdge(from - 1))
        --from;
    while (to < last && !isEnd(to))
        ++to;
    if (from > 0 && from == first) // whole words
        from = std::min(bytes.find(' ', from), range.from);
    if (to < bytes.size() && to == last)
        to = std::max(bytes.rfind(' ', to) + 1, range.to);
    return {text::characterStart(bytes, from), text::characterStart(bytes, to)};
}

// The text in a range, with dots where a text goes on.
QString excerpt(std::string_view bytes, text::Range range) {
    const auto isOneOf = [&](std::size_t at, std::string_view signs) {
        return signs.find(bytes[at]) != std::string_view::npos;
    };
    QString text =
        QString::fromUtf8(bytes.data() + range.from, static_cast<qsizetype>(range.size()));
    if (range.from > 0 && !isOneOf(range.from - 1, "\n>"))
        text.prepend(QChar(0x2026));
    if (range.to < bytes.size() && !isOneOf(range.to, "\n<"))
        text.append(QChar(0x2026));
    return text;
}

// LIMIT: so many characters of one text are shown.
QString shortened(const QString& words) {
    constexpr qsizetype most = 400;
    return words.size() > most ? words.left(most) + QChar(0x2026) : words;
}

// Without tags and braces.
QString words(const QString& source) {
    static const QRegularExpression tag(QStringLiteral("</?[A-Za-z][^<>]*>|[{}]"));
    return QString(source).replace(tag, QStringLiteral(" ")).simplified();
}

std::vector<FileFollower::Choice> choicesBetween(const std::string& mine,
                                                 const std::string& theirs) {
    std::vector<text::Range> left, right;
    for (const text::Hunk& hunk : text::differences(mine, theirs)) {
        const text::Range a = withWordsAround(mine, hunk.before),
                          b = withWordsAround(theirs, hunk.after);
        if (!left.empty() && (a.from <= left.back().to || b.from <= right.back().to)) {
            left.back().to = std::max(left.back().to, a.to);
            right.back().to = std::max(right.back().to, b.to);
        } else if (left.size() < FileFollower::mostChoices) {
            left.push_back(a);
            right.push_back(b);
        } else {
            break;
        }
    }
    const text::Lines lines(mine);
    std::vector<FileFollower::Choice> choices;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const QString a = excerpt(mine, left[i]), b = excerpt(theirs, right[i]);
        const bool isText = words(a) != words(b); // else the tags are what differs
        choices.push_back({.line = lines.at(left[i].from, mine).line,
                           .mine = shortened(isText ? words(a) : a.simplified()),
                           .theirs = shortened(isText ? words(b) : b.simplified())});
    }
    return choices;
}

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
    const State was = std::exchange(state_, state);
    std::vector<Choice> choices;
    if (state == State::disputed || state == State::damaged)
        choices = choicesBetween(keepingMine(), takingTheirs());
    if (state == was && sentence == sentence_ && choices == choices_)
        return;
    sentence_ = sentence;
    choices_ = std::move(choices);
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

// A file that was sound and is not may be half of what another program writes: it is given some
// time.
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
        return dispute();
    const text::Merge both = text::merged(*document_.savedText(), document_.bytes(), theirs_.bytes);
    const bool breaks =
        !document_.isBroken() && isBroken(text::applied(document_.bytes(), both.edits));
    if (breaks || !both.conflicts.empty())
        return dispute();
    follow(both.edits);
    Q_EMIT told(document_.isModified()
                    ? tr("%1 was changed by another program: its changes are here, too, beside "
                         "yours, which are not saved yet")
                          .arg(name())
                    : tr("%1 was changed by another program; this is its text now").arg(name()));
}

void FileFollower::dispute() {
    const bool alsoThere = bool(document_.savedText());
    set(State::disputed,
        alsoThere ? tr("%1 was changed by another program, also where you changed it.").arg(name())
                  : tr("%1 was changed by another program, and so was the text here.").arg(name()));
}

void FileFollower::follow(const text::Edits& edits) {
    Q_EMIT aboutToFollow();
    document_.follow(edits, theirs_, tr("Changes by Another Program"));
    set(State::quiet);
}

std::string FileFollower::keepingMine() const {
    const auto& base = document_.savedText();
    const std::string& mine = document_.bytes();
    if (state_ != State::disputed || !base)
        return mine;
    std::string both = text::applied(mine, text::merged(*base, mine, theirs_.bytes).edits);
    return !document_.isBroken() && isBroken(both) ? mine : both;
}

std::string FileFollower::takingTheirs() const {
    const auto& base = document_.savedText();
    const std::string& theirs = theirs_.bytes;
    if (state_ != State::disputed || !base)
        return theirs;
    std::string both = text::applied(theirs, text::merged(*base, theirs, document_.bytes()).edits);
    return isBroken(both) ? theirs : both;
}

void FileFollower::keepMine() { follow(text::editsBetween(document_.bytes(), keepingMine())); }
void FileFollower::takeTheirs() { follow(text::editsBetween(document_.bytes(), takingTheirs())); }

} // namespace session

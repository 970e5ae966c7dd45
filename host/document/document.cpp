#include "document/document.h"

#include "sgml/braces.h"
#include "text/characters.h"
#include "text/difference.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace document {

using sgml::NodeId;
using sgml::noNode;

Document::Document(std::string bytes, QObject* parent)
    : QObject(parent), tree_(sgml::Tree::parse(std::move(bytes))) {
    std::map<std::size_t, SubdocumentId> none;
    readSubdocuments(tree_.root(), none);
    orderSubdocuments();
}

Document::~Document() = default;

std::string Document::className() const { return std::string(tree_.name(tree_.root())); }

// --- edits ----------------------------------------------------------------------------------

namespace {

bool isPlain(const text::Edits& edits, const std::string& text) {
    return std::all_of(edits.begin(), edits.end(), [&](const text::Edit& edit) {
        return text::isUtf8(edit.text) && !text::isInsideCharacter(text, edit.range.from) &&
               !text::isInsideCharacter(text, edit.range.to);
    });
}

// Looks at the bytes around the edits alone.
bool changesNothing(text::Edits edits, const std::string& text) {
    if (edits.empty())
        return true;
    const std::size_t from = edits.front().range.from, to = edits.back().range.to;
    std::size_t added = 0, removed = 0;
    for (text::Edit& edit : edits) {
        added += edit.text.size();
        removed += edit.range.size();
        edit.range = {edit.range.from - from, edit.range.to - from};
    }
    const std::string_view before = std::string_view(text).substr(from, to - from);
    return added == removed && text::applied(before, edits) == before;
}

} // namespace

EditResult Document::editText(SubdocumentId id, int base, const text::Edits& edits,
                              const QString& label, const QString& group) {
    const Subdocument* target = subdocument(id);
    if (target == nullptr || !target->hasText)
        return EditResult::unknown;
    // A content that no brace closes ends where other tags end it: an edit could move that place.
    if (target->content != noNode &&
        sgml::closingBrace(tree_.text(tree_.node(target->content).range), 0) == std::string::npos)
        return EditResult::unknown;
    if (base != target->revision)
        return EditResult::stale;
    const std::string before = text(id);
    if (!text::areOrdered(edits, before.size()) || !isPlain(edits, before))
        return EditResult::invalid;
    const std::string after = text::applied(before, edits);
    if (after == before)
        return EditResult::nothing;
    Change change;
    if (target->content == noNode) {
        const NodeId storage = tree_.childElement(target->classElement, target->storage);
        const std::size_t at = tree_.node(storage).startTag.to;
        change.forward = {{{at, at}, "{" + sgml::escaped(after) + "}"}};
    } else {
        change.forward = sgml::contentEdits(tree_, target->content, edits);
        change.id = id;
        change.textForward = edits;
        change.textBackward = text::inverse(before, edits);
    }
    return perform(std::move(change), {.label = label, .group = group});
}

EditResult Document::edit(const text::Edits& edits, const EditNote& note) {
    if (!text::areOrdered(edits, bytes().size()))
        return EditResult::invalid;
    if (changesNothing(edits, bytes()))
        return EditResult::nothing;
    Change change;
    change.forward = edits;
    return perform(std::move(change), note);
}

void Document::follow(const text::Edits& edits, const files::ReadFile& file, const QString& label) {
    const bool wasModified = isModified();
    file_.stamp = file.stamp;
    saved_ = file.bytes;
    fileIsLost_ = false;
    if (!edits.empty()) {
        Change change;
        change.forward = edits;
        change.number = ++undo_.changes;
        change.backward = text::inverse(bytes(), edits);
        play(change, Direction::forward, label);
        push(std::move(change), {.label = label});
    }
    undo_.clean = bytes() == file.bytes ? undo_.done : noStep;
    announce(wasModified);
}

EditResult Document::perform(Change change, const EditNote& note) {
    const bool wasModified = isModified();
    change.number = ++undo_.changes;
    change.backward = text::inverse(bytes(), change.forward);
    play(change, Direction::forward, note.label);
    push(std::move(change), note);
    announce(wasModified);
    return EditResult::applied;
}

bool Document::joinsLast(const EditNote& note) const {
    if (!undo_.isOpen || undo_.done != undo_.steps.size() || undo_.done == 0 ||
        undo_.clean == undo_.done)
        return false;
    const EditNote& last = undo_.steps.back().note;
    if (!note.group.isEmpty())
        return note.group == last.group;
    return note.typed && last.typed && note.label == last.label && note.before == last.after &&
           *note.typed - *last.typed < typingPause;
}

// A letter behind the last one is part of the same change, so that what was typed costs no more
// than its letters.
bool Document::extends(Change& last, const Change& change) {
    const auto isInsertion = [](const Change& one) {
        return one.id == noSubdocument && one.forward.size() == 1 && one.backward.size() == 1 &&
               one.forward[0].range.size() == 0 && one.lost.empty() && one.found.empty() &&
               one.textForward.empty() && one.textBackward.empty();
    };
    if (!isInsertion(last) || !isInsertion(change))
        return false;
    text::Edit& typed = last.forward[0];
    const text::Edit& more = change.forward[0];
    if (more.range.from != typed.range.from + typed.text.size())
        return false;
    typed.text += more.text;
    last.backward[0].range.to += more.text.size();
    return true;
}

void Document::push(Change change, const EditNote& note) {
    if (undo_.clean != noStep && undo_.clean > undo_.done)
        undo_.clean = noStep;
    if (joinsLast(note)) {
        undo_.steps.back().note.after = note.after;
        undo_.steps.back().note.typed = note.typed;
        if (extends(undo_.steps.back().changes.back(), change))
            return;
    } else {
        undo_.steps.resize(undo_.done);
        undo_.steps.push_back({.note = note, .changes = {}});
        ++undo_.done;
    }
    undo_.steps.back().changes.push_back(std::move(change));
    undo_.isOpen = true;
}

// Everything that is known of the text before is taken down, then the tree follows, then the
// subdocuments, then all are told.
void Document::play(Change& change, Direction direction, const QString& label) {
    ++revision_;
    const bool forward = direction == Direction::forward;
    const text::Edits& edits = forward ? change.forward : change.backward;
    const std::vector<Remembered> before = rememberSubdocuments(edits);
    const sgml::Change told = sgml::applyEdits(tree_, edits);
    const bool structure = told.everything || !told.tags.empty() || !told.children.empty();
    const std::set<SubdocumentId> touched =
        structure ? followStructure(told, before, change, direction) : ownersOf(told.texts);
    emit edited(told, forward ? change.backward : change.forward, change.number);
    bool anyText = false;
    for (const Remembered& was : before) {
        const Subdocument* now = subdocument(was.id);
        if (now == nullptr || !touched.contains(was.id))
            continue;
        text::Edits changes = forward ? change.textForward : change.textBackward;
        if (was.id != change.id || changes.empty())
            changes = {text::difference(textBefore(was, edits), text(was.id))};
        if (changes.front().empty())
            continue;
        anyText = true;
        emit textChanged(was.id, changes, nextRevision(was.id), label);
    }
    if (structure || (anyText && told.texts.size() > touched.size()))
        emit subdocumentsChanged();
}

// --- undo -----------------------------------------------------------------------------------

std::size_t Document::keptChanges() const {
    std::size_t all = 0;
    for (const Step& step : undo_.steps)
        all += step.changes.size();
    return all;
}

QString Document::lastGroup() const {
    return canUndo() ? undo_.steps[undo_.done - 1].note.group : QString();
}
QString Document::undoLabel() const {
    return canUndo() ? undo_.steps[undo_.done - 1].note.label : QString();
}
QString Document::redoLabel() const {
    return canRedo() ? undo_.steps[undo_.done].note.label : QString();
}

void Document::undo() {
    if (!canUndo())
        return;
    const bool wasModified = isModified();
    Step& step = undo_.steps[--undo_.done];
    for (auto change = step.changes.rbegin(); change != step.changes.rend(); ++change)
        play(*change, Direction::backward, step.note.label);
    undo_.isOpen = false;
    announce(wasModified, step.note.before);
}

void Document::redo() {
    if (!canRedo())
        return;
    const bool wasModified = isModified();
    Step& step = undo_.steps[undo_.done++];
    for (Change& change : step.changes)
        play(change, Direction::forward, step.note.label);
    undo_.isOpen = false;
    announce(wasModified, step.note.after);
}

// A receiver may edit: the selection comes as a value.
void Document::announce(bool wasModified, std::optional<Selection> selection) {
    emit changed();
    emit undoChanged();
    if (isModified() != wasModified)
        emit modifiedChanged(isModified());
    if (selection)
        emit selectionRestored(*selection);
}

// --- its file -------------------------------------------------------------------------------

namespace {

std::string pathOf(const QString& fileName) { return QFile::encodeName(fileName).toStdString(); }

} // namespace

// LIMIT: a longer file is not read at all; its tree could not be either (sgml::Limits).
Document::Loaded Document::load(const QString& fileName, files::FileSystem* files) {
    files::FileSystem& system = files != nullptr ? *files : files::FileSystem::real();
    const std::string path = pathOf(fileName);
    files::removeAbandonedParts(system, path);
    files::ReadFile file = files::readFile(system, path, sgml::Limits{}.bytes);
    if (!file.read)
        return {.document = nullptr,
                .failure =
                    QStringLiteral("%1 cannot be read: %2.")
                        .arg(QFileInfo(fileName).fileName(), QString::fromStdString(file.reason))};
    Loaded loaded{.document = std::make_unique<Document>(std::move(file.bytes)), .failure = {}};
    loaded.document->fileName_ = fileName;
    loaded.document->saved_ = loaded.document->bytes();
    loaded.document->file_ = {path, file.stamp};
    loaded.document->files_ = &system;
    return loaded;
}

std::unique_ptr<Document> Document::recover(const files::KnownFile& file, std::string text) {
    const QString fileName = QFile::decodeName(file.path.c_str());
    if (Loaded loaded = file.path.empty() ? Loaded{} : load(fileName); loaded.document) {
        loaded.document->recoverText(file, text);
        return std::move(loaded.document);
    }
    auto document = std::make_unique<Document>(std::move(text));
    document->fileName_ = fileName;
    document->file_ = file;
    document->undo_.clean = noStep;
    return document;
}

void Document::recoverText(const files::KnownFile& file, const std::string& text) {
    if (file.stamp.hash != file_.stamp.hash)
        saved_.reset(); // what the program knew that ended is gone
    file_ = file;
    if (bytes() != text)
        edit({text::difference(bytes(), text)}, tr("Recover"));
}

files::SaveResult Document::save(files::SaveOptions options) { return saveAs(fileName_, options); }

files::SaveResult Document::saveAs(const QString& fileName, files::SaveOptions options) {
    if (fileName.isEmpty())
        return {.saved = false,
                .refusal = files::Refusal::none,
                .sentence = "The document has no file name yet."};
    const std::string path = pathOf(fileName);
    if (isBroken() && !options.evenBroken && files::isSameFile(*files_, path, file_.path))
        return {.saved = false,
                .refusal = files::Refusal::broken,
                .sentence =
                    files::nameOf(path) + " could be read only in part; saving would replace it."};
    files::SaveResult result = files::saveFile(*files_, path, bytes(), file_, options);
    if (!result)
        return result;
    const bool wasModified = isModified();
    undo_.clean = undo_.done;
    saved_ = bytes();
    fileIsLost_ = false;
    if (fileName != fileName_) {
        fileName_ = fileName;
        emit fileNameChanged();
    }
    if (wasModified)
        emit modifiedChanged(false);
    return result;
}

files::ReadFile Document::readFile() const {
    return files::readFile(*files_, file_.path, sgml::Limits{}.bytes);
}

bool Document::hasBackup() const {
    return !file_.path.empty() &&
           files_->access(files::backupOf(*files_, file_.path).c_str(), R_OK) == 0;
}

files::ReadFile Document::readBackup() const {
    return files::readFile(*files_, files::backupOf(*files_, file_.path), sgml::Limits{}.bytes);
}

void Document::setFileLost(bool lost) {
    const bool wasModified = isModified();
    fileIsLost_ = lost;
    if (isModified() != wasModified)
        emit modifiedChanged(isModified());
}

files::FileState Document::fileState() const { return files::compareFile(*files_, file_); }

} // namespace document

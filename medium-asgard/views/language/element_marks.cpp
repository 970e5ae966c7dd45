#include "language/element_marks.h"

#include "editing/changes.h"

#include <QKeyEvent>
#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <mutex>

namespace views {

using editing::Editable;
using editing::Kind;
using render::HandleKind;
using scene::Range;

namespace {

constexpr int selectedMarker = 3;

// A place of one side of the hunks on the other: the nearest, where it has none.
std::size_t across(const std::vector<text::Hunk>& hunks, std::size_t place, bool forward) {
    long shift = 0;
    for (const text::Hunk& hunk : hunks) {
        const text::Range here = forward ? hunk.before : hunk.after;
        const text::Range there = forward ? hunk.after : hunk.before;
        if (place < here.from)
            break;
        if (place < here.to)
            return std::min(there.from + (place - here.from), there.to);
        shift = static_cast<long>(there.to) - static_cast<long>(here.to);
    }
    return static_cast<std::size_t>(static_cast<long>(place) + shift);
}

// A stretch line by line, without the blanks around.
std::vector<Range> linesOf(const std::string& text, Range range) {
    std::vector<Range> lines;
    for (std::size_t at = range.from; at < range.to;) {
        std::size_t end = std::min(text.find('\n', at), range.to);
        const std::size_t next = end + 1;
        at = std::min(text.find_first_not_of(" \t", at), end);
        while (end > at && (text[end - 1] == ' ' || text[end - 1] == '\t'))
            --end;
        if (at < end)
            lines.push_back({at, end});
        at = next;
    }
    return lines;
}

QString wordsOf(HandleKind kind) {
    switch (kind) {
    case HandleKind::position:
        return QObject::tr("where it starts");
    case HandleKind::velocity:
        return QObject::tr("its velocity at the start");
    case HandleKind::orientation:
        return QObject::tr("how it is turned at the start");
    case HandleKind::spin:
        return QObject::tr("its angular velocity at the start");
    case HandleKind::forceBase:
    case HandleKind::torqueBase:
        return QObject::tr("where it acts");
    case HandleKind::forceHead:
        return QObject::tr("how strong it is");
    case HandleKind::torqueHead:
        return QObject::tr("how it turns");
    case HandleKind::linkEnd:
        return QObject::tr("where an end is");
    case HandleKind::jointPoint:
        return QObject::tr("where it holds");
    case HandleKind::jointAxis:
        return QObject::tr("which way its axis points");
    case HandleKind::jointLimit:
        return QObject::tr("how far it goes");
    case HandleKind::ropeLength:
        return QObject::tr("how long it is");
    case HandleKind::lightPlace:
        return QObject::tr("where it is");
    case HandleKind::lightDirection:
        return QObject::tr("where it shines");
    case HandleKind::trajectoryPoint:
        break;
    }
    return QObject::tr("where it leads");
}

// As Scintilla has colours in the values of marks.
int valueOf(const scene::Color& color) {
    const auto byte = [](double part) { return static_cast<int>(std::lround(part * 255)); };
    return QsciScintillaBase::SC_INDICVALUEBIT | byte(color.red) | (byte(color.green) << 8) |
           (byte(color.blue) << 16);
}

} // namespace

HandleKind handleOf(const Editable& value, const scene::Scene& scene) {
    const std::string& option = value.option;
    switch (value.element.kind) {
    case Kind::force:
        if (scene.forces[value.element.index].couple)
            return option == "-offset" ? HandleKind::torqueBase : HandleKind::torqueHead;
        return option == "-offset" ? HandleKind::forceBase : HandleKind::forceHead;
    case Kind::link:
        return HandleKind::linkEnd;
    case Kind::joint:
        return option == "-axis" ? HandleKind::jointAxis : HandleKind::jointPoint;
    case Kind::light:
        return option == "-pos" ? HandleKind::lightPlace : HandleKind::lightDirection;
    case Kind::trajectory:
        return HandleKind::trajectoryPoint;
    default:
        break;
    }
    return option == "-init_rot"    ? HandleKind::orientation
           : option == "-init_dpos" ? HandleKind::velocity
           : option == "-init_drot" ? HandleKind::spin
                                    : HandleKind::position;
}

// Who asked, while that one is there.
struct ElementMarks::Errand {
    std::mutex mutex;
    ElementMarks* from = nullptr;
    std::atomic<int> wanted{0}; // the newest revision that was asked about
};

ElementMarks::~ElementMarks() {
    if (!errand_)
        return;
    const std::lock_guard lock(errand_->mutex);
    errand_->from = nullptr;
}

ElementMarks::ElementMarks(SceneEditor& editor, SceneDocument& document, Draft& draft)
    : editor_(editor), document_(document), draft_(draft) {
    editor_.addTool(this);
    editor_.setMarginType(2, QsciScintilla::SymbolMargin);
    editor_.setMarginWidth(2, 4);
    editor_.setMarginMarkerMask(2, 1 << selectedMarker);
    editor_.markerDefine(QsciScintilla::FullRectangle, selectedMarker);
    editor_.setMarkerBackgroundColor(QColor(0x3A, 0x84, 0xD8), selectedMarker);
    connect(&document_, &SceneDocument::sceneChanged, this, &ElementMarks::markArguments);
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &ElementMarks::markArguments);
    rest_.setSingleShot(true);
    rest_.setInterval(200);
    connect(&rest_, &QTimer::timeout, this, &ElementMarks::findOut);
    connect(&more_, &QTimer::timeout, this, &ElementMarks::markSome);
    connect(&document_, &SceneDocument::selectionChanged, this, &ElementMarks::showSelection);
    connect(&draft_, &Draft::changed, this, &ElementMarks::markArguments);
    connect(&editor_, &QsciScintillaBase::SCN_UPDATEUI, this, &ElementMarks::caretMoved);
    markArguments();
}

void ElementMarks::markArguments() {
    // Of a draft and of a faulty text what was good keeps its marks, which move with their words.
    if (draft_.edited())
        marked_ = -1;
    if (!document_.sceneIsCurrent() || draft_.edited())
        return;
    if (std::exchange(marked_, document_.revision()) == document_.revision())
        return; // nothing new
    markSelection();
    constexpr std::size_t quick = 30'000; // bytes
    more_.stop();
    if (document_.text().size() > quick)
        return rest_.start();
    editor_.unmark(Mark::argument);
    for (const Coloured& one : colouredOf(document_.text(), document_.shown().scene))
        editor_.mark(Mark::argument, one.range, one.value);
}

std::vector<ElementMarks::Coloured>
ElementMarks::colouredOf(const std::string& text,
                         const std::shared_ptr<const scene::Scene>& scene) {
    std::vector<Coloured> all;
    for (const Editable& one : editing::editablesOf(text, scene))
        for (const Range& line : linesOf(text, one.range))
            all.push_back({line, valueOf(render::colorOf(handleOf(one, *scene)))});
    return all;
}

void ElementMarks::findOut() {
    if (!document_.sceneIsCurrent() || draft_.edited())
        return;
    if (!errand_) {
        errand_ = std::make_shared<Errand>();
        errand_->from = this;
    }
    errand_->wanted = document_.revision();
    QThreadPool::globalInstance()->start([errand = errand_, text = document_.text(),
                                          scene = document_.shown().scene,
                                          revision = document_.revision()] {
        if (errand->wanted != revision) // it waited, and the text went on
            return;
        std::vector<Coloured> found = colouredOf(text, scene);
        const std::lock_guard lock(errand->mutex);
        ElementMarks* const marks = errand->from;
        if (!marks)
            return;
        const auto take = [marks, revision, found = std::move(found)] {
            if (revision != marks->document_.revision() || marks->draft_.edited())
                return;
            marks->editor_.unmark(Mark::argument);
            marks->toMark_ = {found.rbegin(), found.rend()};
            marks->toMarkRevision_ = revision;
            marks->more_.start(0);
        };
        QMetaObject::invokeMethod(marks, take, Qt::QueuedConnection);
    });
}

void ElementMarks::markSome() {
    constexpr int atOnce = 400;
    if (toMarkRevision_ != document_.revision() || draft_.edited())
        toMark_.clear();
    for (int i = 0; i < atOnce && !toMark_.empty(); ++i) {
        editor_.mark(Mark::argument, toMark_.back().range, toMark_.back().value);
        toMark_.pop_back();
    }
    if (toMark_.empty())
        more_.stop();
}

// --- places --------------------------------------------------------------------------------

Range ElementMarks::inEditor(Range range) const {
    if (!draft_.edited())
        return range;
    const auto& hunks = draft_.hunks();
    return {across(hunks, range.from, true), across(hunks, range.to, true)};
}

Range ElementMarks::inDocument(Range range) const {
    if (!draft_.edited())
        return range;
    const auto& hunks = draft_.hunks();
    return {across(hunks, range.from, false), across(hunks, range.to, false)};
}

// --- selection -----------------------------------------------------------------------------

void ElementMarks::caretMoved(int updated) {
    if ((updated & QsciScintillaBase::SC_UPDATE_SELECTION) == 0 || !editor_.hasFocus() ||
        !document_.sceneIsCurrent())
        return;
    const Range here = editor_.selection();
    if (here == caret_)
        return;
    caret_ = here;
    const Range place = inDocument(here);
    std::vector<editing::Element> elements;
    const scene::Scene& scene = *document_.shown().scene;
    for (const editing::Element& element : editing::elementsOf(scene)) {
        const Range command = editing::sourceOf(scene, element)->command;
        if (element.kind != Kind::simulator && command.known() && command.from <= place.to &&
            place.from <= command.to)
            elements.push_back(element);
    }
    if (elements.empty()) // between commands one writes, and selects nothing
        return;
    selecting_ = true;
    document_.select(std::move(elements));
    selecting_ = false;
}

void ElementMarks::showSelection() {
    markSelection();
    if (selecting_ || document_.selected().empty() || !document_.sceneIsCurrent())
        return;
    const scene::Source* source =
        editing::sourceOf(*document_.shown().scene, document_.selected().front());
    if (source && source->command.known())
        Q_EMIT wanted(inEditor(source->command));
}

void ElementMarks::markSelection() {
    editor_.markerDeleteAll(selectedMarker);
    if (!document_.sceneIsCurrent())
        return;
    for (const editing::Element& element : document_.selected()) {
        const scene::Source* source = editing::sourceOf(*document_.shown().scene, element);
        if (!source || !source->command.known())
            continue;
        const Range range = inEditor(source->command);
        for (int line = editor_.lineOf(range.from); line <= editor_.lineOf(range.to); ++line)
            editor_.markerAdd(line, selectedMarker);
    }
}

bool ElementMarks::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape && !editor_.selection().known() && !editor_.isListActive())
        document_.select({});
    return false; // Scintilla closes its list and its hint by it
}

QString ElementMarks::tip(std::size_t byte) const {
    if (!document_.sceneIsCurrent() || draft_.edited())
        return {};
    const auto& scene = document_.shown().scene;
    const editing::Mapper mapper(document_.text(), scene);
    for (const Editable& one : editing::editablesOf(document_.text(), scene))
        if (one.range.from <= byte && byte < one.range.to)
            return tr("%1 of %2: %3.\nIts handle in pictures has this colour. Alt and the pointer, "
                      "or Alt+Up and Alt+Down, change the number here.")
                .arg(QString::fromStdString(one.option),
                     QString::fromStdString(mapper.nameOf(one.element)),
                     wordsOf(handleOf(one, *scene)));
    return {};
}

} // namespace views

#include "picture/picture_editing.h"

#include "element_edits/deletion.h"
#include "gestures/handle_meaning.h"
#include "offers/value_entry.h"
#include "picture/scene_display.h"
#include "plain/plain.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>
#include <utility>

namespace views {

namespace {

render::CameraControl::Button cameraButton(Qt::MouseButton button) {
    using Button = render::CameraControl::Button;
    return button == Qt::LeftButton     ? Button::left
           : button == Qt::MiddleButton ? Button::middle
                                        : Button::right;
}

std::optional<gestures::Hand::Key> handKey(int key) {
    using Key = gestures::Hand::Key;
    switch (key) {
    case Qt::Key_Escape:
        return Key::escape;
    case Qt::Key_Z:
        return Key::away;
    case Qt::Key_X:
        return Key::nearer;
    case Qt::Key_A:
        return Key::free;
    case Qt::Key_Left:
        return Key::left;
    case Qt::Key_Right:
        return Key::right;
    case Qt::Key_Up:
        return Key::up;
    case Qt::Key_Down:
        return Key::down;
    default:
        return std::nullopt;
    }
}

// Ctrl+Z is the window's, also where there is nothing to undo.
bool isOfWindow(const QKeyEvent& event) {
    return event.modifiers().testAnyFlags(Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
}

} // namespace

PictureEditing::PictureEditing(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display) {
    connect(&document_, &SceneDocument::selectionChanged, this, &PictureEditing::followSelection);
    connect(&said_, &Said::changed, this, &PictureEditing::changed);
    rest_.setSingleShot(true);
    rest_.setInterval(20);
    connect(&rest_, &QTimer::timeout, this, &PictureEditing::goOn);
    // It was about the text before.
    connect(&document_, &SceneDocument::textChanged, this, [this] { say({}); });
    connect(&document_, &SceneDocument::opened, this, [this] { say({}); });
    connect(&document_, &SceneDocument::sceneChanged, this, [this] {
        if (!expected_.empty())
            document_.select(std::exchange(expected_, {}));
    });
}

PictureEditing::~PictureEditing() = default;

std::optional<render::Handle> PictureEditing::handleUnder(const QPointF& position) const {
    const render::HandleSet& set = display_.handles();
    const auto index = gestures::handleAt(set, display_.sight(), display_.inPixels(position),
                                          gestures::handleReach * display_.devicePixelRatioF());
    return index ? std::optional(set.handles[*index]) : std::nullopt;
}

// The picture stays while what is in it moves.
gestures::Ground PictureEditing::beginGesture() {
    delete entry_;
    display_.keepCamera();
    since_ = document_.revision();
    return document_.ground();
}

void PictureEditing::take(const gestures::Grasp& grasp, const Eigen::Vector2d& pixels) {
    before_ = document_.selected();
    if (grasp.what == gestures::Grasp::What::removePoint) {
        mark(grasp.handle);
        return removePoint(grasp.handle);
    }
    gestures::Ground ground = beginGesture();
    hand_.take(std::move(ground), display_.sight(), grasp, cameraButton(button_), pixels,
               display_.devicePixelRatioF());
    mark(grasp.handle); // last: what is selected may open a strip, and the picture gets smaller
    Q_EMIT changed();
}

bool PictureEditing::mayChange() {
    const QString fault = document_.whyNotCurrent();
    if (!fault.isEmpty())
        say(fault);
    return fault.isEmpty();
}

bool PictureEditing::press(QMouseEvent& event) {
    if (dragging())
        return true;
    say({});
    const bool shifted = event.modifiers() & Qt::ShiftModifier;
    if (!shifted)
        return false;
    if (!mayChange())
        return true;
    button_ = event.button();
    const Eigen::Vector2d pixels = display_.inPixels(event.position());
    const auto grasp = gestures::graspAt(display_.drawing(), display_.handles(), display_.sight(),
                                         cameraButton(button_), pixels,
                                         gestures::handleReach * display_.devicePixelRatioF());
    if (grasp)
        take(*grasp, pixels);
    return true;
}

bool PictureEditing::pressBody(std::size_t body, const QPointF& position,
                               const std::optional<gestures::HandleDrag::Along>& along) {
    const auto handle = positionOf(body);
    if (!handle || !mayChange())
        return false;
    button_ = Qt::LeftButton;
    take({gestures::Grasp::What::drag, *handle, companyOf(body)}, display_.inPixels(position));
    hand_.setUpright(along);
    return true;
}

std::vector<std::size_t> PictureEditing::companyOf(std::size_t body) const {
    const auto& selected = document_.selected();
    std::vector<std::size_t> others;
    if (std::ranges::find(selected, editing::Element{editing::Kind::body, body}) != selected.end())
        for (const editing::Element& one : selected)
            if (one.kind == editing::Kind::body && one.index != body)
                others.push_back(one.index);
    return others;
}

std::optional<Asked> PictureEditing::asked() const {
    const auto answer = hand_.answer();
    return answer ? std::optional(Asked{since_, *answer}) : std::nullopt;
}

bool PictureEditing::letGo() {
    if (!dragging() || document_.mayGoOn(since_))
        return false;
    hand_.drop();
    say(SceneDocument::overtaken());
    Q_EMIT changed();
    return true;
}

void PictureEditing::goOn() {
    if (letGo() || !hand_.goOn())
        return;
    rest_.start();
    Q_EMIT changed();
}

bool PictureEditing::move(QMouseEvent& event) {
    if (letGo())
        return true;
    if (!dragging())
        return false;
    hand_.move(display_.inPixels(event.position()), event.modifiers() & Qt::ControlModifier);
    rest_.start();
    Q_EMIT changed();
    return true;
}

bool PictureEditing::release(QMouseEvent& event) {
    if (letGo())
        return true;
    if (!dragging())
        return false;
    if (const auto gone = hand_.release(cameraButton(event.button()))) {
        if (gone->drag && !gone->drag->moved() && event.button() == Qt::LeftButton) {
            document_.select(std::move(before_));
            display_.selecting().addOrTakeOut(event.position());
        }
        ended(*gone);
    }
    return true;
}

// It cannot be so: what could be done instead is offered, or why not is said.
void PictureEditing::ended(const gestures::Hand::LetGo& gone) {
    Q_EMIT changed();
    if (gone.drag && gone.drag->moved() && !gone.drag->answer().offers.empty())
        offerOthers(*gone.drag);
    else if (!gone.fault.empty())
        say(QString::fromStdString(gone.fault));
}

bool PictureEditing::doubleClick(QMouseEvent& event) {
    const auto handle =
        event.button() == Qt::LeftButton ? handleUnder(event.position()) : std::nullopt;
    if (!handle)
        return event.button() == Qt::LeftButton && openBodyAt(event.position());
    say({});
    if (!mayChange())
        return true;
    hand_.cancel();
    mark(*handle);
    openEntry();
    return true;
}

void PictureEditing::finish() {
    letGo();
    const bool byKeys = hand_.byKeys();
    if (const auto gone = hand_.finish()) {
        Q_EMIT changed();
        if (byKeys)
            ended(*gone);
    }
}

// It cannot be moved as it stands: what could be done instead, and what would that change?
void PictureEditing::offerOthers(const gestures::HandleDrag& drag) {
    if (document_.text() != drag.text())
        return; // it was changed elsewhere meanwhile
    delete entry_;
    entry_ = new ValueEntry(document_, commands::askedOf(drag.ground(), drag.handle()), &display_);
    entry_->propose(drag.wishes());
    entry_->openAt(display_.fromPixels(display_.sight().pixels(drag.place())).toPoint());
    Q_EMIT changed();
}

// --- keys ------------------------------------------------------------------------------------

void PictureEditing::mark(const render::Handle& handle) {
    mark_ = handle.name();
    const editing::Element element = gestures::elementOf(handle);
    if (std::ranges::find(document_.selected(), element) == document_.selected().end())
        document_.select({element});
}

void PictureEditing::choose(render::HandleKind kind, std::size_t element, std::size_t part) {
    render::Handle handle;
    handle.kind = kind;
    handle.element = element;
    handle.part = part;
    document_.select({gestures::elementOf(handle)});
    mark(handle);
    Q_EMIT changed();
}

// What another view selects is marked here too.
void PictureEditing::followSelection() {
    const auto& selected = document_.selected();
    render::Handle handle;
    if (mark_) {
        handle.kind = mark_->kind;
        handle.element = mark_->element;
    }
    const bool among =
        mark_ && std::ranges::find(selected, gestures::elementOf(handle)) != selected.end();
    if (!among && !hand_.drag()) {
        mark_.reset();
        if (!selected.empty())
            markElement(selected.front());
    }
    Q_EMIT changed();
}

std::optional<render::Handle> PictureEditing::marked() const {
    if (mark_)
        for (const render::Handle& handle : display_.handles().handles)
            if (handle.name() == mark_)
                return handle;
    // A body is there without its handle.
    return mark_ && mark_->kind == render::HandleKind::position ? positionOf(mark_->element)
                                                                : std::nullopt;
}

std::optional<render::Handle> PictureEditing::positionOf(std::size_t body) const {
    const auto& bodies = document_.shown().scene->bodies;
    if (body >= bodies.size())
        return std::nullopt;
    render::Handle handle;
    handle.element = body;
    handle.base = handle.place = bodies[body].initialPosition;
    return handle;
}

void PictureEditing::markNext(int step) {
    std::vector<render::Handle> all;
    std::size_t at = 0;
    const auto now = marked();
    for (const render::Handle& handle : display_.handles().handles) {
        if (!handle.movable)
            continue;
        if (now && handle.name() == now->name())
            at = all.size();
        all.push_back(handle);
    }
    if (all.empty()) // no handles are shown: from body to body
        for (std::size_t i = 0; const auto body = positionOf(i); ++i) {
            if (now && now->kind == body->kind && now->element == i)
                at = i;
            all.push_back(*body);
        }
    if (all.empty())
        return;
    const auto count = all.size();
    const render::Handle& next =
        all[now ? (at + count + static_cast<std::size_t>(step + static_cast<int>(count))) % count
                : 0];
    if (next.folded)
        display_.openCrowd(
            gestures::crowdAt(display_.handles(), display_.sight().pixels(next.place), 0));
    choose(next.kind, next.element, next.part);
}

bool PictureEditing::dragKey(QKeyEvent& event) {
    if (letGo())
        return true;
    constexpr int axes[] = {Qt::Key_X, Qt::Key_Y, Qt::Key_Z};
    const auto* axis = std::ranges::find(axes, event.key());
    if (axis != std::end(axes) &&
        hand_.keepAlong(
            {static_cast<int>(axis - axes), event.modifiers().testFlag(Qt::ShiftModifier)})) {
        Q_EMIT changed();
        return true;
    }
    const auto key = handKey(event.key());
    if (!key || !hand_.key(*key, true, display_.devicePixelRatioF()))
        return false;
    Q_EMIT changed();
    return true;
}

bool PictureEditing::keyPress(QKeyEvent& event) {
    if (isOfWindow(event))
        return dragging() && !hand_.byKeys();
    if (dragging())
        return dragKey(event) || !hand_.byKeys();
    say({});
    const bool shifted = event.modifiers() == Qt::ShiftModifier;
    if (event.key() == Qt::Key_H && (shifted || event.modifiers() == Qt::NoModifier)) {
        markNext(shifted ? -1 : 1);
        return true;
    }
    const int key = event.key();
    if (key == Qt::Key_Escape && !document_.selected().empty()) {
        document_.select({});
        return true;
    }
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
        deleteMarked();
        return true;
    }
    const auto handle = marked();
    if (!handle || !document_.sceneIsCurrent())
        return false;
    if (key == Qt::Key_Insert && handle->kind == render::HandleKind::trajectoryPoint) {
        addPointAfterMarked();
        return true;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        openEntry();
        return true;
    }
    const bool arrow =
        key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
    if (!(shifted && arrow) && key != Qt::Key_Z && key != Qt::Key_X)
        return false;
    gestures::Ground ground = beginGesture();
    hand_.takeByKeys(std::move(ground), display_.sight(), *handle, companyOf(handle->element));
    mark(*handle);
    return dragKey(event);
}

void PictureEditing::keyRelease(QKeyEvent& event) {
    if (!hand_.drag() || event.isAutoRepeat())
        return;
    if (event.key() == Qt::Key_A)
        hand_.key(gestures::Hand::Key::free, false, 1);
    const bool pushing = (event.key() == Qt::Key_Z || event.key() == Qt::Key_X) &&
                         !(event.modifiers() & Qt::ShiftModifier);
    if (hand_.byKeys() && (event.key() == Qt::Key_Shift || pushing))
        finish();
}

// --- taking out -----------------------------------------------------------------------------

void PictureEditing::markElement(const editing::Element& element) {
    using editing::Kind;
    using render::HandleKind;
    mark_.reset();
    const auto& scene = *document_.shown().scene;
    if (element.kind == Kind::body)
        mark_ = render::HandleName{HandleKind::position, element.index, 0};
    else if (element.kind == Kind::force)
        mark_ = render::HandleName{HandleKind::forceHead, element.index, 0};
    else if (element.kind == Kind::link)
        mark_ = render::HandleName{HandleKind::linkEnd, element.index, 0};
    else if (element.kind == Kind::joint)
        mark_ = render::HandleName{HandleKind::jointPoint, element.index, 0};
    else if (element.kind == Kind::light)
        mark_ = render::HandleName{HandleKind::lightPlace, element.index, 0};
    else if (element.kind == Kind::trajectory)
        mark_ = render::HandleName{HandleKind::trajectoryPoint, element.index, 0};
    if (element.kind == Kind::force && element.index < scene.forces.size() &&
        scene.forces[element.index].couple)
        mark_->kind = HandleKind::torqueHead;
}

void PictureEditing::take(const text::Edits& edits, const QString& label) {
    mark_.reset();
    document_.setText(text::applied(document_.text(), edits), label);
    Q_EMIT changed();
}

void PictureEditing::removePoint(const render::Handle& handle) {
    const gestures::Removal removal = gestures::removalOf(document_.ground(), handle);
    if (!removal.possible())
        say(QString::fromStdString(removal.reason));
    else if (removal.isWhole)
        remove({gestures::elementOf(handle)});
    else
        take(removal.edits, tr("Remove a point"));
}

void PictureEditing::deleteMarked() {
    const auto handle = marked();
    if (!handle) // selected, and not to be seen
        return remove(document_.selected());
    if (!mayChange())
        return;
    const editing::Element element = gestures::elementOf(*handle);
    if (handle->kind == render::HandleKind::trajectoryPoint)
        return removePoint(*handle);
    std::vector<editing::Element> elements = document_.selected();
    if (std::ranges::find(elements, element) == elements.end())
        elements = {element};
    remove(std::move(elements));
}

void PictureEditing::addPointAfterMarked() {
    const auto handle = marked();
    if (!handle || handle->kind != render::HandleKind::trajectoryPoint ||
        !document_.sceneIsCurrent())
        return;
    gestures::NewPoint point(document_.ground(), display_.sight(), *handle);
    point.after();
    if (!point.answer().possible())
        say(QString::fromStdString(point.words()));
    point.finish();
}

void PictureEditing::remove(std::vector<editing::Element> elements) {
    if (elements.empty() || !mayChange())
        return;
    const scene::Scene& scene = *document_.shown().scene;
    const editing::Element element = elements.front();
    const auto deletion = editing::deletionOf(document_.text(), scene, elements);
    if (!deletion.possible())
        return say(QString::fromStdString(deletion.reason));
    const QString name = elements.size() == 1
                             ? QString::fromStdString(editing::describe(scene, element))
                             : tr("%1 elements").arg(elements.size());
    QString question = tr("Delete %1 and all that depends on it?").arg(name);
    for (const editing::Element& one : deletion.along)
        question += "\n    " + QString::fromStdString(editing::describe(scene, one));
    const auto since = document_.revision();
    if (!deletion.along.empty()) {
        const bool taken =
            confirm_
                ? confirm_(question)
                : plain::Message::ask(QMessageBox::Question, &display_, tr("Delete"), question,
                                      QMessageBox::Yes | QMessageBox::Cancel) == QMessageBox::Yes;
        if (!taken)
            return;
        if (document_.revision() != since) // by the host, while the question stood
            return say(tr("The text was changed meanwhile: nothing is deleted."));
    }
    take(deletion.edits, tr("Delete %1").arg(name));
}

// --- exact values ----------------------------------------------------------------------------

void PictureEditing::openEntry() {
    const auto handle = marked();
    if (!handle || !mayChange())
        return;
    openEntry(commands::askedOf(document_.ground(), *handle), handle->place);
}

void PictureEditing::openEntry(commands::AskedValue asked, const geometry::Vector& place) {
    delete entry_;
    entry_ = new ValueEntry(document_, std::move(asked), &display_);
    entry_->openAt(display_.fromPixels(display_.sight().pixels(place)).toPoint());
    Q_EMIT changed();
}

} // namespace views

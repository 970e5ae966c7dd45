#include "views/picture_editing.h"

#include "views/handle_meaning.h"
#include "views/scene_display.h"
#include "views/value_entry.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace views {

namespace {

constexpr double reach = 14;  // pixels, of a handle
constexpr double keyStep = 6; // pixels, for a press of a key

QColor toColor(const scene::Color& c) { return QColor::fromRgbF(c.red, c.green, c.blue); }

} // namespace

PictureEditing::PictureEditing(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display) {}

PictureEditing::~PictureEditing() = default;

std::optional<render::Handle> PictureEditing::handleUnder(const QPointF& position) const {
    const render::HandleSet& set = display_.handles();
    const auto index = handleAt(set, display_.sight(), display_.inPixels(position),
                                reach * display_.devicePixelRatioF());
    return index ? std::optional(set.handles[*index]) : std::nullopt;
}

void PictureEditing::begin(const render::Handle& handle,
                           const std::optional<Eigen::Vector2d>& pixels) {
    delete entry_;
    display_.keepCamera(); // the picture stays while what is in it moves
    mark(handle);
    drag_ = std::make_unique<HandleDrag>(document_, display_.sight(), handle, pixels);
    byKeys_ = !pixels;
    Q_EMIT changed();
}

bool PictureEditing::press(QMouseEvent& event) {
    if (drag_)
        return true;
    const bool shifted = event.modifiers() & Qt::ShiftModifier;
    if (!shifted || !document_.sceneIsCurrent())
        return shifted;
    button_ = event.button();
    const Eigen::Vector2d pixels = display_.inPixels(event.position());
    if (const auto handle = handleUnder(event.position()); handle && button_ == Qt::LeftButton) {
        begin(*handle, pixels);
        return true;
    }
    const render::Drawing drawing = display_.drawing();
    const auto picked = bodyAt(drawing, display_.sight(), pixels);
    if (!picked)
        return true;
    const scene::Body& body = drawing.scene->bodies[picked->body];
    if (button_ == Qt::LeftButton) {
        begin({render::HandleKind::position, picked->body, 0, body.initialPosition,
               body.initialPosition},
              pixels);
    } else if (button_ == Qt::MiddleButton) {
        const geometry::Pose pose =
            render::poseOf(*drawing.scene, drawing.motion.get(), picked->body, drawing.time);
        begin({render::HandleKind::orientation, picked->body, 0, pose.position, picked->point,
               (picked->point - pose.position).norm(), pose},
              pixels);
    }
    return true;
}

bool PictureEditing::move(QMouseEvent& event) {
    if (!drag_ || byKeys_)
        return drag_ != nullptr;
    drag_->move(display_.inPixels(event.position()));
    Q_EMIT changed();
    return true;
}

bool PictureEditing::release(QMouseEvent& event) {
    if (!drag_ || byKeys_ || event.button() != button_)
        return drag_ != nullptr;
    const std::unique_ptr<HandleDrag> drag = std::move(drag_);
    drag->finish();
    Q_EMIT changed();
    if (drag->moved() && !drag->answer().offers.empty())
        offerOthers(event.globalPosition().toPoint(), *drag);
    return true;
}

bool PictureEditing::doubleClick(QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !document_.sceneIsCurrent())
        return false;
    const auto handle = handleUnder(event.position());
    if (!handle)
        return false;
    if (drag_)
        drag_->cancel();
    drag_.reset();
    mark(*handle);
    openEntry();
    return true;
}

void PictureEditing::finish() {
    if (!drag_)
        return;
    const std::unique_ptr<HandleDrag> drag = std::move(drag_);
    drag->finish();
    Q_EMIT changed();
    if (byKeys_ && !drag->answer().offers.empty())
        offerOthers(display_.mapToGlobal(
                        display_.fromPixels(display_.sight().pixels(drag->place())).toPoint()),
                    *drag);
}

// It cannot be moved as it stands: what could be done instead?
void PictureEditing::offerOthers(const QPoint& global, const HandleDrag& drag) {
    QMenu menu(&display_);
    menu.addSection(drag.words());
    for (const editing::Offer& offer : drag.answer().offers) {
        QString preview;
        for (const editing::TextEdit& edit : offer.edits)
            preview +=
                (preview.isEmpty() ? "" : ", ") + QString::fromStdString(edit.text).trimmed();
        QAction* action = menu.addAction(
            tr("%1: %2").arg(QString::fromStdString(offer.label), preview.replace("&", "&&")));
        connect(action, &QAction::triggered, this, [&] {
            document_.setText(editing::applied(drag.text(), offer.edits), drag.label());
        });
    }
    menu.exec(global);
}

// --- keys ------------------------------------------------------------------------------------

void PictureEditing::mark(const render::Handle& handle) {
    mark_ = {handle.kind, handle.element, handle.part};
}

std::optional<render::Handle> PictureEditing::marked() const {
    if (mark_)
        for (const render::Handle& handle : display_.handles().handles)
            if (handle.kind == mark_->kind && handle.element == mark_->element &&
                handle.part == mark_->part && handle.movable)
                return handle;
    return std::nullopt;
}

void PictureEditing::markNext(int step) {
    std::vector<render::Handle> all;
    std::size_t at = 0;
    const auto now = marked();
    for (const render::Handle& handle : display_.handles().handles) {
        if (!handle.movable)
            continue;
        if (now && handle.kind == now->kind && handle.element == now->element &&
            handle.part == now->part)
            at = all.size();
        all.push_back(handle);
    }
    if (all.empty())
        return;
    const auto count = all.size();
    mark(all[now ? (at + count + static_cast<std::size_t>(step + static_cast<int>(count))) % count
                 : 0]);
    Q_EMIT changed();
}

bool PictureEditing::dragKey(QKeyEvent& event) {
    const double step = keyStep * display_.devicePixelRatioF();
    switch (event.key()) {
    case Qt::Key_Escape:
        drag_->cancel();
        drag_.reset();
        break;
    case Qt::Key_Z:
    case Qt::Key_X:
        drag_->push(event.key() == Qt::Key_Z ? step : -step);
        break;
    case Qt::Key_A:
        drag_->setFree(true);
        break;
    case Qt::Key_Left:
        drag_->nudge({-step, 0});
        break;
    case Qt::Key_Right:
        drag_->nudge({step, 0});
        break;
    case Qt::Key_Up:
        drag_->nudge({0, -step});
        break;
    case Qt::Key_Down:
        drag_->nudge({0, step});
        break;
    default:
        return false;
    }
    Q_EMIT changed();
    return true;
}

bool PictureEditing::keyPress(QKeyEvent& event) {
    if (drag_)
        return dragKey(event) || !byKeys_;
    const bool shifted = event.modifiers() == Qt::ShiftModifier;
    if (event.key() == Qt::Key_H && (shifted || event.modifiers() == Qt::NoModifier)) {
        markNext(shifted ? -1 : 1);
        return true;
    }
    const auto handle = marked();
    if (!handle || !document_.sceneIsCurrent())
        return false;
    const int key = event.key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        openEntry();
        return true;
    }
    const bool arrow =
        key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
    if (!(shifted && arrow) && key != Qt::Key_Z && key != Qt::Key_X)
        return false;
    begin(*handle, std::nullopt);
    return dragKey(event);
}

void PictureEditing::keyRelease(QKeyEvent& event) {
    if (!drag_ || event.isAutoRepeat())
        return;
    if (event.key() == Qt::Key_A)
        drag_->setFree(false);
    const bool pushing = (event.key() == Qt::Key_Z || event.key() == Qt::Key_X) &&
                         !(event.modifiers() & Qt::ShiftModifier);
    if (byKeys_ && (event.key() == Qt::Key_Shift || pushing))
        finish();
}

// --- exact values ----------------------------------------------------------------------------

void PictureEditing::openEntry() {
    const auto handle = marked();
    if (!handle || !document_.sceneIsCurrent())
        return;
    delete entry_;
    entry_ = new ValueEntry(document_, *handle, display_.time(), &display_);
    entry_->openAt(display_.fromPixels(display_.sight().pixels(handle->place)).toPoint());
    Q_EMIT changed();
}

// --- what is painted over the picture ---------------------------------------------------------

QString PictureEditing::words() const { return drag_ ? drag_->words() : QString(); }

void PictureEditing::paintLabels(QPainter& painter) const {
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.9);
    painter.setFont(font);
    for (const render::Handle& handle : display_.handles().handles) {
        if (handle.label.empty() || (handle.kind == render::HandleKind::spin && !handle.isArrow()))
            continue;
        const QPointF at = display_.fromPixels(display_.sight().pixels(handle.place));
        const QString text = QString::fromStdString(handle.label);
        const QRectF box = painter.boundingRect(QRectF(at + QPointF(9, -20), QSizeF(1, 1)),
                                                Qt::AlignLeft | Qt::TextDontClip, text);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(255, 255, 255, 190));
        painter.drawRoundedRect(box.adjusted(-3, -1, 3, 1), 3, 3);
        painter.setPen(toColor(render::colorOf(handle.kind)).darker(160));
        painter.drawText(box, Qt::AlignLeft | Qt::TextDontClip, text);
    }
}

void PictureEditing::paintWords(QPainter& painter, const QString& words, bool possible) const {
    const QRect space = display_.rect().adjusted(display_.width() / 3, 10, -12, -10);
    const QRect needed = painter.boundingRect(space, Qt::AlignRight | Qt::TextWordWrap, words);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 225));
    painter.drawRoundedRect(needed.adjusted(-8, -4, 8, 4), 4, 4);
    painter.setPen(possible ? QColor(30, 35, 45) : QColor(170, 30, 20));
    painter.drawText(space, Qt::AlignRight | Qt::TextWordWrap, words);
}

void PictureEditing::paint(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    paintLabels(painter);
    const bool possible = !drag_ || drag_->answer().possible();
    const auto handle = marked();
    if (drag_ || (handle && display_.hasFocus())) {
        const Vector place = drag_ ? drag_->place() : handle->place;
        painter.setPen(QPen(possible ? QColor(20, 90, 200) : QColor(190, 40, 30), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(display_.fromPixels(display_.sight().pixels(place)), 11, 11);
    }
    if (drag_)
        paintWords(painter, drag_->words(), possible);
}

} // namespace views

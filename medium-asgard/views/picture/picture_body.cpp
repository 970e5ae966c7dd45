// A picture asks for a body's size and surface, and whether it is fixed: it has no handles of
// these.
#include "picture/picture_editing.h"
#include "picture/scene_display.h"

namespace views {

bool PictureEditing::turnBody(std::size_t body, const QPointF& position, int axis) {
    const auto handle = positionOf(body);
    if (!handle || !mayChange())
        return false;
    const render::Drawing drawing = display_.drawing();
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time);
    render::Handle turned = *handle;
    turned.kind = render::HandleKind::orientation;
    turned.base = turned.place = display_.gizmo().pivotOf(body);
    turned.frame = pose;
    turned.perUnit = display_.gizmo().ringRadius(body) * display_.devicePixelRatioF() *
                     display_.sight().pixelLength(turned.base);
    button_ = Qt::LeftButton;
    take({gestures::Grasp::What::drag, turned}, display_.inPixels(position));
    hand_.setTurns(axis);
    return true;
}

bool PictureEditing::openBodyAt(const QPointF& position) {
    const auto body =
        gestures::bodyAt(display_.drawn(), display_.sight(), display_.inPixels(position));
    if (!body)
        return false;
    say({});
    hand_.cancel(); // the first of the two clicks began it
    openSize(body->body);
    return true;
}

void PictureEditing::openSize(std::size_t body) {
    if (body >= document_.shown().scene->bodies.size() || !mayChange())
        return;
    document_.select({{editing::Kind::body, body}});
    if (auto size = commands::askedSize(document_.ground(), body))
        openEntry(std::move(*size), positionOf(body)->place);
    else
        Q_EMIT shapeWanted(QString::fromStdString(document_.shown().scene->bodies[body].shape));
}

void PictureEditing::openSurface(std::size_t body) {
    if (body >= document_.shown().scene->bodies.size() || !mayChange())
        return;
    document_.select({{editing::Kind::body, body}});
    openEntry(commands::askedSurface(document_.ground(), body), positionOf(body)->place);
}

void PictureEditing::setFixed(std::size_t body, bool fixed) {
    if (body >= document_.shown().scene->bodies.size() || !mayChange())
        return;
    const scene::Body& one = document_.shown().scene->bodies[body];
    if (one.fixed == fixed)
        return;
    if (const std::string why = commands::whyNotFixed(*document_.shown().scene, body); !why.empty())
        return say(QString::fromStdString(why));
    commands::AskedValue asked = commands::askedFixed(document_.ground(), body);
    const double value = fixed ? 1 : 0;
    const editing::Answer answer = asked.answer({value});
    if (answer.possible())
        return document_.setText(text::applied(asked.text, answer.edits),
                                 QString::fromStdString(asked.label));
    editing::Wish wish; // what makes it so is said, and what can be done
    wish.values = {value};
    openEntry(std::move(asked), positionOf(body)->place);
    entry_->propose({wish});
}

} // namespace views

#include "scenelist/element_label.h"

#include <QObject>

#include <algorithm>

namespace views {

using editing::Element;
using editing::Kind;

namespace {

QString toText(const std::string& text) { return QString::fromStdString(text); }

QString forceOn(const scene::Force& force) {
    const QString body = toText(force.body);
    if (std::holds_alternative<scene::GravitationalForce>(force.kind))
        return QObject::tr("weight of %1").arg(body);
    return force.couple ? QObject::tr("torque on %1").arg(body)
                        : QObject::tr("force on %1").arg(body);
}

QString endsOf(const scene::Link& link) {
    const QString first = toText(link.first.body);
    if (const auto* end = std::get_if<scene::BodyEnd>(&link.second))
        return first + QStringLiteral(" – ") + toText(end->body);
    if (const auto* end = std::get_if<scene::TrajectoryEnd>(&link.second))
        return first + QStringLiteral(" – ") + toText(end->trajectory);
    return QObject::tr("%1 – a point").arg(first);
}

} // namespace

QString labelOf(const scene::Scene& scene, const Element& element) {
    const std::string name = editing::nameOf(scene, element);
    if (!name.empty())
        return toText(name);
    switch (element.kind) {
    case Kind::force:
        return forceOn(scene.forces[element.index]);
    case Kind::link:
        return endsOf(scene.links[element.index]);
    case Kind::simulator:
        return QObject::tr("simulator");
    case Kind::contact:
        return toText(scene.contacts[element.index].body1) + QStringLiteral(" – ") +
               toText(scene.contacts[element.index].body2);
    case Kind::constraint:
        return QObject::tr("%1 by %2")
            .arg(toText(scene.constraints[element.index].body),
                 toText(scene.constraints[element.index].trajectory));
    default:
        return toText(editing::describe(scene, element));
    }
}

QString groupOf(const scene::Scene& scene, const Element& element) {
    static const std::pair<Kind, const char*> groups[] = {
        {Kind::simulator, QT_TRANSLATE_NOOP("QObject", "Simulator")},
        {Kind::shapeSet, QT_TRANSLATE_NOOP("QObject", "Shapes")},
        {Kind::body, QT_TRANSLATE_NOOP("QObject", "Bodies")},
        {Kind::force, QT_TRANSLATE_NOOP("QObject", "Forces")},
        {Kind::link, QT_TRANSLATE_NOOP("QObject", "Links")},
        {Kind::joint, QT_TRANSLATE_NOOP("QObject", "Joints")},
        {Kind::gear, QT_TRANSLATE_NOOP("QObject", "Gears")},
        {Kind::rope, QT_TRANSLATE_NOOP("QObject", "Ropes")},
        {Kind::contact, QT_TRANSLATE_NOOP("QObject", "Contacts")},
        {Kind::trajectory, QT_TRANSLATE_NOOP("QObject", "Trajectories")},
        {Kind::constraint, QT_TRANSLATE_NOOP("QObject", "Constraints")},
        {Kind::light, QT_TRANSLATE_NOOP("QObject", "Lights")},
        {Kind::view, QT_TRANSLATE_NOOP("QObject", "Views")},
        {Kind::parameter, QT_TRANSLATE_NOOP("QObject", "Parameters")},
        {Kind::plot, QT_TRANSLATE_NOOP("QObject", "Plots")},
    };
    if (editing::commandOf(scene, element) == "spring")
        return QObject::tr("Springs");
    const auto* group =
        std::ranges::find(groups, element.kind, &std::pair<Kind, const char*>::first);
    return QObject::tr(group->second);
}

std::optional<QColor> colorOf(const scene::Scene& scene, const Element& element) {
    std::optional<scene::Color> color;
    std::string shape;
    if (element.kind == Kind::body) {
        color = scene.bodies[element.index].appearance.color;
        shape = scene.bodies[element.index].shape;
    } else if (element.kind == Kind::shapeSet) {
        shape = scene.shapeSets[element.index].name;
    } else {
        return std::nullopt;
    }
    for (const scene::ShapeSet& set : scene.shapeSets)
        if (!color && set.name == shape)
            color = set.appearance.color;
    const scene::Color shown = color.value_or(scene::Color());
    return QColor::fromRgbF(static_cast<float>(shown.red), static_cast<float>(shown.green),
                            static_cast<float>(shown.blue));
}

} // namespace views

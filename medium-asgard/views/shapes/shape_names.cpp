#include "shapes/shape_names.h"

#include "element_edits/creation.h"
#include "point_edits/shape_edit.h"

#include <QRegularExpression>

#include <algorithm>
#include <set>

namespace views {

namespace {

bool isTaken(const SceneDocument& document, const QString& name) {
    return std::ranges::any_of(document.shown().scene->shapeSets, [&](const auto& one) {
        return QString::fromStdString(one.name) == name;
    });
}

} // namespace

QString faultOfShapeName(const SceneDocument& document, const QString& name) {
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z_][A-Za-z_0-9]*$"));
    if (!plain.match(name).hasMatch())
        return SceneDocument::tr(
            "A name has letters, digits and underscores, and begins with no digit.");
    return isTaken(document, name) ? SceneDocument::tr("There is a shape %1 already.").arg(name)
                                   : QString();
}

QString makeShape(SceneDocument& document, const QString& name,
                  const std::vector<scene::Part>& parts, const QString& label) {
    if (QString fault = faultOfShapeName(document, name); !fault.isEmpty())
        return fault;
    if (QString fault = document.whyNotCurrent(); !fault.isEmpty())
        return fault;
    editing::NewElement element;
    element.kind = editing::Kind::shapeSet;
    element.name = name.toStdString();
    element.words = {"-desc", editing::descriptionText(parts)};
    const std::string& text = document.text();
    document.setText(
        text::applied(text, editing::created(text, *document.shown().scene, {element})), label);
    return {};
}

QString renameShape(SceneDocument& document, std::size_t shapeSet, const QString& name) {
    if (QString fault = faultOfShapeName(document, name); !fault.isEmpty())
        return fault;
    if (QString fault = document.whyNotCurrent(); !fault.isEmpty())
        return fault;
    const scene::Scene& scene = *document.shown().scene;
    const editing::Answer answer =
        editing::renamed(document.text(), scene, shapeSet, name.toStdString());
    if (!answer.possible())
        return QString::fromStdString(answer.reason);
    const QString before = QString::fromStdString(scene.shapeSets[shapeSet].name);
    document.setText(text::applied(document.text(), answer.edits),
                     SceneDocument::tr("Rename %1 to %2").arg(before, name));
    return {};
}

QString unusedShapeName(const SceneDocument& document, const QString& wish) {
    QString name;
    for (const QChar c : wish)
        name += c.unicode() < 128 && c.isLetterOrNumber() ? c : QLatin1Char('_');
    if (!name.isEmpty() && name[0].isDigit())
        name.prepend(QLatin1Char('_'));
    if (name.isEmpty())
        return QString::fromStdString(editing::unusedName(document.text(), *document.shown().scene,
                                                          editing::Kind::shapeSet, "shape"));
    const QString stem = name;
    for (int k = 2; isTaken(document, name); ++k)
        name = stem + QString::number(k);
    return name;
}

QString selectedShape(const SceneDocument& document) {
    const scene::Scene& scene = *document.shown().scene;
    std::set<std::string> names;
    for (const editing::Element& one : document.selected())
        if (one.kind == editing::Kind::body && one.index < scene.bodies.size())
            names.insert(scene.bodies[one.index].shape);
        else if (one.kind == editing::Kind::shapeSet && one.index < scene.shapeSets.size())
            names.insert(scene.shapeSets[one.index].name);
    return names.size() == 1 ? QString::fromStdString(*names.begin()) : QString();
}

} // namespace views

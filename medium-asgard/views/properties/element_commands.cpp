#include "properties/element_commands.h"

#include "editing/number_text.h"
#include "element_edits/copying.h"
#include "element_edits/renaming.h"
#include "framing/extent.h"

#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

namespace views {

namespace {

// A little more than the bodies of the scene with those names are wide together, along x.
geometry::Vector besideThem(const scene::Scene& scene, const std::set<std::string>& names) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const scene::Body& body : scene.bodies) {
        if (!names.contains(body.name))
            continue;
        for (const render::Ball& ball : render::outlineOf(scene, body)) {
            const double x = (body.initialPosition + body.initialAttitude * ball.center).x();
            least = std::min(least, x - ball.radius);
            most = std::max(most, x + ball.radius);
        }
    }
    const double width = std::max(0.0, most - least);
    const double step = editing::decimalStep(width);
    return {width > 0 ? editing::roundedTo(1.1 * width, step / 10) : 1, 0, 0};
}

} // namespace

ElementCommands::ElementCommands(SceneDocument& document, QObject* parent)
    : QObject(parent), document_(document), trial_(document) {}

std::optional<std::string> ElementCommands::copied(const QString& nothing) {
    std::optional<std::string> commands;
    if (document_.selected().empty()) {
        Q_EMIT refused(nothing);
    } else if (!document_.sceneIsCurrent()) {
        Q_EMIT refused(document_.whyNotCurrent());
    } else {
        const editing::Copied copy =
            editing::copied(document_.text(), *document_.shown().scene, document_.selected());
        if (copy.possible())
            commands = copy.commands;
        else
            Q_EMIT refused(QString::fromStdString(copy.reason));
    }
    return commands;
}

bool ElementCommands::copy() {
    const auto commands = copied(tr("Nothing is selected to be copied."));
    if (commands)
        QGuiApplication::clipboard()->setText(QString::fromStdString(*commands));
    return commands.has_value();
}

void ElementCommands::paste() {
    put(QGuiApplication::clipboard()->text().toStdString(), tr("Paste"));
}

void ElementCommands::duplicate() {
    if (const auto commands = copied(tr("Nothing is selected to be duplicated.")))
        put(*commands, tr("Duplicate"));
}

void ElementCommands::put(const std::string& commands, const QString& label) {
    if (!document_.sceneIsCurrent() && !document_.text().empty())
        return Q_EMIT refused(document_.whyNotCurrent());
    const scene::Scene& scene = *document_.shown().scene;
    const editing::Pasted paste = editing::pasted(document_.text(), scene, commands,
                                                  besideThem(scene, editing::bodiesOf(commands)));
    if (!paste.possible())
        return Q_EMIT refused(QString::fromStdString(paste.reason));
    // Bodies alone, where there are any: one goes on with them.
    std::vector<editing::Element> added = paste.added;
    const auto isBody = [](const editing::Element& one) { return one.kind == editing::Kind::body; };
    if (std::ranges::any_of(added, isBody))
        std::erase_if(added, std::not_fn(isBody));
    trial_.start(text::applied(document_.text(), paste.edits), label,
                 [this, added](const QString& why) {
                     if (!why.isEmpty())
                         return Q_EMIT refused(why);
                     document_.select(added);
                 });
}

void ElementCommands::rename(const editing::Element& element, const QString& name,
                             Trial::Told told) {
    if (!document_.sceneIsCurrent())
        return told(document_.whyNotCurrent());
    const scene::Scene& scene = *document_.shown().scene;
    const QString before = QString::fromStdString(editing::nameOf(scene, element));
    const editing::Answer answer =
        editing::renamed(document_.text(), scene, element, name.toStdString());
    if (!answer.possible())
        return told(QString::fromStdString(answer.reason));
    trial_.start(
        text::applied(document_.text(), answer.edits), tr("Rename %1").arg(before),
        [this, selected = document_.selected(), told = std::move(told)](const QString& why) {
            if (why.isEmpty()) // it has its place still, and another name
                document_.select(selected);
            told(why);
        });
}

} // namespace views

#include "properties/element_commands.h"

#include "element_edits/renaming.h"
#include "gestures/copies.h"

#include <QClipboard>
#include <QGuiApplication>

namespace views {

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
    editing::Pasted paste = gestures::pastedBeside(document_.text(), scene, commands);
    if (!paste.possible())
        return Q_EMIT refused(QString::fromStdString(paste.reason));
    trial_.start(text::applied(document_.text(), paste.edits), label,
                 [this, elements = std::move(paste.added)](const QString& why) {
                     if (!why.isEmpty())
                         return Q_EMIT refused(why);
                     document_.select(elements);
                     Q_EMIT added(elements);
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

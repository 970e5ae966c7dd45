#include "viewers/scene_files.h"

#include "frame/typed_field.h"
#include "plain/plain.h"
#include "workbench/recent_files.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <QScopedValueRollback>

#include <utility>

namespace views {

namespace {

QString sceneFiles() { return SceneFiles::tr("Scenes (*.al);;All files (*)"); }

} // namespace

SceneFiles::SceneFiles(SceneDocument& document, Drafts drafts, QObject* parent)
    : QObject(parent), document_(document), drafts_(std::move(drafts)),
      exports_(new Exports(document, this)) {}

bool SceneFiles::newScene(const std::string& text, const QString& name) {
    if (!mayLeave())
        return false;
    document_.reset(text, name);
    return true;
}

bool SceneFiles::open(const QString& path) {
    if (!mayLeave())
        return false;
    if (const QString fault = document_.open(path); !fault.isEmpty()) {
        plain::Message::tell(QMessageBox::Warning, QApplication::activeWindow(), tr("Open"), fault);
        return false;
    }
    rememberFile(path);
    return true;
}

bool SceneFiles::open() {
    const QString path =
        QFileDialog::getOpenFileName(QApplication::activeWindow(), tr("Open a scene"),
                                     QFileInfo(document_.path()).absolutePath(), sceneFiles());
    return !path.isEmpty() && open(path);
}

bool SceneFiles::saveTo(const QString& path, QPointer<QWidget> from) {
    (void)TypedField::settleAll(document_); // a field says why its value is not taken
    if (!drafts_.takeDrafts())
        return false;
    files::SaveOptions options;
    for (;;) {
        const files::SaveResult result = document_.save(path, options);
        if (result) {
            rememberFile(path);
            return true;
        }
        const QString sentence = QString::fromStdString(result.sentence);
        if (result.refusal == files::Refusal::none) {
            plain::Message::tell(QMessageBox::Warning, from, tr("Save"), sentence);
            return false;
        }
        if (plain::Message::ask(QMessageBox::Warning, from, tr("Save"),
                                tr("%1\n\nSave it all the same?").arg(sentence),
                                QMessageBox::Yes | QMessageBox::No,
                                QMessageBox::No) != QMessageBox::Yes)
            return false;
        options.evenChanged |= result.refusal == files::Refusal::changed;
        options.evenLinked |= result.refusal == files::Refusal::linked;
    }
}

bool SceneFiles::save() {
    return document_.path().isEmpty() ? saveAs()
                                      : saveTo(document_.path(), QApplication::activeWindow());
}

bool SceneFiles::saveAs() {
    const QPointer<QWidget> asked = QApplication::activeWindow();
    QFileDialog dialog(asked, tr("Save the Scene"), QFileInfo(document_.path()).absolutePath(),
                       sceneFiles());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("al"));
    dialog.selectFile(document_.path().isEmpty() ? QStringLiteral("scene.al")
                                                 : QFileInfo(document_.path()).fileName());
    const bool saved =
        dialog.exec() == QDialog::Accepted && saveTo(dialog.selectedFiles().front(), asked);
    if (asked)
        asked->activateWindow();
    return saved;
}

// While it waits for a value, and while it asks, windows may close and commands may come.
bool SceneFiles::mayLeave() {
    if (isLeaving_)
        return false;
    const QScopedValueRollback leaving(isLeaving_, true);
    const QPointer<QWidget> from = QApplication::activeWindow();
    if (!TypedField::maySettle(document_))
        return false;
    if (exports_->isBusy() &&
        plain::Message::ask(QMessageBox::Question, from, tr("Export"),
                            tr("An export is still being written. End it, unfinished?"),
                            QMessageBox::Yes | QMessageBox::No) != QMessageBox::Yes)
        return false;
    if (!drafts_.settleDrafts())
        return false;
    if (!document_.isModified())
        return true;
    const auto answer = plain::Message::ask(
        QMessageBox::Question, from, tr("Asgard"),
        tr("%1 was changed and not saved.").arg(document_.name()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return save();
    return answer == QMessageBox::Discard;
}

} // namespace views

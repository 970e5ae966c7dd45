#include "filing/saving.h"

#include "filing/choosing.h"
#include "filing/templates.h"
#include "panes/asked_save.h"
#include "plain/plain.h"
#include "session/presented.h"
#include "text/difference.h"

#include <QDir>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace filing {

Saving::Saving(session::OpenDocument& document, QWidget& window)
    : QObject(&window), document_(document), window_(window) {}

bool Saving::saveBy(const std::function<files::SaveResult(files::SaveOptions)>& saving) {
    const bool isSaved = panes::saveAsking(&window_, tr("Save"), saving);
    if (isSaved)
        Q_EMIT said(tr("Saved"));
    return isSaved;
}

bool Saving::save() {
    switch (askAboutDrafts(tr("Save"), tr("&Update and Save"), tr("Save &Without It"))) {
    case Drafts::stay:
        return false;
    case Drafts::update:
        updateDrafts([this] { saveNow(); });
        return false;
    case Drafts::none:
    case Drafts::leave:
        break;
    }
    return saveNow();
}

bool Saving::saveNow() {
    document::Document& of = document_.document();
    if (of.fileName().isEmpty())
        return saveAs();
    return saveBy([&of](files::SaveOptions options) { return of.save(options); });
}

bool Saving::saveAs() {
    document::Document& of = document_.document();
    const QString proposed =
        !of.fileName().isEmpty()
            ? of.fileName()
            : folderUsedLast() + '/' + fileNameOf(document_.presented({})->title()) + ".ens";
    const QString file =
        askForFile(&window_, tr("Save As"), proposed, documentFilter(), QStringLiteral("ens"));
    if (file.isEmpty())
        return false;
    const bool saved =
        saveBy([&of, file](files::SaveOptions options) { return of.saveAs(file, options); });
    if (saved)
        Q_EMIT savedAs(file);
    return saved;
}

void Saving::bringBackup() {
    document::Document& of = document_.document();
    const files::ReadFile backup = of.readBackup();
    if (!backup.read) {
        plain::Message::tell(QMessageBox::Critical, &window_, tr("Version Before the Last Save"),
                             tr("The version before the last save cannot be read: %1.")
                                 .arg(QString::fromStdString(backup.reason)));
        return;
    }
    const text::Edits edits = text::editsBetween(of.bytes(), backup.bytes);
    if (edits.empty()) {
        Q_EMIT said(tr("The document is as it was before the last save"));
        return;
    }
    of.edit(edits, tr("Version Before the Last Save"));
    Q_EMIT said(tr("This is the version before the last save. Undo goes back; Save keeps it."));
}

// The document itself stays what and where it is.
void Saving::saveAsTemplate(const QString& proposed) {
    QInputDialog dialog(&window_);
    dialog.setObjectName("templateDialog");
    dialog.setWindowTitle(tr("Save as a Template"));
    dialog.setLabelText(tr("Name of the template in File > New:"));
    dialog.setTextValue(proposed);
    if (dialog.exec() != QDialog::Accepted)
        return;
    QString name = dialog.textValue().simplified();
    name.remove('/');
    if (name.isEmpty() || name.startsWith('.')) {
        plain::Message::tell(QMessageBox::Warning, &window_, tr("Save as a Template"),
                             tr("A template's name begins with a letter or a digit."));
        return;
    }
    QDir().mkpath(templateFolder());
    const QString file = templateFolder() + '/' + name + QStringLiteral(".ens");
    document::Document copy(document_.document().bytes());
    if (saveBy([&](files::SaveOptions options) { return copy.saveAs(file, options); }))
        Q_EMIT said(tr("Saved %1: File > New > %2 begins with it").arg(file, name));
}

// Text that was typed in a window of a medium and is no change of the document yet goes with its
// process.
Saving::Drafts Saving::askAboutDrafts(const QString& title, const QString& update,
                                      const QString& leave) {
    const QStringList where = document_.drafts();
    if (where.isEmpty())
        return Drafts::none;
    plain::Message box(QMessageBox::Warning, title,
                       tr("Text that you typed in a window of %1 is not yet in the document.")
                           .arg(where.join(tr(" and "))),
                       QMessageBox::Cancel, &window_);
    if (document_.takesDrafts())
        box.addButton(QMessageBox::Apply)->setText(plain::ours(update));
    box.addButton(QMessageBox::Discard)->setText(plain::ours(leave));
    box.setDefaultButton(QMessageBox::Cancel);
    switch (box.exec()) {
    case QMessageBox::Apply:
        return Drafts::update;
    case QMessageBox::Discard:
        return Drafts::leave;
    default:
        return Drafts::stay;
    }
}

void Saving::updateDrafts(std::function<void()> then) {
    constexpr int longestMs = 10'000;
    auto* waiting = new QTimer(this); // and what it waits for, which goes with it
    waiting->setSingleShot(true);
    const auto look = [this, waiting, then = std::move(then)] {
        if (!document_.drafts().isEmpty())
            return;
        waiting->stop();
        waiting->deleteLater();
        // Not in the medium's own call.
        QTimer::singleShot(0, this, then);
    };
    connect(&document_, &session::OpenDocument::draftsChanged, waiting, look);
    connect(waiting, &QTimer::timeout, this, [this, waiting] {
        waiting->deleteLater();
        plain::Message::tell(QMessageBox::Warning, &window_, tr("Update"),
                             tr("%1 did not take the typed text. It is still in its window.")
                                 .arg(document_.drafts().join(tr(" and "))));
    });
    waiting->start(longestMs);
    document_.takeDrafts();
}

bool Saving::mayClose(const QString& title) {
    const Drafts drafts = askAboutDrafts(tr("Close"), tr("&Update"), tr("Close &Without It"));
    if (drafts == Drafts::update)
        updateDrafts([this] { Q_EMIT mayCloseNow(); });
    if (drafts == Drafts::update || drafts == Drafts::stay)
        return false;
    if (document_.document().isModified()) {
        const auto answer = plain::Message::ask(
            QMessageBox::Question, &window_, tr("Close"),
            tr("%1 has changes that are not saved.").arg(title),
            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
        if (answer == QMessageBox::Cancel || (answer == QMessageBox::Save && !saveNow()))
            return false;
    }
    if (document_.unsaved())
        document_.unsaved()->giveUp();
    return true;
}

} // namespace filing

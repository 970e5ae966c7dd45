#include "dialogs/recovery.h"

#include "plain/plain.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QPushButton>

namespace dialogs {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("dialogs::Recovery", text); }

QString pathOf(const files::Kept& kept) { return QFile::decodeName(kept.file.path.c_str()); }

} // namespace

QString questionAbout(const files::Kept& kept, const Asking& asking, const QDateTime& now) {
    const QDateTime at = QDateTime::fromSecsSinceEpoch(kept.at).toLocalTime();
    const QLocale locale;
    const QString time = at.toString(QStringLiteral("HH:mm"));
    const QString when = at.date() == now.date()
                             ? tr("at %1").arg(time)
                             : tr("on %1 at %2").arg(locale.toString(at.date()), time);
    const QString path = pathOf(kept);
    return tr("%1 was not saved before %2 stopped %3. Recover it?")
        .arg(path.isEmpty() ? asking.unnamed : QFileInfo(path).fileName(), asking.program, when);
}

QString adviceAbout(const files::Kept& kept, const Asking& asking) {
    QString advice;
    switch (files::compareFile(files::FileSystem::real(), kept.file)) {
    case files::FileState::changed:
        advice = tr("Another program has changed its file since. The file stays as it is, and "
                    "saving asks before it replaces it.");
        break;
    case files::FileState::removed:
        advice = tr("Its file is no longer there: saving writes it again.");
        break;
    case files::FileState::unchanged:
        advice = tr("Its file stays as it is until you save.");
        break;
    case files::FileState::noFile:
        advice = tr("It has no file yet.");
        break;
    }
    return kept.drafts.empty() ? advice : advice + ' ' + asking.drafts;
}

Recovery askAbout(QWidget* over, const files::Kept& kept, const Asking& asking) {
    plain::Message box(QMessageBox::Question, tr("Recover"),
                       questionAbout(kept, asking, QDateTime::currentDateTime()),
                       QMessageBox::NoButton, over);
    box.setObjectName(QStringLiteral("recover"));
    box.setSecondText(adviceAbout(kept, asking));
    box.setToolTip(plain::tip(pathOf(kept)));
    QPushButton* recover = box.addButton(tr("&Recover"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    QPushButton* later = box.addButton(tr("&Later"), QMessageBox::RejectRole);
    discard->setToolTip(plain::tip(tr("The unsaved text is deleted.")));
    later->setToolTip(plain::tip(tr("The next start asks again.")));
    box.setDefaultButton(later);
    box.setEscapeButton(later);
    box.exec();
    if (box.clickedButton() == recover)
        return Recovery::recover;
    return box.clickedButton() == discard ? Recovery::discard : Recovery::later;
}

} // namespace dialogs

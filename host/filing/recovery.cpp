#include "filing/recovery.h"

#include "plain/plain.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QPushButton>

namespace filing {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("filing::Recovery", text); }

QString nameOf(const files::Kept& kept, const QString& title) {
    const QString path = QFile::decodeName(kept.file.path.c_str());
    if (!path.isEmpty())
        return QFileInfo(path).fileName();
    return title.isEmpty() ? tr("A document without a name") : tr("“%1”").arg(title);
}

} // namespace

QString questionAbout(const files::Kept& kept, const QString& title, const QDateTime& now) {
    const QDateTime at = QDateTime::fromSecsSinceEpoch(kept.at).toLocalTime();
    const QLocale locale;
    const QString time = at.toString(QStringLiteral("HH:mm"));
    const QString when = at.date() == now.date()
                             ? tr("at %1").arg(time)
                             : tr("on %1 at %2").arg(locale.toString(at.date()), time);
    return tr("%1 was not saved before Ensemble stopped %2. Open the recovered text?")
        .arg(nameOf(kept, title), when);
}

QString adviceAbout(const files::Kept& kept) {
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
    if (!kept.drafts.empty())
        advice += tr(" Windows of its figures open again, with what was typed in them.");
    return advice;
}

Answer askAbout(QWidget* over, const files::Kept& kept, const QString& title) {
    plain::Message box(QMessageBox::Question, tr("Recover"),
                       questionAbout(kept, title, QDateTime::currentDateTime()),
                       QMessageBox::NoButton, over);
    box.setObjectName(QStringLiteral("recover"));
    box.setSecondText(adviceAbout(kept));
    box.setToolTip(plain::tip(QFile::decodeName(kept.file.path.c_str())));
    QPushButton* open = box.addButton(tr("&Open"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    QPushButton* later = box.addButton(tr("&Later"), QMessageBox::RejectRole);
    discard->setToolTip(plain::tip(tr("The recovered text is deleted.")));
    later->setToolTip(plain::tip(tr("The next start asks again.")));
    box.setDefaultButton(open);
    box.setEscapeButton(later);
    box.exec();
    if (box.clickedButton() == open)
        return Answer::open;
    return box.clickedButton() == discard ? Answer::discard : Answer::later;
}

void tell(QWidget* over, const QString& sentence) {
    auto* box = new plain::Message(QMessageBox::Warning, tr("Unsaved Changes"), sentence,
                                   QMessageBox::Ok, over);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

} // namespace filing

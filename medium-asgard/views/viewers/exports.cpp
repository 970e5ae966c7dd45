#include "viewers/exports.h"

#include "panels/status_panel.h"
#include "plain/plain.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <array>

namespace views {

Exports::Exports(SceneDocument& document, QObject* parent) : QObject(parent), document_(document) {}

Exports::~Exports() { delete progress_; }

void Exports::ask() {
    constexpr std::array formats{ExportFormat::png, ExportFormat::ppm, ExportFormat::film,
                                 ExportFormat::table};
    QStringList filters;
    for (const ExportFormat format : formats)
        filters += labelOf(format);
    const QString folder = QFileInfo(document_.path()).absolutePath();
    QFileDialog dialog(QApplication::activeWindow(), tr("Export"), folder);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    dialog.selectFile(QFileInfo(document_.name()).completeBaseName());
    // The name gets its ending first; write() asks about that one.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const auto which = std::max<qsizetype>(0, filters.indexOf(dialog.selectedNameFilter()));
    write(dialog.selectedFiles().front(), formats[static_cast<std::size_t>(which)]);
}

void Exports::write(const QString& asked, ExportFormat chosen) {
    const ExportFormat format = formatOf(asked, chosen);
    if (progress_)
        return Q_EMIT says(tr("Another export is still being written."));
    std::optional<ToExport> what = pictured ? pictured() : std::nullopt;
    if (!what && format != ExportFormat::table) {
        plain::Message::tell(
            QMessageBox::Information, QApplication::activeWindow(), tr("Export"),
            tr("Open a graphical viewer first: the export draws what that viewer shows."));
        return;
    }
    if (!what)
        what.emplace().shown = document_.shown();
    const double pictures = format == ExportFormat::film ? filmPictures(what->shown) : 1;
    if (pictures > mostPictures)
        return Q_EMIT says(tr("%1 pictures are more than %2: let the motion finish earlier.")
                               .arg(pictures, 0, 'g', 3)
                               .arg(mostPictures));
    const QString path = withEnding(asked, format);
    if (isMotionMeant(what->shown, format) && mayWrite(path, format))
        begin(std::move(*what), path, format);
}

bool Exports::isAgreed(const QString& question) {
    return agrees ? agrees(question)
                  : plain::Message::ask(QMessageBox::Question, QApplication::activeWindow(),
                                        tr("Export"), question,
                                        QMessageBox::Yes | QMessageBox::No) == QMessageBox::Yes;
}

bool Exports::mayWrite(const QString& path, ExportFormat format) {
    if (format == ExportFormat::film) {
        const QDir folder(path);
        return !folder.exists() || folder.isEmpty() ||
               isAgreed(tr("%1 is not empty. Pictures there with the same names (00001.png, ...) "
                           "are overwritten, all others stay. Go on?")
                            .arg(QDir::toNativeSeparators(path)));
    }
    return !QFileInfo::exists(path) ||
           isAgreed(tr("%1 exists. Overwrite it?").arg(QDir::toNativeSeparators(path)));
}

bool Exports::isMotionMeant(const Shown& shown, ExportFormat format) {
    if (format != ExportFormat::film && format != ExportFormat::table)
        return true;
    if (!shown.motion) {
        Q_EMIT says(tr("There is no motion yet."));
        return false;
    }
    if (document_.motionIsStale())
        return isAgreed(tr("The motion that is shown is that of an earlier scene (F5 computes "
                           "it again). Export it all the same?"));
    const auto& motion = shown.motion;
    if (!(motion->computed() < motion->finish()))
        return true;
    const double length = motion->finish() - motion->start();
    return isAgreed(
        tr("Of the motion %1 of %2 are computed. Export these?")
            .arg(timeText(motion->computed() - motion->start(), length), timeText(length, length)));
}

void Exports::begin(ToExport what, const QString& path, ExportFormat format) {
    // Of no window: it goes on when the one in which it was asked for is closed.
    auto* dialog = new QProgressDialog(tr("Exporting…"), tr("Cancel"), 0, 1);
    dialog->setAttribute(Qt::WA_QuitOnClose, false);
    if (const QWidget* from = QApplication::activeWindow())
        dialog->move(from->geometry().center() - dialog->rect().center());
    progress_ = dialog;
    dialog->setMinimumDuration(500);
    dialog->setAutoClose(false);
    dialog->setAutoReset(false);
    auto* exporting = new Exporting(std::move(what), path, format);
    exporting->setParent(dialog);
    dialog->setMaximum(exporting->pictures() + 1);
    connect(exporting, &Exporting::progressed, dialog, &QProgressDialog::setValue);
    connect(dialog, &QProgressDialog::canceled, exporting, &Exporting::cancel);
    // What is told after the dialog went is told to nobody.
    const QString native = QDir::toNativeSeparators(path);
    const QString done = format == ExportFormat::film
                             ? tr("%1 pictures are in %2.").arg(exporting->pictures()).arg(native)
                             : tr("%1 is written.").arg(native);
    connect(exporting, &Exporting::finished, dialog, [=, this](const QString& fault) {
        const bool cancelled = dialog->wasCanceled();
        progress_.clear();
        dialog->hide();
        dialog->deleteLater();
        Q_EMIT says(!fault.isEmpty() ? fault : cancelled ? tr("The export was cancelled.") : done);
        if (!fault.isEmpty() && !agrees)
            plain::Message::tell(QMessageBox::Warning, QApplication::activeWindow(), tr("Export"),
                                 fault);
    });
    exporting->start();
}

} // namespace views

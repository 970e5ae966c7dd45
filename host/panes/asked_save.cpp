#include "panes/asked_save.h"

#include "plain/plain.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace panes {

bool saveAsking(QWidget* over, const QString& title,
                const std::function<files::SaveResult(files::SaveOptions)>& saving) {
    files::SaveOptions options;
    for (;;) {
        const files::SaveResult result = saving(options);
        const QString sentence = QString::fromStdString(result.sentence);
        if (result.saved)
            return true;
        if (result.refusal == files::Refusal::none) {
            plain::Message::tell(QMessageBox::Critical, over, title, sentence);
            return false;
        }
        const auto answer = plain::Message::ask(
            QMessageBox::Warning, over, title,
            QCoreApplication::translate("panes", "%1\n\nSave it all the same?").arg(sentence),
            QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
        if (answer != QMessageBox::Yes)
            return false;
        options.evenBroken |= result.refusal == files::Refusal::broken;
        options.evenChanged |= result.refusal == files::Refusal::changed;
        options.evenLinked |= result.refusal == files::Refusal::linked;
    }
}

} // namespace panes

#include "workbench/autosave.h"

#include "plain/plain.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QPushButton>

namespace views {

namespace {

const std::string draftsKey = "windows";
constexpr int lookEveryMs = 1000;

QString pathOf(const files::Kept& kept) { return QFile::decodeName(kept.file.path.c_str()); }

QString sceneOf(const files::Kept& kept) {
    const QString path = pathOf(kept);
    return path.isEmpty() ? Autosave::tr("a scene that was never saved")
                          : QFileInfo(path).fileName();
}

// What is to be known for the answer.
QString adviceAbout(const files::Kept& kept) {
    switch (files::compareFile(files::FileSystem::real(), kept.file)) {
    case files::FileState::changed:
        return Autosave::tr(" Another program has changed the file since; saving asks.");
    case files::FileState::removed:
        return Autosave::tr(" The file is no longer there.");
    case files::FileState::unchanged:
    case files::FileState::noFile:
        break;
    }
    return {};
}

QMessageBox::StandardButton ask(QWidget* over, const files::Kept& kept) {
    const QDateTime at = QDateTime::fromSecsSinceEpoch(kept.at).toLocalTime();
    plain::Message box(QMessageBox::Question, Autosave::tr("Recover"),
                       Autosave::tr("Changes to %1 were not saved.").arg(sceneOf(kept)),
                       QMessageBox::NoButton, over);
    box.setSecondText(Autosave::tr("Asgard ended on %1, before they were saved.%2 Recover them?")
                          .arg(QLocale().toString(at, QLocale::ShortFormat), adviceAbout(kept)));
    QPushButton* recover = box.addButton(Autosave::tr("&Recover"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(Autosave::tr("&Discard"), QMessageBox::DestructiveRole);
    QPushButton* later = box.addButton(Autosave::tr("&Later"), QMessageBox::RejectRole);
    box.setDefaultButton(later); // a Return that was meant for something else loses nothing
    box.setEscapeButton(later);
    box.exec();
    if (box.clickedButton() == recover)
        return QMessageBox::Yes;
    return box.clickedButton() == discard ? QMessageBox::Discard : QMessageBox::Cancel;
}

} // namespace

Autosave::Autosave(SceneDocument& document, const std::string& folder, KeptDrafts drafts)
    : document_(document), drafts_(std::move(drafts)),
      writer_(files::FileSystem::real(), folder, [this](const std::string& sentence) {
          Q_EMIT failed(QString::fromStdString(sentence)); // queued: the receiver has its thread
      }) {
    look_.setInterval(lookEveryMs);
    connect(&look_, &QTimer::timeout, this, &Autosave::lookAtDrafts);
    connect(&document_, &SceneDocument::nameChanged, this, &Autosave::changed);
}

Autosave::~Autosave() { writer_.forget(); }

// A text that changed, or became the file's.
void Autosave::changed() {
    if (recovering_)
        return;
    if (!document_.isModified() && kept_.empty())
        return writer_.forget();
    files::Kept kept{.file = document_.knownFile(), .text = document_.text()};
    if (!kept_.empty())
        kept.drafts[draftsKey] = kept_;
    writer_.keep(std::move(kept));
}

void Autosave::lookAtDrafts() {
    std::string now = drafts_.state();
    if (now.empty())
        look_.stop();
    else if (!look_.isActive())
        look_.start();
    if (now == kept_)
        return;
    kept_ = std::move(now);
    changed();
}

void Autosave::recover(files::LeftBehind left) {
    const auto drafts = left.kept.drafts.find(draftsKey);
    const std::string state = drafts == left.kept.drafts.end() ? std::string() : drafts->second;
    recovering_ = true; // the file is opened first, and that would be all there is to keep
    document_.recover(left.kept.file, left.kept.text);
    recovering_ = false;
    kept_ = state;
    writer_.adopt(std::move(left.place));
    changed();
    if (!state.empty())
        drafts_.restore(state);
    lookAtDrafts();
}

bool offerRecovery(QWidget* over, Autosave& autosave, const std::string& folder,
                   const QString& scene) {
    files::AllLeft all = files::leftBehind(files::FileSystem::real(), folder);
    for (const std::string& fault : all.faults)
        plain::Message::tell(QMessageBox::Warning, over, Autosave::tr("Recover"),
                             QString::fromStdString(fault));
    for (files::LeftBehind& left : all.texts) {
        if (!scene.isEmpty() && QFileInfo(pathOf(left.kept)).canonicalFilePath() !=
                                    QFileInfo(scene).canonicalFilePath())
            continue;
        const auto answer = ask(over, left.kept);
        if (answer == QMessageBox::Discard)
            left.place->remove();
        if (answer != QMessageBox::Yes)
            continue;
        autosave.recover(std::move(left));
        return true;
    }
    return false;
}

} // namespace views

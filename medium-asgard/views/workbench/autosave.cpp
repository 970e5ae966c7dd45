#include "workbench/autosave.h"

#include "dialogs/recovery.h"
#include "plain/plain.h"

#include <QFile>
#include <QFileInfo>

namespace views {

namespace {

const std::string draftsKey = "windows";
constexpr int lookEveryMs = 1000;

QString pathOf(const files::Kept& kept) { return QFile::decodeName(kept.file.path.c_str()); }

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
        const dialogs::Recovery answer = dialogs::askAbout(
            over, left.kept,
            {.program = Autosave::tr("Asgard"),
             .unnamed = Autosave::tr("A scene without a name"),
             .drafts = Autosave::tr("Its windows open again, with what was typed in them.")});
        if (answer == dialogs::Recovery::discard)
            left.place->remove();
        if (answer != dialogs::Recovery::recover)
            continue;
        autosave.recover(std::move(left));
        return true;
    }
    return false;
}

} // namespace views

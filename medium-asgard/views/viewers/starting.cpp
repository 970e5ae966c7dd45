#include "viewers/starting.h"

#include "plain/plain.h"
#include "start/first_page.h"
#include "start/samples.h"
#include "viewers/editor.h"
#include "viewers/scene_files.h"
#include "workbench/recent_files.h"

#include <QApplication>
#include <QFile>
#include <QStandardPaths>

namespace views {

Starting::Starting(Editor& editor, SceneFiles& files)
    : QObject(&files), editor_(editor), files_(files) {
    editor_.setFirstPage({[this] { showFirstPage(); }, [this] { closeFirstPage(); }});
}

Starting::~Starting() { editor_.setFirstPage({}); }

FirstPage* Starting::showFirstPage() {
    if (page_) {
        page_->raise();
        page_->activateWindow();
        return page_;
    }
    pictures_ = std::make_unique<SamplePictures>(
        QCoreApplication::applicationFilePath(),
        QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
            QStringLiteral("/samples"));
    page_ = new FirstPage(samplesOf(manifestOfProgram()), recentFiles(), pictures_.get());
    const auto begin = [this](bool begun) {
        if (!begun)
            return;
        showWindow();
        closeFirstPage();
    };
    connect(page_, &FirstPage::newWanted, this, [this, begin] { begin(files_.newScene()); });
    connect(page_, &FirstPage::openWanted, this, [this, begin] { begin(files_.open()); });
    connect(page_, &FirstPage::fileWanted, this,
            [this, begin](const QString& path) { begin(files_.open(path)); });
    connect(page_, &FirstPage::sampleWanted, this, &Starting::openSample);
    connect(page_, &FirstPage::tourWanted, this, &Starting::startTour);
    connect(page_, &FirstPage::quitWanted, this, [this] { editor_.quit(); });
    // Nobody waits for them any more.
    connect(page_, &QObject::destroyed, this, [this] { pictures_.reset(); });
    page_->show();
    return page_;
}

void Starting::closeFirstPage() {
    if (page_)
        page_->close();
}

GraphicalViewer* Starting::showWindow() {
    const auto open = editor_.graphicalViewers();
    GraphicalViewer* viewer = open.isEmpty() ? editor_.openMainWindow() : open.back();
    viewer->raise();
    viewer->activateWindow();
    return viewer;
}

void Starting::openSample(const Sample& sample) {
    QFile file(sample.path);
    if (!file.open(QIODevice::ReadOnly))
        return plain::Message::tell(QMessageBox::Warning, QApplication::activeWindow(), tr("Open"),
                                    tr("Cannot read %1: %2.").arg(sample.path, file.errorString()));
    if (!files_.newScene(file.readAll().toStdString(), sample.title))
        return;
    showWindow();
    closeFirstPage();
}

void Starting::startTour() {
    if (!files_.newScene())
        return;
    GraphicalViewer* viewer = showWindow();
    viewer->showTour();
    closeFirstPage();
}

} // namespace views

#include "window/file_menu.h"

#include "filing/choosing.h"
#include "filing/printing.h"
#include "filing/saving.h"
#include "menus/actions.h"
#include "plain/plain.h"
#include "source/presentation_pane.h"
#include "window/application.h"

#include <QFileDialog>
#include <QFileInfo>

namespace window {

FileMenu::FileMenu(Application& application, DocumentWindow& window)
    : QMenu(tr("&File"), &window), application_(application), window_(window) {
    QMenu* fresh = addMenu(tr("&New"));
    fillNew(*fresh);
    connect(fresh, &QMenu::aboutToShow, this, [this, fresh] { fillNew(*fresh); });
    menus::addTo(*this, "open", tr("&Open..."), QKeySequence::Open, [this] {
        const QFileInfo own(window_.document().document().fileName());
        const QString folder = own.fileName().isEmpty() ? filing::folderUsedLast() : own.path();
        const QStringList files =
            QFileDialog::getOpenFileNames(&window_, tr("Open"), folder, filing::documentFilter());
        for (const QString& file : files)
            application_.open(file, &window_);
    });
    recent_ = addMenu(tr("Open &Recent"));
    connect(recent_, &QMenu::aboutToShow, this, &FileMenu::fillRecent);
    addSeparator();
    save_ = menus::addTo(*this, "save", tr("&Save"), QKeySequence::Save, [this] { save(); });
    connect(this, &QMenu::aboutToShow, this, &FileMenu::nameSave);
    menus::addTo(*this, "saveAs", tr("Save &As..."), QKeySequence("Ctrl+Shift+S"),
                 [this] { window_.saveAs(); });
    QAction* backup = menus::addTo(*this, "backup", tr("&Version Before the Last Save"), {},
                                   [this] { window_.saving().bringBackup(); });
    connect(this, &QMenu::aboutToShow, this,
            [this, backup] { backup->setEnabled(window_.document().document().hasBackup()); });
    addSeparator();
    menus::addTo(*this, "exportPdf", tr("Export P&DF..."), QKeySequence("Ctrl+Shift+E"),
                 [this] { window_.printing().askAndExport(window_.view().presentation()); });
    menus::addTo(*this, "print", tr("&Print..."), QKeySequence::Print, [this] {
        window_.printing().askAndPrint(window_.view().presentation(), window_.documentTitle());
    });
    addSeparator();
    menus::addTo(*this, "close", tr("&Close"), QKeySequence::Close, [this] { window_.close(); });
    menus::addTo(*this, "quit", tr("&Quit"), QKeySequence("Ctrl+Q"),
                 [this] { application_.quit(); });
}

// The text with the keyboard is saved: the document, or the presentation that is edited beside it.
void FileMenu::save() {
    if (window_.presentation().hasKeyboard())
        window_.presentation().save();
    else
        window_.save();
}

void FileMenu::nameSave() {
    const source::PresentationPane& presentation = window_.presentation();
    save_->setText(presentation.hasKeyboard()
                       ? tr("&Save %1").arg(plain::caption(presentation.fileName()))
                       : tr("&Save"));
}

// Anew each time, since the user's own templates are files.
void FileMenu::fillNew(QMenu& menu) {
    menu.clear();
    bool isFirst = true;
    for (const filing::Template& one : filing::templates()) {
        menus::addTo(menu, "new" + QString(one.name).remove(' '), plain::caption(one.name),
                     isFirst ? QKeySequence(QKeySequence::New) : QKeySequence(),
                     [this, one] { application_.openNew(one, &window_); });
        isFirst = false;
    }
    menu.addSeparator();
    menus::addTo(menu, "saveAsTemplate", tr("&Save This Document as a Template..."), {},
                 [this] { window_.saving().saveAsTemplate(window_.view().title().simplified()); });
}

void FileMenu::fillRecent() {
    recent_->clear();
    for (const QString& file : application_.recentFiles())
        recent_
            ->addAction(plain::caption(QFileInfo(file).fileName()), this,
                        [this, file] { application_.open(file, &window_); })
            ->setToolTip(plain::tip(file));
    if (recent_->isEmpty())
        recent_->addAction(tr("Nothing yet"))->setEnabled(false);
}

} // namespace window

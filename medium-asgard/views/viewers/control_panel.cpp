#include "viewers/control_panel.h"

#include "frame/manual.h"
#include "frame/undo_actions.h"
#include "plain/plain.h"
#include "viewers/motion_span.h"
#include "viewers/status_panel.h"
#include "workbench/recent_files.h"

#include <QCloseEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QMenuBar>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace views {

namespace {

// What nobody notices is no number of seconds.
QString lastedText(const simulation::Statistics& statistics) {
    const double seconds = statistics.seconds;
    if (seconds < 1e-3)
        return ControlPanel::tr("less than 1 ms");
    return seconds < 1 ? ControlPanel::tr("%1 ms").arg(seconds * 1000, 0, 'f', 0)
                       : ControlPanel::tr("%1 s").arg(seconds, 0, 'f', seconds < 100 ? 1 : 0);
}

QString sceneFiles() { return ControlPanel::tr("Scenes (*.al);;All files (*)"); }

} // namespace

ControlPanel::ControlPanel(SceneDocument& document, Windows windows)
    : document_(document), windows_(std::move(windows)), name_(plain::label()),
      place_(plain::label()), state_(plain::label()), progress_(new QProgressBar),
      simulate_(new QPushButton(tr("&Simulate"))), exports_(*new Exports(document, *this)) {
    setObjectName("controlPanel");
    setWindowTitle(tr("Asgard"));
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(14, 12, 14, 12);
    column->setSpacing(6);
    QFont large = name_->font();
    large.setPointSizeF(large.pointSizeF() * 1.35);
    large.setBold(true);
    name_->setFont(large);
    name_->setObjectName("sceneName");
    name_->setAccessibleName(tr("Scene"));
    place_->setForegroundRole(QPalette::PlaceholderText);
    place_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    state_->setWordWrap(true);
    state_->setMinimumHeight(2 * state_->fontMetrics().height());
    state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    state_->setObjectName("state");
    state_->setAccessibleName(tr("State"));
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    progress_->setRange(0, 1000);
    progress_->setObjectName("progress");
    progress_->setAccessibleName(tr("How far the motion is computed"));
    column->addWidget(name_);
    column->addWidget(place_);
    column->addSpacing(6);
    column->addWidget(progress_);
    column->addWidget(state_);
    auto* span = new MotionSpan(document_);
    connect(span, &MotionSpan::left, simulate_, [this] { simulate_->setFocus(); });
    column->addWidget(span);
    column->addSpacing(6);
    auto* graphical = new QPushButton(tr("New &Graphical Viewer"));
    graphical->setObjectName("newGraphicalViewer");
    auto* language = new QPushButton(tr("New &Language Viewer"));
    language->setObjectName("newLanguageViewer");
    simulate_->setToolTip(tr("Compute the motion again (F5)"));
    simulate_->setObjectName("simulate");
    simulate_->setDefault(true);
    auto* exports = new QPushButton(tr("E&xport…"));
    exports->setObjectName("export");
    exports->setToolTip(
        tr("Pictures, and the motion as a table, for other programs (Ctrl+Shift+E)"));
    connect(exports, &QPushButton::clicked, &exports_, &Exports::ask);
    connect(&exports_, &Exports::says, state_, &QLabel::setText);
    for (QPushButton* button : {simulate_, graphical, language, exports}) {
        button->setMinimumHeight(32);
        column->addWidget(button);
    }
    setCentralWidget(whole);
    buildMenus();
    connect(simulate_, &QPushButton::clicked, &document_, &SceneDocument::recompute);
    connect(graphical, &QPushButton::clicked, this, [this] { windows_.openGraphicalViewer(); });
    connect(language, &QPushButton::clicked, this, [this] { windows_.openLanguageViewer(); });
    for (auto signal : {&SceneDocument::nameChanged, &SceneDocument::motionChanged,
                        &SceneDocument::workChanged, &SceneDocument::diagnosticsChanged})
        connect(&document_, signal, this, &ControlPanel::showState);
    showState();
    simulate_->setFocus(); // not a field: what is typed by mistake changes nothing
    setFixedWidth(320);
}

void ControlPanel::buildMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    // Elsewhere Ctrl+N is a new viewer; a new scene is seldom wanted, and its loss is asked about.
    file->addAction(tr("&New Scene"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N), this,
                    [this] { newScene(); });
    file->addAction(tr("&Open…"), QKeySequence::Open, this, [this] { open(); });
    fillWithRecentFiles(file->addMenu(tr("Open &Recent")),
                        [this](const QString& path) { open(path); });
    file->addAction(tr("&Save"), QKeySequence::Save, this, [this] { save(); });
    file->addAction(tr("Save &As…"), QKeySequence::SaveAs, this, [this] { saveAs(); });
    file->addAction(tr("&Export…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), &exports_,
                    &Exports::ask);
    file->addSeparator();
    file->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    addUndoActions(edit, document_);
    QMenu* scene = menuBar()->addMenu(tr("&Scene"));
    scene->addAction(tr("&Simulate"), QKeySequence(Qt::Key_F5), &document_,
                     &SceneDocument::recompute);
    scene->addAction(tr("New &Graphical Viewer"), QKeySequence(Qt::CTRL | Qt::Key_N), this,
                     [this] { windows_.openGraphicalViewer(); });
    scene->addAction(tr("New &Language Viewer"), QKeySequence(Qt::CTRL | Qt::Key_L), this,
                     [this] { windows_.openLanguageViewer(); });
    scene->addAction(tr("S&hape Editor"), QKeySequence(Qt::CTRL | Qt::Key_E), this,
                     [this] { windows_.openShapeEditor({}); });
    scene->addAction(tr("&Trajectory Editor"), QKeySequence(Qt::CTRL | Qt::Key_T), this,
                     [this] { windows_.openTrajectoryEditor(); });
    addHelpMenu(this, {});
}

void ControlPanel::showState() {
    name_->setText(document_.name() + (document_.isModified() ? tr(" (changed)") : QString()));
    const QString folder = QFileInfo(document_.path()).absolutePath();
    place_->setText(document_.path().isEmpty()
                        ? tr("not saved yet")
                        : place_->fontMetrics().elidedText(QDir::toNativeSeparators(folder),
                                                           Qt::ElideMiddle, 280));
    place_->setToolTip(plain::tip(folder));
    const auto& motion = document_.shown().motion;
    const double length = motion ? motion->finish() - motion->start() : 0;
    const double share = length > 0 ? (motion->computed() - motion->start()) / length : 0;
    progress_->setValue(static_cast<int>(1000 * share));
    std::size_t errors = 0;
    for (const scene::Diagnostic& d : document_.diagnostics())
        errors += d.severity == scene::Severity::error ? 1 : 0;
    if (document_.work() == Work::reading)
        state_->setText(tr("Reading the scene…"));
    else if (document_.work() == Work::simulating)
        state_->setText(tr("Computing the motion…"));
    else if (errors > 0)
        state_->setText(errors == 1 ? tr("One fault: a language viewer shows where.")
                                    : tr("%1 faults: a language viewer shows where.").arg(errors));
    else if (document_.waitsToBeAsked())
        state_->setText(tr("The motion is stale: Simulate computes that of the scene as it is."));
    else if (motion)
        state_->setText(tr("%1 of motion computed%2.")
                            .arg(timeText(length, length),
                                 document_.statistics()
                                     ? tr(" in %1").arg(lastedText(*document_.statistics()))
                                     : QString()));
    else
        state_->setText({});
}

void ControlPanel::newScene(QWidget* from) {
    if (mayLeave(from))
        document_.reset();
}

void ControlPanel::open(const QString& path) {
    if (!mayLeave())
        return;
    if (const QString fault = document_.open(path); !fault.isEmpty())
        plain::Message::tell(QMessageBox::Warning, this, tr("Open"), fault);
    else
        rememberFile(path);
}

void ControlPanel::open() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open a scene"), QFileInfo(document_.path()).absolutePath(), sceneFiles());
    if (!path.isEmpty())
        open(path);
}

bool ControlPanel::saveTo(const QString& path, QWidget* from) {
    MotionSpan::settleAll(document_);
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

bool ControlPanel::save(QWidget* from) {
    return document_.path().isEmpty() ? saveAs(from) : saveTo(document_.path(), from ? from : this);
}

bool ControlPanel::saveAs(QWidget* from) {
    const QPointer<QWidget> asked = from ? from : this;
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

bool ControlPanel::mayLeave(QWidget* from) {
    MotionSpan::settleAll(document_);
    if (exports_.isBusy() &&
        plain::Message::ask(QMessageBox::Question, from ? from : this, tr("Export"),
                            tr("An export is still being written. End it, unfinished?"),
                            QMessageBox::Yes | QMessageBox::No) != QMessageBox::Yes)
        return false;
    if (windows_.settleDrafts && !windows_.settleDrafts())
        return false;
    if (!document_.isModified())
        return true;
    const auto answer = plain::Message::ask(
        QMessageBox::Question, from ? from : this, tr("Asgard"),
        tr("%1 was changed and not saved.").arg(document_.name()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return save(from);
    return answer == QMessageBox::Discard;
}

void ControlPanel::closeEvent(QCloseEvent* event) {
    // Who changes his mind has all windows still.
    event->setAccepted(mayLeave() && windows_.closeViewers());
}

} // namespace views

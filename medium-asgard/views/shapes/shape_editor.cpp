#include "shapes/shape_editor.h"

#include "frame/help_menu.h"
#include "frame/hint_line.h"
#include "frame/names_box.h"
#include "frame/panes.h"
#include "frame/tool_bar.h"
#include "frame/undo_actions.h"
#include "plain/plain.h"
#include "point_edits/shape_library.h"
#include "point_edits/shape_points.h"
#include "shapes/shape_fields.h"
#include "shapes/shape_import.h"
#include "shapes/shape_names.h"
#include "shapes/shape_panel.h"

#include <QCloseEvent>
#include <QColorDialog>
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

using editing::DraftPart;
using geometry::Vector;

ShapeEditor::ShapeEditor(SceneDocument& document, std::shared_ptr<PictureThread> pictures)
    : document_(document), names_(new QComboBox), display_(new ShapeDisplay(std::move(pictures))),
      panel_(new ShapePanel), fields_(new ShapeFields), words_(new HintLine) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("shapeEditor");
    display_->setObjectName("shape");
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    auto* middle = new QHBoxLayout;
    auto* frame = new QFrame;
    frame->setFrameStyle(QFrame::StyledPanel | QFrame::Sunken);
    auto* inFrame = new QVBoxLayout(frame);
    inFrame->setContentsMargins(1, 1, 1, 1);
    inFrame->addWidget(display_);
    middle->addWidget(frame, 1);
    middle->addWidget(scrolled(panel_));
    column->addLayout(middle, 1);
    column->addWidget(fields_);
    words_->setObjectName("hint");
    column->addWidget(words_);
    setCentralWidget(whole);
    buildMenus();
    buildTools();
    connectDisplay();
    connectPanel();
    connect(names_, &QComboBox::currentTextChanged, this, &ShapeEditor::followScene);
    connect(&document_, &SceneDocument::sceneChanged, this, &ShapeEditor::followScene);
    // Until it is read, a text with no faults is shown as what was made of it.
    connect(&document_, &SceneDocument::diagnosticsChanged, this, [this] {
        if (document_.hasErrors() || document_.sceneIsCurrent())
            followScene();
    });
    const auto name = [this] {
        setWindowTitle(tr("%1[*] – Shape Editor").arg(plain::title(document_.name())));
        setWindowModified(!document_.hasHost() && document_.isModified());
    };
    connect(&document_, &SceneDocument::nameChanged, this, name);
    name();
    followScene();
    display_->setFocus();
    resize(860, 680);
}

void ShapeEditor::buildTools() {
    names_->setObjectName("shapes");
    names_->setAccessibleName(tr("Shape"));
    names_->setMinimumContentsLength(12);
    names_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* bar = new ToolBar(*this);
    bar->addWidget(names_);
    for (const auto& group : std::initializer_list<std::vector<std::pair<const char*, Icon>>>{
             {{"newShape", Icon::newScene}, {"importShape", Icon::open}, {"rename", Icon::text}},
             {{"undo", Icon::undo}, {"redo", Icon::redo}},
             {{"addVertex", Icon::add}, {"deleteVertex", Icon::remove}},
             {{"frameAll", Icon::frameAll}},
             {{"help", Icon::help}}}) {
        bar->addSeparator();
        for (const auto& [name, which] : group)
            bar->add(name, which);
    }
}

void ShapeEditor::buildMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("&New Shape…"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_N), this,
                    &ShapeEditor::askForNewShape)
        ->setObjectName("newShape");
    file->addAction(tr("&Import…"), QKeySequence(Qt::CTRL | Qt::Key_I), this,
                    &ShapeEditor::askToImport)
        ->setObjectName("importShape");
    actions_.rename = file->addAction(tr("&Rename Shape…"), QKeySequence(Qt::Key_F2), this,
                                      &ShapeEditor::askForName);
    actions_.rename->setObjectName("rename");
    file->addSeparator();
    file->addAction(tr("&Close"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &QWidget::close);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    addUndoActions(edit, document_);
    edit->addSeparator();
    edit->addAction(tr("&Add Vertex"), QKeySequence(Qt::Key_Insert), this,
                    &ShapeEditor::addPointByKey)
        ->setObjectName("addVertex");
    actions_.removePoint =
        edit->addAction(tr("Delete &Vertex"), QKeySequence(Qt::Key_Delete), this, [this] {
            if (display_->chosenPart() && display_->chosenPoint())
                removePoint(*display_->chosenPart(), *display_->chosenPoint());
        });
    actions_.removePoint->setObjectName("deleteVertex");
    actions_.removePart =
        edit->addAction(tr("Delete &Part"), QKeySequence(Qt::SHIFT | Qt::Key_Delete), this,
                        &ShapeEditor::removePart);
    edit->addAction(tr("Convex &Hull"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H), this,
                    [this] { dropInnerPoints(false); });
    edit->addSeparator();
    edit->addAction(tr("Ne&xt Vertex"), QKeySequence(Qt::Key_PageDown), this,
                    [this] { chooseNext(1); });
    edit->addAction(tr("P&revious Vertex"), QKeySequence(Qt::Key_PageUp), this,
                    [this] { chooseNext(-1); });
    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addAction(tr("&Frame All"), QKeySequence(Qt::Key_F), display_, &ShapeDisplay::frame)
        ->setObjectName("frameAll");
    view->addSeparator();
    const std::tuple<QString, Vector, int> sides[] = {
        {tr("Along &z: the Plane x y"), Vector::UnitZ(), Qt::Key_3},
        {tr("Along &x: the Plane y z"), Vector::UnitX(), Qt::Key_1},
        {tr("Along &y: the Plane x z"), Vector::UnitY(), Qt::Key_2}};
    for (const auto& [text, toward, key] : sides)
        view->addAction(plain::ours(text), QKeySequence(key), display_,
                        [this, side = toward] { display_->lookAlong(side); });
    addHelpMenu(this, QStringLiteral("Shape editor"));
}

void ShapeEditor::connectDisplay() {
    display_->installEventFilter(this);
    connect(display_, &ShapeDisplay::chosen, this, [this](std::size_t part, std::size_t point) {
        choose(part, point);
        tell({});
    });
    connect(display_, &ShapeDisplay::clicked, this, [this](std::optional<std::size_t> part) {
        choose(part);
        tell({});
    });
    connect(display_, &ShapeDisplay::dragged, this, &ShapeEditor::drag);
    connect(display_, &ShapeDisplay::released, this, [this] { finish(tr("Move Vertex")); });
    connect(display_, &ShapeDisplay::cancelled, this, &ShapeEditor::cancel);
    connect(display_, &ShapeDisplay::addWanted, this, &ShapeEditor::addPoint);
    connect(display_, &ShapeDisplay::removeWanted, this, &ShapeEditor::removePoint);
}

void ShapeEditor::connectPanel() {
    connect(panel_, &ShapePanel::chosen, this, [this](std::size_t part) {
        if (display_->chosenPart() != part)
            choose(part);
    });
    connect(panel_, &ShapePanel::addWanted, this, &ShapeEditor::addParts);
    connect(panel_, &ShapePanel::hullWanted, this, [this] { dropInnerPoints(false); });
    connect(panel_, &ShapePanel::colourWanted, this, &ShapeEditor::askForColour);
    connect(panel_, &ShapePanel::removeWanted, this, &ShapeEditor::removePart);
    connect(panel_, &ShapePanel::gridChanged, display_, &ShapeDisplay::setGrid);
    connect(fields_, &ShapeFields::placeTaken, this, &ShapeEditor::movePoint);
    connect(fields_, &ShapeFields::sizesTaken, this, &ShapeEditor::resizePart);
    connect(fields_, &ShapeFields::refused, this, [this](const QString& why) {
        tell(why, true);
        showFields();
    });
}

// --- what is shown -----------------------------------------------------------------------------

QString ShapeEditor::shape() const { return names_->currentText(); }

QString ShapeEditor::words() const { return words_->all(); }

std::optional<std::size_t> ShapeEditor::index() const {
    return indexNamed(document_.shown().scene->shapeSets, names_->currentText());
}

std::vector<scene::Part> ShapeEditor::parts() const {
    std::vector<scene::Part> parts;
    for (const DraftPart& one : draft_)
        parts.push_back(one.part);
    return parts;
}

void ShapeEditor::showShape(const QString& name) {
    if (const int row = names_->findText(name); row >= 0)
        names_->setCurrentIndex(row);
    else
        shapes_.wanted = name;
}

void ShapeEditor::fillNames() {
    fill(*names_, namesOf(document_.shown().scene->shapeSets), shapes_.wanted);
    if (names_->currentText() == shapes_.wanted)
        shapes_.wanted.clear();
}

void ShapeEditor::followScene() {
    if (gesture_)
        return; // its own steps; what it ends with is followed
    fillNames();
    const bool another = shapes_.shown != names_->currentText();
    if (another) {
        nudges_.clear();
        leaveShape(std::exchange(shapes_.shown, names_->currentText()));
    }
    const auto here = index();
    const bool hadNone = !panel_->isEnabled();
    for (QWidget* one : std::initializer_list<QWidget*>{names_, panel_, fields_})
        one->setEnabled(here.has_value());
    actions_.rename->setEnabled(here.has_value());
    draft_ = here ? editing::draftOf(document_.shown().scene->shapeSets[*here])
                  : std::vector<DraftPart>();
    showDraft(another);
    if (another)
        choose(draft_.empty() ? std::nullopt : std::optional<std::size_t>(0));
    if (wantedPart_ && *wantedPart_ < draft_.size() && document_.sceneIsCurrent())
        choose(std::exchange(wantedPart_, std::nullopt));
    if (!here)
        tell(tr("This scene has no shapes yet. New makes one."));
    else if (words_->all().isEmpty() || hadNone)
        tell({});
    if (document_.hasErrors())
        nudges_.clear(); // whoever mends them does not expect a vertex to move
    if (!document_.sceneIsCurrent())
        return;
    if (untilCurrent_)
        tell({});
    if (!nudges_.empty())
        makeNudges();
    if (closing_)
        close();
}

void ShapeEditor::showDraft(bool another) {
    display_->setParts(parts(), another);
    panel_->setParts(parts(), display_->chosenPart());
    showFields();
}

void ShapeEditor::choose(std::optional<std::size_t> part, std::optional<std::size_t> point) {
    display_->choose(part, point);
    panel_->choose(display_->chosenPart());
    showFields();
}

void ShapeEditor::showFields() {
    const auto part = display_->chosenPart();
    actions_.removePart->setEnabled(part.has_value());
    actions_.removePoint->setEnabled(display_->chosenPoint().has_value());
    fields_->showNumbers(part ? &draft_[*part].part : nullptr, display_->chosenPlace());
}

void ShapeEditor::tell(const QString& words, bool isFault) {
    untilCurrent_ = false;
    words_->say(
        words.isEmpty()
            ? tr("Click chooses a part  ·  drag moves a vertex, elsewhere it turns the view  ·  "
                 "Shift-middle adds a vertex to the chosen part, Shift-right deletes one  "
                 "·  Page Up, Page Down: vertex by vertex, the arrow keys move it  ·  "
                 "white vertices lie inside and go when the shape is left")
            : words,
        isFault);
}

// --- by keys -----------------------------------------------------------------------------------

void ShapeEditor::chooseNext(int direction) {
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (std::size_t i = 0; i < draft_.size(); ++i)
        for (std::size_t k = 0; k < editing::pointsOf(draft_[i].part).size(); ++k)
            all.emplace_back(i, k);
    if (all.empty())
        return;
    const auto part = display_->chosenPart(), point = display_->chosenPoint();
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    std::ptrdiff_t at = direction > 0 ? 0 : count - 1;
    if (part) {
        const auto here = std::ranges::find(all, std::pair(*part, point.value_or(0)));
        at = here - all.begin() + (point ? direction : 0);
    }
    const auto& [nextPart, nextPoint] = all[static_cast<std::size_t>((at + count) % count)];
    choose(nextPart, nextPoint);
}

bool ShapeEditor::eventFilter(QObject* watched, QEvent* event) {
    if (watched != display_ || event->type() != QEvent::KeyPress)
        return QMainWindow::eventFilter(watched, event);
    // Along the axes that are seen best to the right and upwards; with Control along the third.
    const auto* keys = static_cast<QKeyEvent*>(event);
    const bool third = keys->modifiers() & Qt::ControlModifier;
    const double many = keys->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (keys->key()) {
    case Qt::Key_Left:
        nudge(-many * display_->screenAxis(third ? 2 : 0));
        return true;
    case Qt::Key_Right:
        nudge(many * display_->screenAxis(third ? 2 : 0));
        return true;
    case Qt::Key_Up:
        nudge(many * display_->screenAxis(third ? 2 : 1));
        return true;
    case Qt::Key_Down:
        nudge(-many * display_->screenAxis(third ? 2 : 1));
        return true;
    default:
        return QMainWindow::eventFilter(watched, event);
    }
}

// --- shapes ------------------------------------------------------------------------------------

namespace {

scene::Part firstPart() { return editing::tetrahedron(1); }

} // namespace

bool ShapeEditor::isBegun() const {
    return shapes_.shown == shapes_.begun && draft_.size() == 1 &&
           draft_.front().part == firstPart();
}

QString ShapeEditor::newShape(const QString& name) {
    QString fault = makeShape(document_, name, {firstPart()}, tr("New Shape %1").arg(name));
    if (fault.isEmpty())
        shapes_.wanted = shapes_.begun = name;
    return fault;
}

QString ShapeEditor::renameShape(const QString& name) {
    const auto here = index();
    const QString before = names_->currentText();
    if (name == before || !here)
        return {};
    QString fault = views::renameShape(document_, *here, name);
    if (!fault.isEmpty())
        return fault;
    if (shapes_.edited.erase(before) > 0)
        shapes_.edited.insert(name);
    shapes_.shown = shapes_.wanted = name;
    return {};
}

void ShapeEditor::askForNewShape() {
    bool ok = false;
    const QString name = QInputDialog::getText(this, tr("New Shape"), tr("Name of the shape:"),
                                               QLineEdit::Normal, unusedShapeName(document_), &ok);
    if (!ok)
        return;
    if (const QString fault = newShape(name.trimmed()); !fault.isEmpty())
        plain::Message::tell(QMessageBox::Warning, this, tr("New Shape"), fault);
}

void ShapeEditor::askToImport() {
    if (ShapeImport* dialog = importShape(document_, display_->picture().thread(), this))
        connect(dialog, &ShapeImport::imported, this, &ShapeEditor::showShape);
}

void ShapeEditor::askForName() {
    if (!index())
        return;
    bool ok = false;
    const QString name = QInputDialog::getText(this, tr("Rename Shape"), tr("Name of the shape:"),
                                               QLineEdit::Normal, names_->currentText(), &ok);
    if (!ok)
        return;
    if (const QString fault = renameShape(name.trimmed()); !fault.isEmpty())
        plain::Message::tell(QMessageBox::Warning, this, tr("Rename Shape"), fault);
}

void ShapeEditor::askForColour() {
    const auto part = display_->chosenPart();
    if (!part)
        return;
    const auto now = draft_[*part].part.appearance.color.value_or(scene::Color{});
    const QColor chosen = QColorDialog::getColor(QColor::fromRgbF(static_cast<float>(now.red),
                                                                  static_cast<float>(now.green),
                                                                  static_cast<float>(now.blue)),
                                                 this, tr("Colour of the Part"));
    if (chosen.isValid() && part == display_->chosenPart())
        setColour(*part,
                  scene::Color{decimal(chosen.redF(), 0.001), decimal(chosen.greenF(), 0.001),
                               decimal(chosen.blueF(), 0.001)});
}

void ShapeEditor::showEvent(QShowEvent* event) {
    closing_ = false; // it is wanted again
    QMainWindow::showEvent(event);
}

void ShapeEditor::settle() {
    if (isVisible())
        leaveShape(shapes_.shown);
}

void ShapeEditor::closeEvent(QCloseEvent* event) {
    cancel();
    const bool waits = shapes_.edited.contains(shapes_.shown) && !document_.sceneIsCurrent() &&
                       !document_.hasErrors() && !closing_;
    closing_ = true;
    if (waits) { // for what was just done to be read
        hide();
        return event->ignore();
    }
    leaveShape(shapes_.shown);
    event->accept();
}

} // namespace views

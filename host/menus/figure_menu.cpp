#include "menus/figure_menu.h"

#include "files/save.h"
#include "menus/actions.h"
#include "menus/figure_dialogs.h"
#include "menus/medium_files.h"
#include "plain/plain.h"
#include "session/samples.h"
#include "view/document_view.h"

#include <QFile>
#include <QFileInfo>
#include <cmath>

namespace menus {

using authoring::Manuscript, authoring::Selection;
using document::Placement;

FigureMenu::FigureMenu(view::DocumentView& view, QWidget* parent)
    : QMenu(tr("Fi&gure"), parent), view_(view) {
    setObjectName("figure");
    setToolTipsVisible(true);
    hint_ =
        addTo(*this, "figureHint", tr("Click a figure, or write in its caption, first"), {}, {});
    hint_->setEnabled(false);
    const auto written = [this] { return whyNotWritten(); };
    add(
        "figureEdit", tr("&Edit"), [this] { return whyNotEdited(); },
        [this] { openEditor(view_, id()); });
    addSeparator();
    addAlignment(Placement::left, "figureLeft", tr("Align &Left"));
    addAlignment(Placement::center, "figureCenter", tr("Align &Centre"));
    addAlignment(Placement::right, "figureRight", tr("Align &Right"));
    addSeparator();
    presentations_ = addMenu(tr("Show As"));
    presentations_->setObjectName("figurePresentations");
    add("figureSize", tr("&Size..."), written, [this] { askForSize(); });
    add("figureAlternative", tr("Alternative &Text..."), written, [this] { askForAlternative(); });
    add(
        "figureCaption", tr("C&aption"), [this] { return whyNoCaption(); },
        [this] { view_.writing().perform(caption()); });
    add(
        "figurePoster", tr("Use This &Moment as Poster"), [this] { return whyNoMoment(); },
        [this] { takeMoment(); });
    addSeparator();
    add("figureDelete", tr("&Delete Figure"), written, [this] {
        view_.choose(id());
        view_.chosenFigure().erase();
    });
    addSeparator();
    add(
        "figureSave", tr("Save a Cop&y..."), [this] { return whyNoText(); },
        [this] { saveCopy(); });
    add(
        "figureReplace", tr("Replace &with a File..."),
        [this] {
            QString why = whyNotWritten();
            return why.isEmpty() ? whyNoText() : why;
        },
        [this] { replace(); });
    const auto update = [this] {
        menuAction()->setVisible(!view_.document().document().subdocuments().empty());
    };
    connect(&view_.document(), &session::OpenDocument::structureChanged, this, update);
    update();
    connect(this, &QMenu::aboutToShow, this, &FigureMenu::offer);
}

void FigureMenu::add(const QString& name, const QString& text, std::function<QString()> whyNot,
                     std::function<void()> done) {
    const auto guarded = [this, whyNot, done = std::move(done)] {
        if (const QString why = whyNot(); !why.isEmpty())
            Q_EMIT view_.writing().refused(why);
        else
            done();
    };
    entries_.push_back({addTo(*this, name, text, {}, guarded), std::move(whyNot)});
}

void FigureMenu::addAlignment(Placement placement, const QString& name, const QString& text) {
    constexpr std::pair<Placement, const char*> words[] = {
        {Placement::left, "left"}, {Placement::center, "center"}, {Placement::right, "right"}};
    std::string value;
    for (const auto& [one, word] : words)
        if (one == placement)
            value = word;
    add(
        name, text, [this] { return whyNotWritten(); },
        [this, value] {
            setAttributes({{"ALIGN", value}}, tr("Align"));
        });
    entries_.back().action->setCheckable(true);
    alignments_.emplace_back(entries_.back().action, placement);
}

void FigureMenu::offer() {
    hint_->setVisible(!figure());
    for (const Entry& entry : entries_) {
        const QString why = entry.whyNot();
        entry.action->setEnabled(why.isEmpty());
        entry.action->setToolTip(plain::tip(why));
    }
    for (const auto& [action, placement] : alignments_)
        action->setChecked(figure() && figure()->placement == placement);
    offerPresentations();
}

// As the medium of the figure says; the usual one is said by no attribute.
void FigureMenu::offerPresentations() {
    presentations_->clear();
    const media::LiveSubdocument* of = live();
    QString why = whyNotWritten();
    if (why.isEmpty() && (!of || of->presentations().size() < 2))
        why = tr("Its medium offers nothing else, or does not run yet.");
    presentations_->setEnabled(why.isEmpty());
    presentations_->menuAction()->setToolTip(plain::tip(why));
    if (!of || !why.isEmpty())
        return;
    for (const ipc::Presentation& one : of->presentations()) {
        const bool isUsual = &one == &of->presentations().front();
        QAction* action =
            presentations_->addAction(plain::caption(QString::fromStdString(one.label)));
        action->setObjectName(QStringLiteral("figureAs-") + QString::fromStdString(one.id));
        action->setCheckable(true);
        action->setChecked(one.id == of->presentation());
        connect(action, &QAction::triggered, this, [this, name = isUsual ? "" : one.id] {
            if (figure())
                setAttributes({{"PRESENTATION", name}}, tr("Show As"));
        });
    }
}

void FigureMenu::showAt(const QPoint& at, QMenu* ofMedium) {
    auto* menu = new QMenu(parentWidget());
    menu->setObjectName("figureContext");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (ofMedium) {
        menu->addActions(ofMedium->actions());
        menu->addSeparator();
    }
    menu->addMenu(this);
    menu->popup(at);
}

// --- what is chosen ----------------------------------------------------------------------------

// That of the caret is the one in the element with the role `figure` around it.
document::SubdocumentId FigureMenu::id() const {
    const std::optional<Selection> at = view_.writing().selection();
    if (view_.chosen() || !view_.isWriting() || !at)
        return view_.chosen();
    const document::Document& document = view_.document().document();
    for (const document::SubdocumentId one : document.subdocuments()) {
        const sgml::NodeId element = document.subdocument(one)->element;
        const sgml::NodeId whole = authoring::wholeFigure(view_.writing().manuscript(), element);
        const text::Range range = document.tree().node(whole).range;
        if (whole != element && range.from < at->caret && at->caret < range.to)
            return one;
    }
    return document::noSubdocument;
}

const document::Subdocument* FigureMenu::figure() const {
    return view_.document().document().subdocument(id());
}

const media::Manifest* FigureMenu::manifest() const {
    const document::Subdocument* of = figure();
    return of ? view_.document().media().registry().forClass(QString::fromStdString(of->className))
              : nullptr;
}

media::LiveSubdocument* FigureMenu::live() const { return view_.document().live(id()); }

QString FigureMenu::whyNotChosen() const {
    return figure() && figure()->classElement != sgml::noNode ? QString()
                                                              : tr("Click a figure first.");
}

QString FigureMenu::whyNotWritten() const {
    QString why = whyNotChosen();
    if (why.isEmpty() && !view_.isWriting())
        return tr("This window is for reading. Edit > Write lets you change the document.");
    return why;
}

QString FigureMenu::whyNotEdited() const {
    QString why = whyNotWritten();
    if (why.isEmpty() && (!live() || manifest()->newEditor.isEmpty()))
        return tr("Its medium has no window in which it is built.");
    return why;
}

QString FigureMenu::whyNoCaption() const {
    const QString why = whyNotWritten();
    return why.isEmpty() ? view_.writing().whyNot(caption()) : why;
}

QString FigureMenu::whyNoMoment() const {
    QString why = whyNotWritten();
    if (!why.isEmpty())
        return why;
    const media::LiveSubdocument* of = live();
    const bool hasTime = of && of->time() && of->time()->finish > of->time()->start;
    return hasTime ? QString() : tr("This figure does not move, or does not show its time yet.");
}

QString FigureMenu::whyNoText() const {
    QString why = whyNotChosen();
    if (!why.isEmpty())
        return why;
    return manifest() && figure()->hasText ? QString() : tr("No medium for it is installed.");
}

// --- what is done ------------------------------------------------------------------------------

// The entry's window: one process is enough.
void openEditor(view::DocumentView& view, document::SubdocumentId id) {
    const document::Subdocument* of = view.document().document().subdocument(id);
    media::LiveSubdocument* live = view.document().live(id);
    const media::Manifest* manifest =
        live ? view.document().media().registry().forClass(QString::fromStdString(of->className))
             : nullptr;
    if (!manifest || manifest->newEditor.isEmpty())
        return;
    const auto say = [document = &view.document(), id](const QString& sentence) {
        Q_EMIT document->figureSaid(id, sentence);
    };
    QObject::connect(
        live, &media::LiveSubdocument::windowsChanged, &view, [say] { say({}); },
        Qt::SingleShotConnection);
    live->setMode(media::Mode::edit);
    live->invoke(manifest->newEditor, view.rendition(id), view.screenAreaOf(id));
    say(FigureMenu::tr("Opening the editor of %1 ...").arg(manifest->name));
}

void FigureMenu::setAttributes(const authoring::Attributes& attributes, const QString& label) {
    const sgml::NodeId element = figure()->classElement;
    view_.writing().change([&](const Manuscript& in, Selection at) {
        return authoring::setAttributes(in, at, element, attributes, label);
    });
}

void FigureMenu::askForSize() {
    const std::optional<QSizeF> wanted =
        menus::askForSize(view_.document().sizeOf(id()), parentWidget());
    if (!wanted || !figure())
        return;
    const auto spelled = [](double length) { return QString::number(std::lround(length)); };
    if (wanted->isEmpty())
        setAttributes({{"WIDTH", ""}, {"HEIGHT", ""}}, tr("Size"));
    else
        setAttributes({{"WIDTH", spelled(wanted->width()).toStdString()},
                       {"HEIGHT", spelled(wanted->height()).toStdString()}},
                      tr("Size"));
}

void FigureMenu::askForAlternative() {
    const std::optional<QString> wanted =
        menus::askForAlternative(QString::fromStdString(figure()->alternative), parentWidget());
    if (!wanted || !figure())
        return;
    setAttributes({{"ALT", wanted->toStdString()}}, tr("Alternative Text"));
}

// To the millisecond, as far as anybody sees it.
void FigureMenu::takeMoment() {
    const double time = std::round(live()->time()->time * 1000) / 1000;
    setAttributes({{"POSTER", QString::number(time).toStdString()}}, tr("Poster"));
}

view::Writing::Command FigureMenu::caption() const {
    const std::size_t behind = view_.document().document().tree().node(figure()->element).range.to;
    return [behind](const Manuscript& in, Selection) {
        return authoring::insertCaption(in, {behind, behind});
    };
}

void FigureMenu::saveCopy() {
    const QFileInfo own(view_.document().document().fileName());
    const QString file = askWhereToSave(*manifest(), own.path(), parentWidget());
    if (file.isEmpty() || !figure())
        return;
    files::FileStamp stamp;
    const files::SaveResult saved =
        files::writeFile(files::FileSystem::real(), QFile::encodeName(file).toStdString(),
                         view_.document().document().text(id()), stamp);
    if (!saved)
        plain::Message::tell(QMessageBox::Critical, parentWidget(), tr("Save a Copy"),
                             QString::fromStdString(saved.sentence));
}

void FigureMenu::replace() {
    const QString file = askForMediumFile(*manifest(), tr("Replace with a File"), parentWidget());
    if (file.isEmpty() || !figure())
        return;
    const session::MediumText read = session::readMediumText(file);
    if (!read.fault.isEmpty())
        return plain::Message::tell(QMessageBox::Critical, parentWidget(), tr("Replace"),
                                    read.fault);
    document::Document& document = view_.document().document();
    const std::size_t length = document.text(id()).size();
    const document::EditResult result = document.editText(
        id(), figure()->revision, {{{0, length}, read.text}}, tr("Replace Figure"));
    if (result != document::EditResult::applied && result != document::EditResult::nothing)
        Q_EMIT view_.writing().refused(tr("This text cannot take the figure's place."));
}

} // namespace menus

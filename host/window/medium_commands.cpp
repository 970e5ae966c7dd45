#include "window/medium_commands.h"

#include "controls/icons.h"
#include "controls/play_bar.h"
#include "menus/question_dialog.h"
#include "plain/plain.h"

#include <algorithm>
#include <set>

namespace window {

namespace {

bool sameShape(const std::vector<ipc::MenuEntry>& a, const std::vector<ipc::MenuEntry>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.id == y.id && x.label == y.label && x.group == y.group && x.icon == y.icon &&
               x.shortcut == y.shortcut && x.checkable == y.checkable;
    });
}

// A medium's name with the first of its letters that opens no other menu as its key.
QString titleOf(const QString& name, const QMenuBar& bar) {
    QString taken;
    for (const QAction* action : bar.actions())
        if (const qsizetype mark = action->text().indexOf('&'); mark >= 0)
            taken += action->text().mid(mark + 1, 1);
    for (qsizetype i = 0; i < name.size(); ++i)
        if (name[i].isLetter() && !taken.contains(name[i], Qt::CaseInsensitive))
            return plain::caption(name.left(i)) + '&' + plain::caption(name.mid(i));
    return plain::caption(name);
}

// In the tool area the play bar does it, for all that is visible and of every medium.
bool isPlaying(const std::string& icon) {
    return icon == "media-playback-start" || icon == "media-playback-pause";
}

} // namespace

MediumCommands::MediumCommands(session::OpenDocument& document, view::DocumentView& view,
                               QMenuBar& bar, QAction* before, QToolBar& toolArea)
    : document_(document), view_(view), bar_(bar), before_(before), tools_(toolArea),
      owner_(plain::label({}, &toolArea)), time_(new controls::PlayBar(false, &toolArea)) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &MediumCommands::refresh);
    connect(&view_, &view::DocumentView::chosenChanged, this, &MediumCommands::schedule);
    connect(&view_, &view::DocumentView::visibleChanged, this, &MediumCommands::schedule);
    connect(&document_, &session::OpenDocument::structureChanged, this, [this] {
        watch();
        schedule();
    });
    owner_->setContentsMargins(6, 0, 6, 0);
    tools_.addWidget(owner_);
    timeAction_ = tools_.addWidget(time_);
    time_->setMaximumWidth(360);
    const auto forTimed = [this](auto action) {
        for (media::LiveSubdocument* live : timed())
            action(*live);
    };
    connect(time_, &controls::PlayBar::playWanted, this,
            [=] { forTimed([](auto& l) { l.play(); }); });
    connect(time_, &controls::PlayBar::pauseWanted, this,
            [=] { forTimed([](auto& l) { l.pause(); }); });
    connect(time_, &controls::PlayBar::seekWanted, this,
            [=](double t) { forTimed([t](auto& l) { l.seek(t); }); });
    watch();
    refresh();
}

MediumCommands::~MediumCommands() = default;

void MediumCommands::watch() {
    for (const QMetaObject::Connection& connection : watched_)
        disconnect(connection);
    watched_.clear();
    for (const document::SubdocumentId id : document_.document().subdocuments())
        if (media::LiveSubdocument* live = document_.live(id)) {
            watched_.push_back(connect(live, &media::LiveSubdocument::menusChanged, this,
                                       &MediumCommands::schedule));
            watched_.push_back(connect(live, &media::LiveSubdocument::conditionChanged, this,
                                       &MediumCommands::schedule));
            watched_.push_back(connect(live, &media::LiveSubdocument::timeChanged, this,
                                       &MediumCommands::refreshTime));
        }
}

void MediumCommands::schedule() {
    if (!timer_.isActive())
        timer_.start(0);
}

std::vector<document::SubdocumentId> MediumCommands::targets(const QString& documentClass) const {
    const auto isOf = [&](document::SubdocumentId id) {
        const media::LiveSubdocument* live = document_.live(id);
        return live && live->manifest().documentClass == documentClass;
    };
    if (isOf(view_.chosen()))
        return {view_.chosen()};
    std::vector<document::SubdocumentId> result;
    for (const document::SubdocumentId id : view_.visibleSubdocuments())
        if (isOf(id))
            result.push_back(id);
    return result;
}

std::vector<media::LiveSubdocument*> MediumCommands::livesOf(const QString& documentClass) const {
    std::vector<media::LiveSubdocument*> result;
    for (const document::SubdocumentId id : targets(documentClass))
        result.push_back(document_.live(id));
    return result;
}

// The play bar's: what has time, of whatever medium; a figure that is faulty has none.
std::vector<media::LiveSubdocument*> MediumCommands::timed() const {
    std::vector<document::SubdocumentId> ids = view_.visibleSubdocuments();
    if (document_.live(view_.chosen()))
        ids = {view_.chosen()};
    std::vector<media::LiveSubdocument*> result;
    for (const document::SubdocumentId id : ids)
        if (media::LiveSubdocument* live = document_.live(id);
            live && live->time() && live->time()->finish > live->time()->start)
            result.push_back(live);
    return result;
}

QString MediumCommands::toolOwner() const {
    if (const media::LiveSubdocument* chosen = document_.live(view_.chosen()))
        return chosen->manifest().documentClass;
    for (const document::SubdocumentId id : view_.visibleSubdocuments())
        if (const media::LiveSubdocument* live = document_.live(id))
            return live->manifest().documentClass;
    return {};
}

void MediumCommands::invoke(const QString& documentClass, const QString& id) {
    for (const document::SubdocumentId target : targets(documentClass))
        if (media::LiveSubdocument* live = document_.live(target))
            live->invoke(id, view_.rendition(target), view_.screenAreaOf(target),
                         [self = QPointer(this), live = QPointer(live), id,
                          target](const ipc::Question& question) {
                             if (self && live)
                                 self->ask(*live, target, id, question);
                         });
}

void MediumCommands::ask(media::LiveSubdocument& live, document::SubdocumentId target,
                         const QString& id, const ipc::Question& question) {
    ipc::MenuInvoke call;
    call.id = id.toStdString();
    if (const media::Rendition* rendition = view_.rendition(target))
        call.rendition = rendition->id();
    auto* dialog = new menus::QuestionDialog(live, std::move(call), question, bar_.window());
    dialog->open();
}

// --- menus -------------------------------------------------------------------------------------

void MediumCommands::refresh() {
    std::set<QString> classes;
    for (const document::SubdocumentId id : document_.document().subdocuments())
        if (const media::LiveSubdocument* live = document_.live(id))
            classes.insert(live->manifest().documentClass);
    for (auto medium = media_.begin(); medium != media_.end();) {
        const auto next = std::next(medium);
        if (!classes.contains(medium->first)) {
            clearTools(); // perhaps this one's
            delete medium->second.menu;
            media_.erase(medium);
        }
        medium = next;
    }
    for (const QString& documentClass : classes)
        refreshMenu(documentClass, media_[documentClass]);
    refreshTools();
}

void MediumCommands::refreshMenu(const QString& documentClass, Medium& medium) {
    const media::Manifest* manifest = document_.media().registry().forClass(documentClass);
    if (!medium.menu) {
        medium.menu =
            new QMenu(plain::ours(titleOf(manifest ? manifest->name : documentClass, bar_)), &bar_);
        bar_.insertMenu(before_, medium.menu);
    }
    const std::vector<media::LiveSubdocument*> all = livesOf(documentClass);
    const auto told = std::ranges::find_if(
        all, [](const media::LiveSubdocument* one) { return !one->menus().empty(); });
    if (told != all.end() &&
        (!sameShape(medium.entries, (*told)->menus()) || medium.actions.empty()))
        build(documentClass, medium, (*told)->menus());
    for (const auto& [id, action] : medium.actions)
        showState(*action, id, all);
    giveKeys(medium, documentClass == toolOwner());
}

// The window's own commands keep their keys: an entry that asks for one of them, or for the key of
// an entry before it, has none.
void MediumCommands::giveKeys(const Medium& medium, bool hasKeys) const {
    std::set<const QAction*> ofMedia;
    for (const auto& [documentClass, one] : media_)
        for (const auto& [id, action] : one.actions)
            ofMedia.insert(action);
    std::set<QKeySequence> taken;
    for (const QAction* action : bar_.window()->findChildren<QAction*>())
        if (!ofMedia.contains(action))
            for (const QKeySequence& keys : action->shortcuts())
                taken.insert(keys);
    for (const ipc::MenuEntry& entry : medium.entries) {
        const QKeySequence keys(QString::fromStdString(entry.shortcut));
        const bool isFree = hasKeys && !keys.isEmpty() && taken.insert(keys).second;
        medium.actions.at(entry.id)->setShortcut(isFree ? keys : QKeySequence());
    }
}

// A command is there as soon as one of those that it acts on takes it: a faulty figure does not
// disable it for the others.
void MediumCommands::showState(QAction& action, const std::string& id,
                               const std::vector<media::LiveSubdocument*>& all) {
    if (action.isSeparator())
        return;
    const ipc::MenuEntry* shown = nullptr;
    for (const media::LiveSubdocument* live : all)
        for (const ipc::MenuEntry& entry : live->menus())
            if (entry.id == id && (!shown || (entry.enabled && !shown->enabled)))
                shown = &entry;
    action.setEnabled(shown && shown->enabled);
    action.setChecked(shown && shown->checked);
}

void MediumCommands::build(const QString& documentClass, Medium& medium,
                           const std::vector<ipc::MenuEntry>& entries) {
    clearTools();
    medium.menu->clear();
    qDeleteAll(medium.menu->findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
    medium.actions.clear();
    medium.tools.clear();
    medium.entries = entries;
    QMenu* group = nullptr;
    int groups = 0, icons = 0;
    std::string groupName;
    for (const ipc::MenuEntry& entry : entries) {
        if (entry.group.empty())
            group = nullptr;
        else if (!group || entry.group != groupName)
            group = ++groups > mostGroups
                        ? nullptr
                        : medium.menu->addMenu(plain::caption(QString::fromStdString(entry.group)));
        groupName = entry.group;
        const QString label = QString::fromStdString(entry.label);
        if (label == "-") {
            medium.actions[entry.id] = (group ? group : medium.menu)->addSeparator();
            continue;
        }
        QAction* action = (group ? group : medium.menu)->addAction(plain::caption(label));
        // The tool area would make one of the caption.
        action->setToolTip(plain::tip(label));
        action->setCheckable(entry.checkable);
        if (!entry.icon.empty() && icons++ < mostTools) {
            action->setIcon(controls::iconNamed(QString::fromStdString(entry.icon)));
            if (!action->icon().isNull() && !isPlaying(entry.icon))
                medium.tools.push_back(action);
        }
        const QString id = QString::fromStdString(entry.id);
        connect(action, &QAction::triggered, this,
                [this, documentClass, id] { invoke(documentClass, id); });
        medium.actions[entry.id] = action;
    }
    if (entries.empty())
        medium.menu->addAction(tr("No commands"))->setEnabled(false);
}

QMenu* MediumCommands::menuOf(document::SubdocumentId id) const {
    const media::LiveSubdocument* live = document_.live(id);
    const auto found = live ? media_.find(live->manifest().documentClass) : media_.end();
    return found == media_.end() ? nullptr : found->second.menu;
}

// --- the tool area -----------------------------------------------------------------------------

void MediumCommands::clearTools() {
    for (QAction* action : shown_)
        tools_.removeAction(action);
    shown_.clear();
}

void MediumCommands::refreshTools() {
    const QString owner = toolOwner();
    std::vector<QAction*> wanted;
    const auto medium = media_.find(owner);
    if (medium != media_.end())
        wanted = medium->second.tools;
    if (wanted != shown_) {
        clearTools();
        for (QAction* action : wanted)
            tools_.addAction(action);
        shown_ = wanted;
    }
    const std::vector<media::LiveSubdocument*> all = livesOf(owner);
    owner_->setText(all.empty() ? QString()
                    : all.size() > 1
                        ? tr("%1, all %2 visible")
                              .arg(all.front()->manifest().name, QString::number(all.size()))
                        : all.front()->manifest().name);
    refreshTime();
}

void MediumCommands::refreshTime() {
    const std::vector<media::LiveSubdocument*> all = timed();
    timeAction_->setVisible(!all.empty());
    if (all.empty())
        return;
    const auto playing = std::ranges::find_if(
        all, [](const media::LiveSubdocument* one) { return one->time()->playing; });
    time_->setTime(*(playing == all.end() ? all.front() : *playing)->time());
}

} // namespace window

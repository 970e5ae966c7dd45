#include "edit_mode.h"

#include "frame/placing.h"
#include "frame/seen_style.h"
#include "plain/qt_messages.h"
#include "service/menu.h"
#include "terminal/terminal.h"
#include "text/difference.h"
#include "viewers/editor.h"

#include <QApplication>
#include <QMainWindow>
#include <QSocketNotifier>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace asgard {
namespace {

using service::Clock;
using service::Connection;

template <class Viewer> void raise(Viewer* viewer) {
    viewer->raise();
    viewer->activateWindow();
}

constexpr int keepAfter = 400; // ms; what is typed comes in crowds

class EditMode final : public QObject, public Windows {
public:
    explicit EditMode(Connection& connection)
        : connection_(connection), editor_(views::Workshop{}),
          input_(connection.input(), QSocketNotifier::Read),
          news_(connection.session().descriptor(), QSocketNotifier::Read),
          output_(connection.output(), QSocketNotifier::Write) {
        views::HostLink link;
        link.changed = [this](const text::Edit&, const QString& label) {
            label_ = label;
            propose();
        };
        link.undo = [this] { ask(ipc::EditUndo{}); };
        link.redo = [this] { ask(ipc::EditRedo{}); };
        link.recompute = [this] {
            subdocument().recompute(Clock::now());
            attend();
        };
        link.stopComputing = [this] {
            subdocument().cancel();
            attend();
        };
        link.preview = [this](const std::string& text) {
            preview(text);
            attend();
        };
        link.setLive = [this](views::Live live) {
            const bool waits = subdocument().waitsToBeAsked();
            subdocument().setLive(live);
            if (waits && live != views::Live::never)
                subdocument().recompute(Clock::now());
            attend();
        };
        document().setHostLink(std::move(link));
        // Queued: a change goes to the host before the word that no draft is left.
        QObject::connect(
            &editor_, &views::Editor::viewersChanged, &due_,
            [this] {
                tellWindows();
                keepSoon();
            },
            Qt::QueuedConnection);
        keep_.setSingleShot(true);
        QObject::connect(&keep_, &QTimer::timeout, &keep_, [this] { keepWindows(); });
        qApp->installEventFilter(this);
        due_.setSingleShot(true);
        due_.setTimerType(Qt::PreciseTimer);
        QObject::connect(&input_, &QSocketNotifier::activated, &input_, [this] {
            connection_.receive();
            settle();
        });
        QObject::connect(&news_, &QSocketNotifier::activated, &news_, [this] { attend(); });
        QObject::connect(&output_, &QSocketNotifier::activated, &output_, [this] { attend(); });
        QObject::connect(&due_, &QTimer::timeout, &due_, [this] { attend(); });
        attend();
    }

    std::optional<std::string> open(const std::string& entry,
                                    const std::optional<ipc::ScreenArea>& figure) override {
        const auto before = editor_.viewerWindows();
        openFor(entry);
        if (figure)
            for (QMainWindow* one : editor_.viewerWindows())
                if (!before.contains(one))
                    views::placeBesideFigure(
                        *one, {static_cast<int>(figure->x), static_cast<int>(figure->y),
                               static_cast<int>(figure->width), static_cast<int>(figure->height)});
        return std::nullopt;
    }

    void openFor(const std::string& entry) {
        if (entry == service::updateDrafts)
            for (views::LanguageViewer* viewer : editor_.languageViewers())
                viewer->updateDocument();
        else if (entry.starts_with(service::openThing + " "))
            openAt(entry.substr(service::openThing.size() + 1));
        else if (entry == "open-graphical-viewer")
            raise(editor_.graphicalViewers().isEmpty() ? editor_.openMainWindow()
                                                       : editor_.openGraphicalViewer());
        else
            raise(editor_.openLanguageViewer());
    }

    // The viewer that is open, or one that begins, with the thing of that name selected: as soon as
    // its scene is read, in a process that has just begun.
    void openAt(std::string name) {
        wanted_ = std::move(name);
        const auto open = editor_.graphicalViewers();
        raise(open.isEmpty() ? editor_.openMainWindow() : open.back());
        selectWanted();
    }

    void restore(const std::string& state, const std::string& notice) override {
        followHost(); // the text that the drafts meet
        editor_.restoreWindows(state, QString::fromStdString(notice));
    }

    // Windows that are moved, opened and closed.
    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto type = event->type();
        if ((type == QEvent::Move || type == QEvent::Resize || type == QEvent::Show ||
             type == QEvent::Hide) &&
            qobject_cast<QMainWindow*>(watched) != nullptr)
            keepSoon();
        return false;
    }

private:
    void attend() {
        connection_.attend();
        settle();
    }

    // What the session has come to is what the windows show, and what the loop waits for.
    void settle() {
        if (connection_.closed())
            return QCoreApplication::quit();
        followHost();
        output_.setEnabled(connection_.sending());
        if (const auto deadline = connection_.session().deadline()) {
            const auto rest =
                std::chrono::ceil<std::chrono::milliseconds>(*deadline - Clock::now());
            due_.start(std::max(rest, std::chrono::milliseconds(0)));
        } else {
            due_.stop();
        }
    }

    void preview(const std::string& text) {
        if (text == subdocument().text())
            subdocument().endPreview(Clock::now());
        else
            subdocument().preview(text, Clock::now());
    }

    service::Subdocument& subdocument() { return connection_.session().subdocument(); }
    views::SceneDocument& document() { return editor_.document(); }

    void followHost() {
        const QString title = QString::fromStdString(connection_.session().title());
        if (!title.isEmpty() && title != document().name())
            document().setName(title);
        // A handle that is dragged in the document moves the numbers in the windows too.
        const bool previewed = subdocument().previewing();
        if (!proposed_ && (subdocument().revision() != followed_ || previewed ||
                           std::exchange(preview_, false))) {
            followed_ = subdocument().revision();
            preview_ = previewed;
            document().setTextFromHost(subdocument().shownText());
        }
        followSession();
    }

    // What the session has read and computed; looked at closely only when it is something else.
    void followSession() {
        const service::Subdocument& from = subdocument();
        const Followed now{from.scene(),          from.motion(), from.revision(),
                           document().revision(), from.work(),   from.motionIsStale()};
        if (now == shown_)
            return;
        shown_ = now;
        views::Computed computed;
        if (from.scene())
            computed.shown.scene = from.scene();
        else
            computed.shown.scene = document().shown().scene;
        computed.text = from.scene() ? from.sceneText() : document().shownText();
        computed.shown.motion = from.motion();
        computed.diagnostics = from.faults();
        computed.statistics = from.statistics();
        const bool isOfText = document().text() == from.shownText();
        computed.work = isOfText ? now.work : computing::Work::reading; // it is on its way
        computed.current = from.upToDate() && isOfText;
        computed.stale = from.motionIsStale();
        computed.stopped = from.isCancelled();
        document().setComputed(std::move(computed));
        selectWanted();
    }

    void selectWanted() {
        if (wanted_.empty() || !document().sceneIsCurrent())
            return;
        const std::string name = std::exchange(wanted_, {});
        if (const auto element = service::thingCalled(*document().shown().scene, name))
            document().select({*element});
    }

    void tellWindows() {
        const auto texts = editor_.languageViewers();
        // What follows with the next change is not on its way to the document yet.
        const bool waits =
            proposed_ && !document().isPreview() && document().text() != proposedText_;
        const bool drafts = waits || std::any_of(texts.begin(), texts.end(),
                                                 [](const auto* one) { return one->hasDraft(); });
        const ipc::WindowsChanged now{static_cast<ipc::Integer>(editor_.viewerWindows().size()),
                                      drafts};
        if (now == told_)
            return;
        told_ = now;
        connection_.session().tellWindows(now);
        connection_.flush();
        output_.setEnabled(connection_.sending());
    }

    void keepSoon() {
        if (!keep_.isActive())
            keep_.start(keepAfter);
    }

    // The host keeps it for the process that comes after this one, should this one not live.
    void keepWindows() {
        std::string state = editor_.windowsState();
        if (state == kept_)
            return;
        kept_ = std::move(state);
        connection_.session().keepWindows(kept_);
        connection_.flush();
        output_.setEnabled(connection_.sending());
    }

    // One change at a time is on its way; what was typed meanwhile follows with the next.
    void propose() {
        if (proposed_)
            return;
        const text::Edit edit = text::difference(subdocument().text(), document().text());
        if (edit.empty())
            return document().didAccept(); // it was taken back meanwhile
        proposed_ = true;
        proposedText_ = document().text();
        connection_.session().propose(edit, label_.toStdString(),
                                      [this](const std::optional<std::string>& refusal) {
                                          proposed_ = false;
                                          answered(refusal);
                                          tellWindows();
                                      });
        connection_.flush();
        output_.setEnabled(connection_.sending());
    }

    void answered(const std::optional<std::string>& refusal) {
        followed_ = subdocument().revision();
        // A gesture that began meanwhile asks when it ends, and until then its text is read.
        if (!refusal && document().isPreview())
            return preview(document().text());
        if (!refusal)
            return propose();
        subdocument().endPreview(Clock::now());
        terminal::complain("asgard: the host refused \"" + label_.toStdString() +
                           "\": " + *refusal);
        document().didRefuse(subdocument().text(), QString::fromStdString(*refusal));
    }

    template <class Request> void ask(Request request) {
        connection_.channel().request(request, [](const auto&) {});
        connection_.flush();
        output_.setEnabled(connection_.sending());
    }

    Connection& connection_;
    views::Editor editor_;
    QSocketNotifier input_, news_, output_;
    QTimer due_, keep_;
    ipc::Integer followed_ = -1; // the revision whose text the windows show
    bool proposed_ = false;
    std::string proposedText_; // by the last change
    bool preview_ = false;     // the windows show a gesture's text
    QString label_;            // of the last change
    std::string wanted_;       // the thing that a viewer opens at, when its scene is read
    struct Followed {
        service::ScenePointer scene;
        simulation::MotionPointer motion;
        ipc::Integer revision = -1;
        int documentRevision = -1;
        views::Work work = views::Work::none;
        bool stale = false;
        bool operator==(const Followed&) const = default;
    };
    Followed shown_;           // of the session, by the windows
    ipc::WindowsChanged told_; // what the host knows
    std::string kept_;         // by the host
};

} // namespace

void serveWithWindows(Connection& connection, Windows*& windows) {
    int argc = 1;
    char name[] = "asgard";
    char* argv[] = {name, nullptr};
    plain::printQtMessages("asgard", plain::QtMessages::all);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("asgard")); // whose settings have the panes
    QApplication::setApplicationName(QStringLiteral("asgard"));
    QApplication::setApplicationDisplayName(QStringLiteral("Asgard"));
    QApplication::setStyle(new views::SeenStyle);
    QApplication::setQuitOnLastWindowClosed(false); // the renditions in the document go on
    EditMode mode(connection);
    windows = &mode;
    if (!connection.closed())
        QApplication::exec();
    windows = nullptr;
}

} // namespace asgard

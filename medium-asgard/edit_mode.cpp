#include "edit_mode.h"

#include "views/editor.h"

#include <QApplication>
#include <QSocketNotifier>
#include <QTimer>

#include <clocale>
#include <cstdlib>

namespace asgard {
namespace {

using service::Clock;
using service::Connection;

bool set(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value;
}

template <class Viewer> void raise(Viewer* viewer) {
    viewer->raise();
    viewer->activateWindow();
}

class EditMode final : public Windows {
public:
    EditMode(Connection& connection, views::Workshop workshop)
        : connection_(connection), editor_(std::move(workshop)),
          input_(connection.input(), QSocketNotifier::Read),
          news_(connection.session().descriptor(), QSocketNotifier::Read),
          output_(connection.output(), QSocketNotifier::Write) {
        views::HostLink link;
        link.changed = [this](const views::TextEdit&, const QString& label) { propose(label); };
        link.undo = [this] { ask(ipc::EditUndo{}); };
        link.redo = [this] { ask(ipc::EditRedo{}); };
        editor_.document().setHostLink(std::move(link));
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

    std::optional<std::string> open(const std::string& entry) override {
        if (entry == "open-graphical-viewer")
            raise(editor_.openGraphicalViewer());
        else
            raise(editor_.openLanguageViewer());
        return std::nullopt;
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

    void followHost() {
        const service::Subdocument& subdocument = connection_.session().subdocument();
        if (proposed_ || subdocument.revision() == followed_)
            return;
        followed_ = subdocument.revision();
        if (editor_.document().text() != subdocument.text())
            editor_.document().setTextFromHost(subdocument.text());
    }

    // One change at a time is on its way; what was typed meanwhile follows with the next.
    void propose(const QString& label) {
        if (proposed_)
            return;
        service::Session& session = connection_.session();
        const std::string& before = session.subdocument().text();
        const views::TextEdit edit = views::editBetween(before, editor_.document().text());
        proposed_ = true;
        session.propose(
            {static_cast<ipc::Integer>(edit.from), static_cast<ipc::Integer>(edit.to), edit.text},
            label.toStdString(), [this, label](const std::optional<std::string>& refusal) {
                proposed_ = false;
                answered(refusal, label);
            });
        connection_.flush();
        output_.setEnabled(connection_.sending());
    }

    void answered(const std::optional<std::string>& refusal, const QString& label) {
        const service::Subdocument& subdocument = connection_.session().subdocument();
        if (refusal) {
            std::fprintf(stderr, "asgard: the host refused \"%s\": %s\n", qPrintable(label),
                         refusal->c_str());
            followed_ = -1; // the windows go back to the host's text
        } else {
            followed_ = subdocument.revision();
            if (editor_.document().text() != subdocument.text())
                propose(label);
        }
    }

    template <class Request> void ask(Request request) {
        connection_.channel().request(request, [](const auto&) {});
        connection_.flush();
        output_.setEnabled(connection_.sending());
    }

    Connection& connection_;
    views::Editor editor_;
    QSocketNotifier input_, news_, output_;
    QTimer due_;
    ipc::Integer followed_ = -1; // the revision that the windows show
    bool proposed_ = false;
};

} // namespace

std::string noDisplay() {
    if (set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM"))
        return "";
    return "there is no display to open a window on";
}

script::ReadResult SharedReader::read(int user, std::string_view text,
                                      const std::map<std::string, double>& parameters) {
    const std::lock_guard turn(turn_);
    {
        const std::lock_guard lock(mutex_);
        reads_ = user;
    }
    script::ReadResult result = reader_.read(text, parameters);
    const std::lock_guard lock(mutex_);
    reads_ = 0;
    return result;
}

void SharedReader::cancel(int user) {
    const std::lock_guard lock(mutex_);
    if (reads_ == user)
        reader_.cancel();
}

void serveWithWindows(Connection& connection, SharedReader& reader, int user, Windows*& windows) {
    int argc = 1;
    char name[] = "asgard";
    char* argv[] = {name, nullptr};
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // Qt takes the user's; numbers of scenes have points
    QApplication::setApplicationDisplayName(QStringLiteral("Asgard"));
    QApplication::setQuitOnLastWindowClosed(false); // the renditions in the document go on
    views::Workshop workshop;
    workshop.read = [&reader, user](std::string_view text) { return reader.read(user, text); };
    workshop.cancelReading = [&reader, user] { reader.cancel(user); };
    workshop.simulate = simulation::simulate;
    EditMode mode(connection, std::move(workshop));
    windows = &mode;
    if (!connection.closed())
        QApplication::exec();
    windows = nullptr;
}

} // namespace asgard

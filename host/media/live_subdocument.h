// One subdocument of a medium, whether its process lives or not: what all views of it share.
//
// It holds the text (subdocument_text.h: the document's, kept in step by edit()), the renditions
// (renditions.h), and what the medium last said: menus, time, diagnostics. Its processes follow one
// another (succession.h). When one fails, all of that stays, reason() says in a sentence what
// happened, and it is started again, a few times by itself, else when startAgain() is called;
// windows of its own that were open, it opens again with what was typed there (kept_windows.h). A
// text that no message holds is refused: it has no process until it is shorter. An entry of its
// menu that needs another mode starts a second process in that mode with the current text, moves
// the renditions there, and ends the first.
#pragma once

#include "media/kept_time.h"
#include "media/kept_windows.h"
#include "media/renditions.h"
#include "media/subdocument_text.h"
#include "media/succession.h"
#include "media/value_watch.h"

#include <functional>
#include <memory>
#include <optional>

namespace media {

enum class Condition {
    still,         // no process, and none is needed now
    starting,      // a process is on its way
    live,          // it answers
    notResponding, // it does not, but may again
    failed,        // reason() says why; startAgain() tries again
};

class LiveSubdocument : public QObject {
    Q_OBJECT

public:
    LiveSubdocument(const Manifest& manifest, QString program, PipeThread& pipes,
                    TimeLimits limits = {}, QObject* parent = nullptr);
    ~LiveSubdocument() override;

    [[nodiscard]] const Manifest& manifest() const { return processes_.manifest(); }
    [[nodiscard]] Condition condition() const { return condition_; }
    [[nodiscard]] const QString& reason() const { return reason_; } // of the last failure
    [[nodiscard]] bool hasProcess() const { return processes_.any(); }
    // Something of it is seen already, so that it may be a still.
    [[nodiscard]] bool hasPicture() const { return renditions_.anyPicture(); }
    [[nodiscard]] QString name() const; // what the medium calls itself, else the manifest's

    // --- its text
    void setText(const QByteArray& text); // whole: at first, and after a reload of the document
    void edit(const text::Edits& edits, const QString& label);
    [[nodiscard]] const QByteArray& text() const { return text_.bytes(); }
    void setTitle(const QString& title) { text_.setTitle(title); } // for the medium's own windows
    void onChange(ChangeHandler handler) { text_.onChange(std::move(handler)); }

    // --- its process
    void setMode(Mode mode) { processes_.setMode(mode); } // of the next process
    void start();                                         // if there is none
    void startAgain(); // and forgets past failures: after a click
    [[nodiscard]] bool mayStart() const { return !text_.isTooLong(); } // whatever happened before
    // Perhaps: its process may open some.
    [[nodiscard]] bool hasWindows() const { return processes_.mayHaveWindows(); }
    void makeStill(); // ends the process; pictures and menus stay
    void setPoster(std::optional<double> time) { time_.setPoster(time); } // s; at first

    // --- its renditions
    [[nodiscard]] std::unique_ptr<Rendition> createRendition();
    // As what all of them show it: a name from presentations(). Of another name, and of "", the
    // first counts.
    void setPresentation(const std::string& name);
    [[nodiscard]] std::string presentation() const { return renditions_.presentation(); }
    // As the medium said last; nothing before it did.
    [[nodiscard]] const std::vector<ipc::Presentation>& presentations() const {
        return renditions_.presentations();
    }
    // The size that the medium wants, in 1/96 inch; nothing before it said so.
    [[nodiscard]] std::optional<QSizeF> preferredSize() const {
        return renditions_.preferredSize();
    }
    void setAvailable(QSizeF available); // what there is at most
    struct Snapshot {
        QImage picture;
        QString error;
    };
    void snapshot(QSize pixels, double scale, std::optional<double> time,
                  std::function<void(Snapshot)> done);

    // --- its commands
    [[nodiscard]] const std::vector<ipc::MenuEntry>& menus() const { return said_.menus; }
    // While its process starts or changes, it is done as soon as it can be.
    // `asks` gets the question of a command that wants to know more first.
    using Asks = std::function<void(const ipc::Question& question)>;
    // `figure`: where its user sees it.
    void invoke(const QString& id, const Rendition* rendition,
                std::optional<ipc::ScreenArea> figure = {}, Asks asks = {});
    // The values that answer it, or one of its ways without any. What comes of it may be the next
    // question.
    void answer(ipc::MenuInvoke call, std::function<void(Outcome<ipc::Invoked>)> done);
    // Done when its medium has taken all input so far, and told what has come of it: the menu of
    // what is under the pointer, say. One that is slow is not waited for.
    void whenHeard(std::function<void()> done);
    // Text typed in windows of the medium can be made a change of the text, by the entry
    // `update-drafts` of its menu; then windowsChanged() says that no draft is left.
    [[nodiscard]] bool takesDrafts() const;
    void takeDrafts();
    // Of a medium that moves; nothing for a medium without time.
    [[nodiscard]] const std::optional<ipc::TimeChanged>& time() const { return time_.last(); }
    void play();
    void pause();
    void seek(double time);
    void setRate(double rate, bool loop);

    // --- its values
    // Expressions whose values are told from now on, as its time goes on: valuesChanged().
    void watch(std::vector<std::string> expressions);
    [[nodiscard]] const ValueWatch& watched() const { return watched_; }
    // The values that users may choose from; nothing where the medium offers none.
    void listValues(std::function<void(const std::vector<ipc::ValueOffer>&)> done);
    // At a time, or as it stands, when the motion is known so far: `done` gets one for each, or
    // why there are none.
    void readValues(const std::vector<std::string>& expressions, std::optional<double> time,
                    std::function<void(Outcome<ipc::Values>)> done);

    // Of its own: while they are open its process is not for others to end.
    [[nodiscard]] const ipc::WindowsChanged& windows() const { return said_.windows; }
    // The state of them that the medium wants in its next process, in its own words; "": none.
    [[nodiscard]] const std::string& keptState() const { return kept_.state(); }
    // As keptState() was in an earlier run of the host: the next process opens them.
    void setKeptState(const std::string& state);
    // A sentence about the end of its windows, for the reader until dismissNotice().
    [[nodiscard]] const QString& notice() const { return kept_.notice(); }
    void dismissNotice();
    [[nodiscard]] const ipc::Diagnostics& diagnostics() const { return said_.diagnostics; }
    // The text is loaded and the medium has said what is wrong with it.
    [[nodiscard]] bool hasLoaded() const { return loaded_; }
    // The names of what a slider may drive, as the medium said last; nothing before it answered.
    [[nodiscard]] const std::optional<std::vector<std::string>>& parameters() const {
        return said_.parameters;
    }
    void askForParameters(); // of the text that is loaded

Q_SIGNALS:
    void conditionChanged();
    void menusChanged();
    void timeChanged();
    void diagnosticsChanged();
    void parametersChanged();
    void presentationsChanged();
    void preferredSizeChanged();
    void valuesChanged(); // of what is watched
    void loaded();
    void undoRequested();
    void redoRequested();
    void message(const QString& text); // for the status line
    void firstPicture();
    void windowsChanged();
    void keptStateChanged();
    void processGone(); // there is room for another one

private:
    friend class Rendition;
    void forget(const Rendition& rendition) { renditions_.forget(rendition); }

    void followProcesses();
    void adopt();
    void load();
    void askForPresentations();
    void steer(const KeptTime::Commands& commands);
    void restoreWindows(const QString& why);
    void askForSize();
    void told(const ipc::ToHost& report);
    void toldOfRenditions(const ipc::ToHost& report);
    void asked(MediumProcess& by, const ipc::Id& id, const ipc::ToHost& request);
    void takeFrame(const ipc::RenditionFrame& frame);
    void applyChange(MediumProcess& by, const ipc::Id& id, const ipc::SubdocumentChanged& change);
    void processLeft(const MediumProcess& process);
    void processFailed(const QString& reason, bool mayStartAgain);
    void invokeWaiting();
    void setCondition(Condition condition);
    [[nodiscard]] bool isReady() const { return processes_.isReady(); }
    [[nodiscard]] bool hasCurrent() const { return processes_.current() != nullptr; }
    [[nodiscard]] MediumProcess& process() { return *processes_.current(); }
    [[nodiscard]] bool judgeText(bool wasTooLong);

    struct Said { // by the medium, last; it outlives the process
        QString name;
        std::vector<ipc::MenuEntry> menus;
        ipc::Diagnostics diagnostics;
        std::optional<std::vector<std::string>> parameters;
        ipc::WindowsChanged windows;
    };
    struct Invocation { // of an entry of the menu
        QString id;
        ipc::Integer rendition; // 0: none
        std::optional<ipc::ScreenArea> figure;
        Asks asks;
    };

    SubdocumentText text_;
    Succession processes_;
    Condition condition_ = Condition::still;
    QString reason_;
    bool loaded_ = false;
    Renditions renditions_;
    Said said_;
    std::vector<Invocation> whenReady_;
    KeptTime time_;
    ValueWatch watched_;
    KeptWindows kept_;
};

} // namespace media

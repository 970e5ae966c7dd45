// A medium's side of the protocol for one animation: what the host asks becomes scene, time and
// pictures, and what happens here is told to the host.
//
// Serves any event loop (serve.h is the plain one; a window system's will do): give each call of
// the host to receive(), then call attend(); call attend() too when descriptor() is readable and
// when deadline() has come. No deadline and nothing readable: there is nothing to do, and nothing
// is done. All of it belongs to one thread. Others work beside it: the worker's read and compute,
// the renderer's draws pictures, and that of the sheets samples plots. So the host is answered
// however long a picture takes; its frame goes out when it is drawn.
//
// Pictures are owed when a visible rendition would look different and the host has acknowledged
// what it was sent. They are at most 60 a second and, but during a gesture, at most half of their
// thread's time.
#pragma once

#include "ipc/channel.h"
#include "service/closing_search.h"
#include "service/handle_editing.h"
#include "service/menu.h"
#include "service/pictures.h"
#include "service/rendition.h"
#include "service/selection.h"
#include "service/subdocument.h"
#include "service/value_reader.h"

namespace service {

// Smooth edges cost time that a moving picture needs for the next one.
inline constexpr int movingSamples = 1, stillSamples = 4, printedSamples = 8;

inline constexpr std::chrono::milliseconds shortestFrame{16};

inline constexpr const char* beingRead = "The text is being read; a moment, and it can be changed.";

// A refusal with a sentence for the user.
[[nodiscard]] inline ipc::Error notPossible(std::string sentence) {
    return {ipc::ErrorCode::notPossible, std::move(sentence)};
}

// The services that a session needs of its process.
struct Platform {
    Tools tools;
    std::unique_ptr<render::DrawingThread> thread = std::make_unique<render::DrawingThread>();
    Draw draw;                              // on that thread
    std::string noPictures;                 // why `draw` is empty
    int maximumSize = 4096;                 // of a picture
    std::function<void()> inSpareTime;      // on the thread, once, a while after the first picture
    std::function<void(ipc::Mode)> confine; // called before anything of a document is looked at
    // Opens the window that a menu entry names, in mode edit; else the sentence why not.
    // `figure`: beside it, where that is known.
    std::function<std::optional<std::string>(const std::string& id,
                                             const std::optional<ipc::ScreenArea>& figure)>
        openViewer;
    // Opens the windows that an earlier process had open, and says there what happened.
    std::function<void(const std::string& state, const std::string& notice)> restoreWindows;
    std::string version;
};

class Session {
public:
    Session(Platform platform, ipc::MediumChannel& channel);

    void receive(const ipc::MediumChannel::Call& call, Instant now);
    void attend(Instant now);
    [[nodiscard]] int descriptor() const { return subdocument_.descriptor(); }
    [[nodiscard]] std::optional<Instant> deadline() const;
    [[nodiscard]] bool over() const { return host_.over; }
    // A picture is on its way; descriptor() becomes readable when it is there.
    [[nodiscard]] bool draws() const { return pictures_.drawsAny(); }

    [[nodiscard]] Subdocument& subdocument() { return subdocument_; }
    [[nodiscard]] const ValueSource& valueSource() const { return values_; }
    [[nodiscard]] const std::string& title() const { return host_.title; } // for windows; may be ""
    // One change of the text, made in one of the medium's windows: it is the host's to accept. Then
    // it is the text here too, and `done` hears nothing; else why not.
    void propose(const text::Edit& edit, const std::string& label,
                 std::function<void(std::optional<std::string> refusal)> done);
    void tellWindows(const ipc::WindowsChanged& windows);
    void keepWindows(const std::string& state) { channel_.notify(ipc::SessionKeep{state}); }
    [[nodiscard]] const std::optional<ipc::Mode>& mode() const {
        return host_.mode;
    } // none: not yet

private:
    template <class Result> using Reply = ipc::Outcome<Result>;
    struct Subscription {
        std::vector<std::string> expressions;
        std::optional<ValueReader> reader; // of the motion as it is
        std::optional<ipc::Values> told;
    };
    // A request that is answered when the motion is known far enough.
    struct Waiting {
        std::function<bool(Instant)> ready;
        std::function<void()> answer;
    };

    // The state that belongs together.
    struct Host {
        std::string title; // what the host calls the subdocument
        std::optional<ipc::Mode> mode;
        bool drafts = false; // in windows
        bool over = false;   // it said so
    };
    struct Shown {
        std::optional<FrameMemory> memory;
        std::map<ipc::Integer, Rendition> all;
        render::Display display; // that new renditions start with
        double time = 0;         // of the pictures and values that are made now
    };
    struct Moment {
        Instant now{}; // of the call that is being served
        std::optional<Instant> due;
    };
    struct Gesture {
        HandleEditing handles;
        Selection selection;
        struct Press { // that may be a click
            ipc::Integer in = 0;
            Eigen::Vector2d pixels;
            ipc::Button button = ipc::Button::none;
        };
        std::optional<Press> press;
        ipc::Integer in = 0;    // the rendition whose handle is held
        bool holdsTime = false; // of what played when a body was taken
        std::string toldWords, refusedWords;
        std::optional<ipc::Integer> token; // of what is told of it
        struct Ways {                      // in place of what could not be
            gestures::Ground ground;
            ipc::Integer revision = 0; // of its text
            std::string label;
            std::vector<editing::Offer> all;
            bool inMenu = false; // else a question has them
        };
        std::optional<Ways> ways;
        struct Asked { // a question that waits; the figure may have lost the keyboard to it
            ThingCommand command;
            std::string name; // of the thing
        };
        std::optional<Asked> asked;
        ClosingSearch closing;
        std::optional<gestures::Ground> closingOn; // the text that is searched for
    };
    struct Pace {
        Instant calmAt{}; // until then the user is moving through time
        std::optional<Instant> firstFrame;
        Instant nextFrame{}; // no round of pictures begins before
        // One picture of each rendition that owes one: the newest look when its turn comes.
        struct Round {
            unsigned number = 0;
            int drawn = 0; // now, by the thread
            Instant began{};
            Clock::duration cost{};
        } round;
    };
    struct Told {
        std::optional<ipc::TimeChanged> time;
        Instant nextTime{}, nextValues{};
        std::optional<MenuState> menu;
        std::optional<ipc::Diagnostics> diagnostics;
    };
    struct Progress {
        std::optional<ipc::Integer> token; // of what was begun
        ipc::Integer lastToken = 0;
        Instant next{};
    };

    // --- session_calls.cpp: what the host asks. Those with an id answer by themselves.
    Reply<ipc::Initialized> serve(const ipc::Initialize& call);
    Reply<ipc::Done> serve(const ipc::Ping&) { return ipc::Done{}; }
    Reply<ipc::Done> serve(const ipc::SubdocumentLoad& call);
    Reply<ipc::Done> serve(const ipc::SubdocumentEdit& call);
    Reply<ipc::Presentations> serve(const ipc::PresentationList&);
    void serve(const ipc::Id& id, const ipc::PresentationSize& call);
    Reply<ipc::Exported> serve(const ipc::PresentationExport& call);
    Reply<ipc::Done> serve(const ipc::RenditionCreate& call);
    void serve(const ipc::Id& id, const ipc::RenditionResize& call);
    void serve(const ipc::Id& id, const ipc::RenditionDestroy& call);
    void serve(const ipc::Id& id, const ipc::RenditionSnapshot& call);
    Reply<ipc::Invoked> serve(const ipc::MenuInvoke& call);
    Reply<ipc::Done> serve(const ipc::TimePlay&);
    Reply<ipc::Done> serve(const ipc::TimePause&);
    Reply<ipc::Done> serve(const ipc::TimeSeek& call);
    Reply<ipc::Done> serve(const ipc::TimeRate& call);
    Reply<ipc::Parameters> serve(const ipc::ParameterList&);
    Reply<ipc::ValueOffers> serve(const ipc::ValueList&);
    void serve(const ipc::Id& id, const ipc::ValueRead& call);
    Reply<ipc::Done> serve(const ipc::ValueSubscribe& call);
    Reply<ipc::Done> serve(const ipc::ValueUnsubscribe& call);
    Reply<ipc::Evaluated> serve(const ipc::ScriptEvaluate& call);
    Reply<ipc::Done> serve(const ipc::Shutdown&) { return ipc::Done{}; }

    void hear(const ipc::SessionRestore& call);
    void hear(const ipc::RenditionShow& call);
    void hear(const ipc::RenditionHide& call);
    void hear(const ipc::RenditionAck& call);
    void hear(const ipc::RenditionInput& call);
    void hear(const ipc::ParameterSet& call);
    void hear(const ipc::ProgressCancel&) { subdocument_.cancel(); }
    void hear(const ipc::Exit&) { host_.over = true; }

    // --- session_gestures.cpp: handles that the pointer drags in a rendition
    bool edit(Rendition& rendition, const ipc::Input& input); // false: it is for the view
    // The same of what no modifier makes a drag of handles: clicks, and drags of what is selected.
    bool choose(Rendition& rendition, const ipc::Input& input, const HandleEditing::Pointer& at);
    void openCrowd(Rendition& rendition, const Eigen::Vector2d& pixels); // under the pointer
    bool hold(Rendition& rendition, const ipc::Input& input, std::optional<std::size_t> body,
              const HandleEditing::Pointer& pointer);
    [[nodiscard]] HandleEditing::Picture pictureOf(Rendition& rendition);
    bool selectionKey(const std::string& name);
    void changeSelected(bool isRemoved);
    void holdViews();

    // --- session_things.cpp: what is done with the selected thing, and what is offered
    Reply<ipc::Invoked> invokeOfTheMoment(const ipc::MenuInvoke& call);
    struct Typed { // into the fields of a question
        std::vector<std::string> values = {};
        bool isTrial = false; // nothing is to be done
    };
    Reply<ipc::Invoked> doNow(const ThingCommand& command, const std::string& name,
                              const Typed& typed);
    Reply<ipc::Invoked> doWith(const ThingCommand& command, const editing::Element& element,
                               const Typed& typed);
    Reply<ipc::Invoked> answerAsked(const gestures::Ground& on, const commands::AskedValue& asked,
                                    const Typed& typed);
    Reply<ipc::Invoked> fix(const gestures::Ground& on, std::size_t body);
    Reply<ipc::Invoked> takeWay(std::size_t number);
    void keepWays(const gestures::Ground& on, std::string label, std::vector<editing::Offer> offers,
                  bool inMenu);
    Reply<ipc::Invoked> closeJointsOrStop();
    void takeClosed();
    [[nodiscard]] std::string offerToClose() const; // "": there is none
    void tellUser(const std::string& sentence);
    Reply<ipc::Invoked> openWindow(const ipc::MenuInvoke& call);
    [[nodiscard]] gestures::Ground ground();
    void finishGesture(const std::string& text, const std::string& label);
    void goOn();
    void tellGesture();
    void tellHint(const Rendition& rendition); // what pointer and keys do in it

    std::optional<std::string> shape(Rendition& rendition, const ipc::RenditionGeometry& geometry);
    std::optional<ipc::Error> noPicture(Presentation of, ipc::Integer width,
                                        ipc::Integer height) const;
    void inputToSheet(Rendition& rendition, const ipc::Input& input);
    [[nodiscard]] static bool usesKey(const std::string& name);
    bool key(const std::string& name); // true: used
    // The reader says whether it plays, whatever a hand held before.
    [[nodiscard]] Playback& playedByReader();
    std::vector<Rendition*> targets(std::optional<ipc::Integer> rendition);

    // --- session_commands.cpp: script/evaluate
    Reply<ipc::Evaluated> evaluate(const std::string& script);
    Reply<ipc::Values> values(const std::vector<std::string>& expressions,
                              std::optional<double> time);
    [[nodiscard]] ValueReader valuesOf(const std::vector<std::string>& expressions);

    // --- session.cpp: what is told and drawn
    [[nodiscard]] bool settled(Instant now) const;
    [[nodiscard]] bool knownAt(double time, Instant now) const;
    void answerWaiting();
    void tellDiagnostics();
    void tellProgress();
    void tellTime();
    void tellValues();
    void tellMenu();
    void tellStates();
    [[nodiscard]] ipc::TimeChanged timeNow() const;
    [[nodiscard]] MenuState menuNow();
    [[nodiscard]] bool anyVisible() const;
    // Something is due then, if nothing happens before.
    void dueAt(Instant instant);

    // --- session_pictures.cpp: what is drawn
    [[nodiscard]] bool moving(const Rendition& rendition) const;
    [[nodiscard]] const scene::Scene& drawnScene() const;
    [[nodiscard]] Look lookOf(Rendition& rendition) const;
    [[nodiscard]] render::Drawing drawingOf(const Look& look) const;
    void drawOwed();
    bool replaces(Rendition& rendition, const Look& look);
    bool takeBack(Rendition& rendition); // its picture that waits is not drawn; false: none waits
    bool mayBegin(const Rendition& rendition);
    void draw(ipc::Integer id, Rendition& rendition, const Look& look);
    void finish(ipc::Integer id, Rendition::Frame& frame, Pictures::Drawn drawn);
    void endOne(Clock::duration cost); // of the round
    void send(Rendition& rendition, Rendition::Frame& frame);
    void losePictures();
    void answerWhenFree(const ipc::Id& id, Rendition& rendition);
    std::optional<ipc::Error> take(const ipc::Id& id, const ipc::RenditionSnapshot& call);
    [[nodiscard]] render::Drawing printed(const ipc::RenditionSnapshot& call, double time,
                                          render::Size size);
    void useSpareTime();

    template <class Result> void reply(const ipc::Id& id, Reply<Result> outcome) {
        if (const auto* error = std::get_if<ipc::Error>(&outcome))
            channel_.refuse(id, *error);
        else
            channel_.answer(id, std::get<Result>(std::move(outcome)));
    }

    Platform platform_;
    ipc::MediumChannel& channel_;
    Subdocument subdocument_;
    Sheets sheets_{subdocument_};
    Host host_;
    Shown shown_;
    Moment at_;
    std::map<ipc::Integer, Subscription> subscriptions_;
    ValueSource values_;
    std::vector<Waiting> waiting_;
    Gesture gesture_;
    Pace pace_;
    Told told_;
    Progress progress_;
    Pictures pictures_{std::move(platform_.thread), platform_.draw,
                       [this] { subdocument_.wake(); }}; // the first to go
};

} // namespace service

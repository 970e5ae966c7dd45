#include "console/check_medium.h"

#include "console/convert.h"
#include "console/raw_medium.h"
#include "ipc/framing.h"
#include "terminal/terminal.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>
#include <set>

namespace console {

namespace {

constexpr int pingMs = 2'000;
constexpr int quietMs = 400; // long enough for a frame that should not come
constexpr int frameMs = 10'000;
constexpr int endMs = 2'000;

void require(bool holds, const std::string& otherwise) {
    if (!holds)
        throw Wrong(otherwise);
}

template <class Outcome>
void requireError(const Outcome& outcome, ipc::ErrorCode code, const std::string& what) {
    const auto* error = std::get_if<ipc::Error>(&outcome);
    require(error != nullptr, what + " was not refused");
    require(error->code == static_cast<ipc::Integer>(code),
            what + " was refused with " + std::to_string(error->code) + " instead of " +
                std::to_string(static_cast<int>(code)));
}

// A medium that is loaded and has one rendition.
struct Ready {
    Ready(RawMedium& of, int w, int h, bool withFrames = true) : medium(of), width(w), height(h) {
        introduction = medium.introduce(1, 1, withFrames);
        medium.mustAnswer(ipc::SubdocumentLoad{"", 1});
        const auto list = medium.mustAnswer(ipc::PresentationList{});
        require(!list.items.empty(), "it has no presentation");
        presentation = list.items.front().id;
        medium.mustAnswer(ipc::RenditionCreate{geometry(1, w, h, withFrames)});
    }
    ipc::RenditionGeometry geometry(ipc::Integer id, int w, int h, bool withFrames = true) {
        ipc::RenditionGeometry result;
        result.rendition = id;
        result.presentation = presentation;
        result.width = w;
        result.height = h;
        for (int i = 0; i < 2 && withFrames; ++i) {
            const auto slot = medium.frames().allocate(w, h);
            require(slot.has_value(), "the test has no memory left");
            result.slots.push_back({slot->offset, slot->stride});
        }
        return result;
    }
    ipc::RenditionFrame frame(ipc::Integer id, int w, int h) {
        ipc::RenditionFrame result;
        const bool came = medium.waitFor(
            [&](const ipc::ToHost& report) {
                const auto* frame = std::get_if<ipc::RenditionFrame>(&report);
                if (!frame || frame->rendition != id || frame->width != w || frame->height != h)
                    return false;
                result = *frame;
                return true;
            },
            frameMs);
        require(came, "no frame of " + std::to_string(w) + "x" + std::to_string(h) + " came");
        return result;
    }
    int waitingFrames() {
        medium.listen(quietMs);
        int count = 0;
        for (const ipc::ToHost& report : medium.reports())
            count += std::holds_alternative<ipc::RenditionFrame>(report);
        return count;
    }

    RawMedium& medium;
    int width, height;
    ipc::Initialized introduction;
    std::string presentation;
};

struct Check {
    const char* name;
    void (*run)(RawMedium&);
};

// --- beginning and end -------------------------------------------------------------------------

void introducesItself(RawMedium& medium) {
    const ipc::Initialized is = medium.introduce();
    require(is.protocol == 1, "it answers with protocol " + std::to_string(is.protocol));
    require(!is.name.empty(), "it has no name");
}

void refusesUnknownVersions(RawMedium& medium) {
    ipc::Initialize call;
    call.oldest = call.newest = 99;
    call.documentClass = "CHECK";
    requireError(medium.ask(call), ipc::ErrorCode::noCommonVersion, "protocol 99");
    require(!medium.waitForEnd(endMs).empty(), "it goes on after refusing the version");
}

void endsOnShutdown(RawMedium& medium) {
    medium.introduce();
    medium.mustAnswer(ipc::Shutdown{}, endMs);
    medium.tell(ipc::Exit{});
    const std::string end = medium.waitForEnd(endMs);
    require(!end.empty(), "it is still there 2 s after exit");
    require(end == "ended with exit code 0", "it " + end);
}

void endsWithItsInput(RawMedium& medium) {
    medium.introduce();
    medium.mustAnswer(ipc::SubdocumentLoad{"", 1});
    medium.closeInput();
    require(!medium.waitForEnd(endMs).empty(), "it is still there 2 s after its input ended");
}

// --- messages ----------------------------------------------------------------------------------

void answersPings(RawMedium& medium) {
    medium.introduce();
    medium.mustAnswer(ipc::Ping{}, pingMs);
}

void answersPingsWhileBusy(RawMedium& medium) {
    medium.introduce();
    const std::string large(200'000, 'x');
    medium.send(ipc::SubdocumentLoad{large, 1});
    for (int i = 0; i < 5; ++i)
        medium.mustAnswer(ipc::Ping{}, pingMs);
}

void refusesUnknownRequests(RawMedium& medium) {
    medium.introduce();
    const ipc::Integer id = medium.nextId();
    const std::string body =
        R"({"jsonrpc":"2.0","id":)" + std::to_string(id) + R"(,"method":"no/such","params":{}})";
    requireError(medium.askRaw(body, id, ipc::Ping{}), ipc::ErrorCode::methodNotFound,
                 "an unknown request");
}

void ignoresUnknownNotificationsAndFields(RawMedium& medium) {
    medium.introduce();
    medium.sendBytes(ipc::framed(R"({"jsonrpc":"2.0","method":"no/such","params":{"a":1}})"));
    const ipc::Integer id = medium.nextId();
    const std::string body = R"({"jsonrpc":"2.0","id":)" + std::to_string(id) +
                             R"(,"method":"ping","params":{"unknown":[1,2]}})";
    require(std::holds_alternative<ipc::AnyResult>(medium.askRaw(body, id, ipc::Ping{})),
            "a ping with an unknown field was refused");
}

void refusesFaultyParameters(RawMedium& medium) {
    medium.introduce();
    const ipc::Integer id = medium.nextId();
    const std::string body = R"({"jsonrpc":"2.0","id":)" + std::to_string(id) +
                             R"(,"method":"subdocument/load","params":{"text":7}})";
    requireError(medium.askRaw(body, id, ipc::Ping{}), ipc::ErrorCode::invalidParameters,
                 "a text that is a number");
    medium.mustAnswer(ipc::Ping{}, pingMs);
}

void readsAnySplitOfItsInput(RawMedium& medium) {
    medium.introduce();
    std::string all;
    std::vector<ipc::Integer> ids;
    for (int i = 0; i < 3; ++i)
        all += ipc::framed(R"({"jsonrpc":"2.0","method":"no/such","params":{}})");
    medium.sendBytes(all);
    const std::string one = ipc::framed(R"({"jsonrpc":"2.0","method":"no/such","params":{}})");
    for (const char byte : one)
        medium.sendBytes(std::string(1, byte));
    medium.mustAnswer(ipc::Ping{}, pingMs);
}

// Bytes that are not the protocol end it, by itself and not by a crash.
void endsOnBytes(RawMedium& medium, const std::string& bytes) {
    medium.introduce();
    medium.sendBytes(bytes);
    const std::string end = medium.waitForEnd(endMs);
    require(!end.empty(), "it goes on after bytes that are not the protocol");
    require(end.find("signal") == std::string::npos, "it " + end);
}
void endsOnGarbage(RawMedium& medium) { endsOnBytes(medium, std::string(3000, '\xff')); }
void endsOnOversize(RawMedium& medium) {
    endsOnBytes(medium, "Content-Length: 99999999999999\r\n\r\n");
}
void endsOnWhatIsNotJson(RawMedium& medium) { endsOnBytes(medium, ipc::framed("{\"jsonrpc\":")); }

// --- text --------------------------------------------------------------------------------------

void reportsDiagnostics(RawMedium& medium) {
    medium.introduce();
    medium.mustAnswer(ipc::SubdocumentLoad{"", 7});
    require(medium.waitFor(
                [](const ipc::ToHost& report) {
                    const auto* diagnostics = std::get_if<ipc::Diagnostics>(&report);
                    return diagnostics && diagnostics->revision == 7;
                },
                frameMs),
            "no diagnostics of the revision came");
}

void editsText(RawMedium& medium) {
    medium.introduce();
    medium.mustAnswer(ipc::SubdocumentLoad{"abc \xc3\xa4", 1});
    medium.mustAnswer(ipc::SubdocumentEdit{2, {{0, 1, "x"}, {4, 6, ""}}, "check"});
    require(medium.waitFor(
                [](const ipc::ToHost& report) {
                    const auto* diagnostics = std::get_if<ipc::Diagnostics>(&report);
                    return diagnostics && diagnostics->revision == 2;
                },
                frameMs),
            "no diagnostics of the edited text came");
}

void refusesEditsOutsideOfTheText(RawMedium& medium) {
    medium.introduce();
    medium.mustAnswer(ipc::SubdocumentLoad{"abc", 1});
    requireError(medium.ask(ipc::SubdocumentEdit{2, {{2, 90, ""}}, "check"}),
                 ipc::ErrorCode::notPossible, "an edit outside of the text");
    medium.mustAnswer(ipc::SubdocumentLoad{"abc", 2});
}

// --- pictures ----------------------------------------------------------------------------------

void wantsASize(RawMedium& medium) {
    medium.introduce();
    medium.mustAnswer(ipc::SubdocumentLoad{"", 1});
    const auto list = medium.mustAnswer(ipc::PresentationList{});
    require(!list.items.empty(), "it has no presentation");
    ipc::PresentationSize call;
    call.presentation = list.items.front().id;
    call.availableWidth = 600;
    const ipc::PreferredSize size = medium.mustAnswer(call);
    require(size.width >= 1 && size.height >= 1, "it wants to have no size");
}

void drawsFrames(RawMedium& medium) {
    Ready ready(medium, 120, 80);
    require(ready.waitingFrames() == 0, "it draws before rendition/show");
    medium.tell(ipc::RenditionShow{1});
    const ipc::RenditionFrame frame = ready.frame(1, 120, 80);
    require(!frame.pixels, "pixels came by the pipe although there is shared memory");
    require(frame.slot == 0 || frame.slot == 1, "there is no such slot");
    medium.tell(ipc::RenditionAck{1, frame.serial});
}

void waitsForAcknowledgements(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    medium.tell(ipc::RenditionShow{1});
    for (int i = 2; i < 12; ++i)
        medium.mustAnswer(ipc::SubdocumentLoad{std::string(static_cast<std::size_t>(i), ' '), i});
    static_cast<void>(medium.ask(ipc::TimePlay{}));
    const int waiting = ready.waitingFrames();
    require(waiting <= 2, std::to_string(waiting) + " frames came without acknowledgement");
}

void drawsNothingWhileHidden(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    medium.tell(ipc::RenditionShow{1});
    medium.tell(ipc::RenditionAck{1, ready.frame(1, 60, 40).serial});
    medium.tell(ipc::RenditionHide{1});
    medium.mustAnswer(ipc::Ping{}, pingMs);
    medium.reports().clear();
    medium.mustAnswer(ipc::SubdocumentLoad{" ", 2});
    require(ready.waitingFrames() == 0, "it draws while hidden");
}

void followsResizes(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    medium.tell(ipc::RenditionShow{1});
    medium.tell(ipc::RenditionAck{1, ready.frame(1, 60, 40).serial});
    medium.mustAnswer(ipc::RenditionResize{ready.geometry(1, 90, 70)});
    medium.tell(ipc::RenditionAck{1, ready.frame(1, 90, 70).serial});
}

void servesSeveralRenditions(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    medium.mustAnswer(ipc::RenditionCreate{ready.geometry(2, 200, 100)});
    medium.tell(ipc::RenditionShow{1});
    medium.tell(ipc::RenditionShow{2});
    const auto first = ready.frame(1, 60, 40), second = ready.frame(2, 200, 100);
    medium.tell(ipc::RenditionAck{1, first.serial});
    medium.tell(ipc::RenditionAck{2, second.serial});
    medium.mustAnswer(ipc::RenditionDestroy{2});
    medium.reports().clear();
    medium.mustAnswer(ipc::SubdocumentLoad{" ", 2});
    medium.listen(quietMs);
    for (const ipc::ToHost& report : medium.reports())
        if (const auto* frame = std::get_if<ipc::RenditionFrame>(&report))
            require(frame->rendition != 2, "a frame came after rendition/destroy");
}

void takesSnapshots(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    const auto slot = medium.frames().allocate(150, 100);
    ipc::RenditionSnapshot call;
    call.presentation = ready.presentation;
    call.width = 150;
    call.height = 100;
    call.offset = slot->offset;
    call.stride = slot->stride;
    const auto outcome = medium.ask(call, 3 * RawMedium::answerMs);
    if (const auto* error = std::get_if<ipc::Error>(&outcome))
        require(error->code == static_cast<ipc::Integer>(ipc::ErrorCode::notPossible),
                "a snapshot was refused: " + error->message);
}

void sendsPixelsWithoutSharedMemory(RawMedium& medium) {
    Ready ready(medium, 30, 20, false);
    medium.tell(ipc::RenditionShow{1});
    const ipc::RenditionFrame frame = ready.frame(1, 30, 20);
    require(frame.pixels.has_value(), "a frame without shared memory has no pixels");
    const std::size_t most = (30 * 20 * 4 + 2) / 3 * 4;
    require(frame.pixels->size() == most, "the pixels are not 4 x width x height bytes in base64");
}

void takesInput(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    medium.tell(ipc::RenditionShow{1});
    for (const ipc::InputType type :
         {ipc::InputType::focusIn, ipc::InputType::move, ipc::InputType::press,
          ipc::InputType::move, ipc::InputType::release, ipc::InputType::wheel,
          ipc::InputType::keyPress, ipc::InputType::keyRelease, ipc::InputType::focusOut}) {
        ipc::RenditionInput input;
        input.rendition = 1;
        input.type = type;
        input.x = input.y = 20;
        input.dy = 1;
        input.button = ipc::Button::left;
        input.key = "F12";
        medium.tell(input);
    }
    medium.mustAnswer(ipc::Ping{}, pingMs);
}

// --- commands and time -------------------------------------------------------------------------

void hasUsableMenus(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    std::set<std::string> ids;
    for (const ipc::MenuEntry& entry : ready.introduction.menus) {
        require(!entry.id.empty() && !entry.label.empty(), "an entry has no id or label");
        require(ids.insert(entry.id).second, "two entries have the id " + entry.id);
    }
    const auto outcome = medium.ask(ipc::MenuInvoke{"no such entry", std::nullopt});
    require(std::holds_alternative<ipc::Error>(outcome), "an unknown entry was not refused");
}

void keepsTimeOrRefusesIt(RawMedium& medium) {
    Ready ready(medium, 60, 40);
    const auto& can = ready.introduction.capabilities;
    const bool hasTime = std::find(can.begin(), can.end(), "time") != can.end();
    if (!hasTime) {
        requireError(medium.ask(ipc::TimePlay{}), ipc::ErrorCode::notPossible,
                     "time/play of a medium without time");
        return;
    }
    for (const auto& outcome : {medium.ask(ipc::TimeSeek{0}), medium.ask(ipc::TimePause{}),
                                medium.ask(ipc::TimeRate{2, true})})
        if (const auto* error = std::get_if<ipc::Error>(&outcome))
            require(error->code == static_cast<ipc::Integer>(ipc::ErrorCode::notPossible),
                    "time was refused: " + error->message);
}

constexpr Check checks[] = {
    {"introduces itself", introducesItself},
    {"refuses unknown versions and ends", refusesUnknownVersions},
    {"answers pings", answersPings},
    {"answers pings while busy", answersPingsWhileBusy},
    {"refuses unknown requests", refusesUnknownRequests},
    {"ignores unknown notifications and fields", ignoresUnknownNotificationsAndFields},
    {"refuses faulty parameters", refusesFaultyParameters},
    {"reads any split of its input", readsAnySplitOfItsInput},
    {"reports diagnostics of a text", reportsDiagnostics},
    {"edits its text", editsText},
    {"refuses edits outside of the text", refusesEditsOutsideOfTheText},
    {"wants a size", wantsASize},
    {"draws frames once shown", drawsFrames},
    {"waits for acknowledgements", waitsForAcknowledgements},
    {"draws nothing while hidden", drawsNothingWhileHidden},
    {"follows resizes", followsResizes},
    {"serves several renditions", servesSeveralRenditions},
    {"takes snapshots", takesSnapshots},
    {"sends pixels without shared memory", sendsPixelsWithoutSharedMemory},
    {"takes input", takesInput},
    {"has usable menus", hasUsableMenus},
    {"keeps time or refuses it", keepsTimeOrRefusesIt},
    {"ends on garbage", endsOnGarbage},
    {"ends on an oversize message", endsOnOversize},
    {"ends on what is not JSON", endsOnWhatIsNotJson},
    {"ends on shutdown", endsOnShutdown},
    {"ends with its input", endsWithItsInput},
};

} // namespace

int checkMedium(const QStringList& command) {
    QString program = command.first();
    if (program.contains('/'))
        program = QFileInfo(program).absoluteFilePath();
    else
        program = QStandardPaths::findExecutable(program, {QCoreApplication::applicationDirPath()})
                          .isEmpty()
                      ? QStandardPaths::findExecutable(program)
                      : QCoreApplication::applicationDirPath() + '/' + program;
    if (program.isEmpty() || !QFileInfo(program).isExecutable()) {
        terminal::complain("ensemble: there is no program \"" + command.first().toStdString() +
                           '"');
        return failure;
    }
    media::PipeThread pipes;
    int failed = 0;
    for (const Check& check : checks) {
        try {
            RawMedium medium(pipes, program, command.mid(1));
            check.run(medium);
            terminal::say(std::string("ok   ") + check.name);
        } catch (const Wrong& wrong) {
            ++failed;
            terminal::say(std::string("FAIL ") + check.name + ": " + wrong.what());
        }
    }
    terminal::say(std::to_string(std::size(checks)) + " checks, " + std::to_string(failed) +
                  " failed");
    return failed == 0 ? success : failure;
}

} // namespace console

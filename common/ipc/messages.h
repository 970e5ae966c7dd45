// The medium protocol as a file: every message that a host and a medium send each other.
//
// Calls from the host are imperative, a medium's report what happened. A struct with a `Result` is
// a request, one without is a notification; `method` is its name on the wire. Defaults are those of
// fields that may be left out. The meaning of each: docs/medium-protocol.md; the field names and
// the ranges they must keep to: fields.h.
//
// Offsets are UTF-8 bytes of the unescaped storage text, times seconds, sizes device pixels, line
// and column from 1. Identifiers are whole numbers that the one who makes the thing chooses.
#pragma once

#include "text/edit.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ipc {

using Integer = std::int64_t;

// --- parts of messages ------------------------------------------------------------------------

enum class Mode { play, edit, batch };
enum class Scope { rendition, subdocument };
enum class InputType { press, release, move, wheel, keyPress, keyRelease, focusIn, focusOut };
enum class Button { none, left, middle, right, back, forward };
enum class Modifier { shift, control, alt, meta };
enum class CursorShape { arrow, hand, grab, grabbing, cross, text, wait, forbidden };
enum class MotionState { current, draft, computing, stale, failed };
enum class Severity { error, warning };

struct SharedMemory {
    Integer fd = 0;    // of the medium's process
    Integer bytes = 0; // its size; never changes
};

// One picture's place in the shared memory.
struct Slot {
    Integer offset = 0;
    Integer stride = 0; // bytes from one row to the next
};

struct MenuEntry {
    std::string id, label;
    std::string shortcut; // "Ctrl+R"; "" for none
    bool checkable = false;
    bool checked = false;
    bool enabled = true;
    Scope scope = Scope::subdocument;
    std::optional<Mode> mode; // the mode that the medium's process must run in
    std::string group;        // entries of one group stand in one submenu of that label
    std::string icon;         // freedesktop icon name; an entry with one belongs in a tool area
};

struct Presentation {
    std::string id, label;
};

struct ScreenArea { // device pixels of the screen that both sides are on
    Integer x = 0, y = 0, width = 0, height = 0;
};

struct ParameterValue {
    std::string name;
    double value = 0;
    std::optional<double> min, max;
    std::string label, unit;
};

struct DiagnosticItem {
    Severity severity = Severity::error;
    Integer line = 0, column = 0, endLine = 0, endColumn = 0; // line 0: no place is known
    std::string message;
    bool operator==(const DiagnosticItem&) const = default;
};

// Error codes of answers.
enum class ErrorCode : int {
    parseError = -32700,
    invalidRequest = -32600,
    methodNotFound = -32601,
    invalidParameters = -32602,
    internalError = -32603,
    noCommonVersion = -32001,
    staleBase = -32002,
    notPossible = -32003, // a sentence says why; nothing was changed
    closed = -32099,      // never on the wire: the other side is gone
};

struct Error {
    Integer code = static_cast<Integer>(ErrorCode::internalError);
    std::string message;
    Error() = default;
    Error(Integer number, std::string sentence) : code(number), message(std::move(sentence)) {}
    Error(ErrorCode known, std::string sentence)
        : code(static_cast<Integer>(known)), message(std::move(sentence)) {}
};

// --- answers ----------------------------------------------------------------------------------

struct Done {}; // {}
struct Initialized {
    Integer protocol = 1;
    std::string name, version;
    std::vector<std::string> capabilities;
    std::vector<MenuEntry> menus;
};
struct Presentations {
    std::vector<Presentation> items;
};
struct PreferredSize { // at scale 1, 96 to the inch
    double width = 0, height = 0;
};
struct Exported {
    std::string mimeType, text;
};
struct Taken { // a snapshot
    double time = 0;
    std::optional<std::string> pixels; // base64, rows without gaps; only without shared memory
};
struct Parameters {
    std::vector<ParameterValue> items;
};
struct Values {
    std::vector<double> values;        // not a number: null on the wire, not defined now
    std::vector<std::string> faults{}; // why each is not; "" for the others; empty: none is said
};
struct ValueOffer { // an expression that users may mean
    std::string expression, label, unit;
};
struct ValueOffers {
    std::vector<ValueOffer> items;
};
struct Evaluated {
    std::string result;
};
struct AskedField { // of a question: its value as it is now, to be typed anew
    std::string label, value;
};
struct ChangedLine {  // of the subdocument's text, without what it shares with its surroundings
    Integer line = 0; // from 1
    std::string before, after;
};
struct Way { // another one than that which was refused
    std::string id, label;
};
// A command that wants to know more before it is done. The host asks its user, and invokes the same
// entry again with the values, or a way by its id.
struct Question {
    std::string title, note;
    std::vector<AskedField> fields;
    std::string refusal;   // why the values that came with it cannot be; "": none came
    std::vector<Way> ways; // instead
    bool tries = false;    // it may be invoked to try values
    std::vector<ChangedLine> changes = {}; // that these values would make
};
struct Invoked {
    std::optional<Question> question; // none: it is done
};
struct Revised {
    Integer revision = 0;
};

using AnyResult = std::variant<Done, Initialized, Presentations, PreferredSize, Exported, Taken,
                               Parameters, Values, ValueOffers, Evaluated, Invoked, Revised>;

// --- host to medium ---------------------------------------------------------------------------

struct Initialize {
    static constexpr auto method = "initialize";
    using Result = Initialized;
    Integer oldest = 1, newest = 1; // protocol versions that the host speaks
    std::string documentClass;
    Mode mode = Mode::play;
    std::optional<SharedMemory> frames;
    std::string locale;
};
struct Ping {
    static constexpr auto method = "ping";
    using Result = Done;
};
struct SubdocumentLoad {
    static constexpr auto method = "subdocument/load";
    using Result = Done;
    std::string text;
    Integer revision = 0;
    std::string title = {}; // what users call the subdocument, for the titles of windows
};
struct SubdocumentEdit {
    static constexpr auto method = "subdocument/edit";
    using Result = Done;
    Integer revision = 0; // after the edit
    text::Edits edits;
    std::string label;
};
struct PresentationList {
    static constexpr auto method = "presentation/list";
    using Result = Presentations;
};
struct PresentationSize {
    static constexpr auto method = "presentation/size";
    using Result = PreferredSize;
    std::string presentation;
    double availableWidth = 0;             // at scale 1
    std::optional<double> availableHeight; // none: as high as it likes
};
struct PresentationExport {
    static constexpr auto method = "presentation/export";
    using Result = Exported;
    std::string format;
    std::optional<double> accuracy;
};
struct SessionRestore { // what a process that ended had open, for the one that takes its place
    static constexpr auto method = "session/restore";
    std::string state;  // as session/keep said it
    std::string notice; // what happened, for the windows that are opened again
};
struct RenditionGeometry {
    Integer rendition = 0;
    std::string presentation;
    Integer width = 0, height = 0;
    double scale = 1;        // device pixels per 1/96 inch
    std::vector<Slot> slots; // two, or none without shared memory
};
struct RenditionCreate : RenditionGeometry {
    static constexpr auto method = "rendition/create";
    using Result = Done;
    std::string state = {}; // what rendition/state last said of it, perhaps in another process
};
struct RenditionResize : RenditionGeometry {
    static constexpr auto method = "rendition/resize";
    using Result = Done;
};
struct RenditionDestroy {
    static constexpr auto method = "rendition/destroy";
    using Result = Done;
    Integer rendition = 0;
};
struct RenditionShow {
    static constexpr auto method = "rendition/show";
    Integer rendition = 0;
};
struct RenditionHide {
    static constexpr auto method = "rendition/hide";
    Integer rendition = 0;
};
struct RenditionAck {
    static constexpr auto method = "rendition/ack";
    Integer rendition = 0, serial = 0;
};
struct Input {
    Integer rendition = 0;
    InputType type = InputType::move;
    double x = 0, y = 0;          // from the rendition's top left
    Button button = Button::none; // that changed
    std::vector<Button> buttons;  // that are down, after the change
    std::vector<Modifier> modifiers;
    double dx = 0, dy = 0; // notches of a wheel; dy > 0: away from the user
    std::string key;       // as the W3C names them: "a", "A", " ", "ArrowLeft", "Home", "F5"
    std::string text;      // that the key would type
};
struct RenditionInput : Input {
    static constexpr auto method = "rendition/input";
};
struct RenditionSnapshot {
    static constexpr auto method = "rendition/snapshot";
    using Result = Taken;
    std::string presentation;
    Integer width = 0, height = 0;
    double scale = 1;
    std::optional<double> time;            // none: now
    std::optional<Integer> offset, stride; // none without shared memory
    std::optional<Integer>
        rendition; // seen as this one shows it; none: the presentation's own view
};
struct MenuInvoke {
    static constexpr auto method = "menu/invoke";
    using Result = Invoked;
    std::string id;
    std::optional<Integer> rendition;
    std::vector<std::string> values = {};  // of the fields of its question
    bool isTrial = false;                  // nothing is done: the question says what would be
    std::optional<ScreenArea> figure = {}; // where its user sees it; none: nobody knows
};
struct TimePlay {
    static constexpr auto method = "time/play";
    using Result = Done;
};
struct TimePause {
    static constexpr auto method = "time/pause";
    using Result = Done;
};
struct TimeSeek {
    static constexpr auto method = "time/seek";
    using Result = Done;
    double time = 0;
};
struct TimeRate {
    static constexpr auto method = "time/rate";
    using Result = Done;
    double rate = 1;
    bool loop = false;
};
struct ParameterList {
    static constexpr auto method = "parameter/list";
    using Result = Parameters;
};
struct ParameterSet {
    static constexpr auto method = "parameter/set";
    std::string name;
    double value = 0;
};
struct ValueList { // what users may choose from; any other expression may be asked for
    static constexpr auto method = "value/list";
    using Result = ValueOffers;
};
struct ValueRead {
    static constexpr auto method = "value/read";
    using Result = Values;
    std::vector<std::string> expressions;
    std::optional<double> time; // none: now
};
struct ValueSubscribe {
    static constexpr auto method = "value/subscribe";
    using Result = Done;
    Integer id = 0;
    std::vector<std::string> expressions;
};
struct ValueUnsubscribe {
    static constexpr auto method = "value/unsubscribe";
    using Result = Done;
    Integer id = 0;
};
struct ScriptEvaluate { // both ways
    static constexpr auto method = "script/evaluate";
    using Result = Evaluated;
    std::string script;
};
struct ProgressCancel {
    static constexpr auto method = "progress/cancel";
    Integer token = 0;
};
struct Shutdown {
    static constexpr auto method = "shutdown";
    using Result = Done;
};
struct Exit {
    static constexpr auto method = "exit";
};

// --- medium to host ---------------------------------------------------------------------------

struct RenditionFrame {
    static constexpr auto method = "rendition/frame";
    Integer rendition = 0;
    Integer slot = 0; // 0 or 1
    Integer serial = 0;
    Integer width = 0, height = 0;
    double time = 0;
    std::optional<std::string> pixels; // base64, rows without gaps; without shared memory
};
struct SubdocumentChanged {
    static constexpr auto method = "subdocument/changed";
    using Result = Revised;
    Integer base = 0; // the revision that the edits are made on
    text::Edits edits;
    std::string label;
    std::string group; // changes of one group are one step of undo; "": a step of its own
};
struct EditUndo {
    static constexpr auto method = "edit/undo";
    using Result = Done;
};
struct EditRedo {
    static constexpr auto method = "edit/redo";
    using Result = Done;
};
struct RenditionUnhandled : Input {
    static constexpr auto method = "rendition/unhandled";
};
struct RenditionCursor {
    static constexpr auto method = "rendition/cursor";
    Integer rendition = 0;
    CursorShape shape = CursorShape::arrow;
};
struct RenditionState { // how its user sees it, in the medium's own words
    static constexpr auto method = "rendition/state";
    Integer rendition = 0;
    std::string state;
};
struct PresentationResized { // ask again for the size that it would like
    static constexpr auto method = "presentation/resized";
    std::string presentation; // "": any of them
};
struct WindowsChanged { // of the medium's own windows; at first there are none
    static constexpr auto method = "windows/changed";
    Integer open = 0;
    bool drafts = false; // something typed there is no proposed change yet
    bool operator==(const WindowsChanged&) const = default;
};
struct SessionKeep { // of the medium's own windows, in its own words; "": nothing is to be kept
    static constexpr auto method = "session/keep";
    std::string state;
};
struct MenuChanged { // the whole set
    static constexpr auto method = "menu/changed";
    std::vector<MenuEntry> menus;
};
struct ValueChanged {
    static constexpr auto method = "value/changed";
    Integer id = 0;
    double time = 0;
    std::vector<double> values;
    std::vector<std::string> faults{}; // as of Values
};
struct TimeChanged {
    static constexpr auto method = "time/changed";
    double time = 0;
    bool playing = false;
    double rate = 1;
    bool loop = false;
    double start = 0, finish = 0;
    double computed = 0;               // how far the motion is known
    std::optional<double> predictable; // from here on it is not; none: to the finish
    MotionState state = MotionState::current;
    Integer motion = 0; // another number: another motion
};
struct ProgressBegin {
    static constexpr auto method = "progress/begin";
    Integer token = 0;
    std::string title;
    bool cancellable = false;
};
struct ProgressReport {
    static constexpr auto method = "progress/report";
    Integer token = 0;
    std::optional<double> fraction; // 0 to 1
    std::string message;
};
struct ProgressEnd {
    static constexpr auto method = "progress/end";
    Integer token = 0;
    std::string message; // "" when all went well
};
struct Diagnostics { // the whole set, of that revision
    static constexpr auto method = "diagnostics";
    Integer revision = 0;
    std::vector<DiagnosticItem> items;
    bool operator==(const Diagnostics&) const = default;
};

// --- the two directions -----------------------------------------------------------------------

using ToMedium =
    std::variant<Initialize, Ping, SubdocumentLoad, SubdocumentEdit, SessionRestore,
                 PresentationList, PresentationSize, PresentationExport, RenditionCreate,
                 RenditionResize, RenditionDestroy, RenditionShow, RenditionHide, RenditionAck,
                 RenditionInput, RenditionSnapshot, MenuInvoke, TimePlay, TimePause, TimeSeek,
                 TimeRate, ParameterList, ParameterSet, ValueList, ValueRead, ValueSubscribe,
                 ValueUnsubscribe, ScriptEvaluate, ProgressCancel, Shutdown, Exit>;

using ToHost =
    std::variant<RenditionFrame, SubdocumentChanged, EditUndo, EditRedo, RenditionUnhandled,
                 RenditionCursor, RenditionState, PresentationResized, MenuChanged, ValueChanged,
                 TimeChanged, ProgressBegin, ProgressReport, ProgressEnd, Diagnostics,
                 WindowsChanged, SessionKeep, ScriptEvaluate>;

template <class Call>
concept IsRequest = requires {
    typename Call::Result;
};

} // namespace ipc

#include "script/interpreter.h"

#include "script/commands.h"
#include "script/instrument.h"
#include "script/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <set>
#include <vector>

#include <tcl.h>

namespace script {

namespace {

constexpr long timeLimitSeconds = 2;

std::string_view textOf(Tcl_Obj* object) {
    int length = 0;
    const char* bytes = Tcl_GetStringFromObj(object, &length);
    return {bytes, static_cast<std::size_t>(length)};
}

Tcl_Obj* newText(std::string_view text) {
    return Tcl_NewStringObj(text.data(), static_cast<int>(text.size()));
}

} // namespace

struct Interpreter::Implementation {
    explicit Implementation(Progress& shared) : progress(shared) {}

    Progress& progress;
    Tcl_Interp* tcl = nullptr;
    RecordingWriter recording;
    std::string mark;
    Tcl_CmdInfo infoBody{};
    std::map<std::string, double> parameters;
    std::uint64_t current = noOffset; // the command of the text that was started last
    std::uint64_t pending = noOffset; // the same, while no command has taken it as its place

    void start(std::uint64_t offset) {
        current = offset;
        progress.offset.store(offset, std::memory_order_relaxed);
    }

    // What Tcl answers to a question whose answer is a list; {} if it does not.
    [[nodiscard]] std::vector<std::string> listed(const std::string& question);
    void keepOnly(const char* space, const std::set<std::string, std::less<>>& allowed);
    void deleteHidden();
    void shrinkInfo();
    void addCommands();
    void setParameter(const std::vector<std::string_view>& words);
    void finish(int status);
    std::string failedCommand();
    std::uint64_t substitutedCommand();
    void findCandidates(Recording& ending, std::vector<std::string>& storage);

    static int markCommand(ClientData self, Tcl_Interp* tcl, int count, Tcl_Obj* const words[]);
    static int restore(ClientData data[], Tcl_Interp* tcl, int status);
    static int sceneCommand(ClientData self, Tcl_Interp* tcl, int count, Tcl_Obj* const words[]);
    static int refusedCommand(ClientData reason, Tcl_Interp* tcl, int count,
                              Tcl_Obj* const words[]);
    static int bodyOfProcedure(ClientData self, Tcl_Interp* tcl, int count, Tcl_Obj* const words[]);
};

// --- what there is --------------------------------------------------------------------------

std::vector<std::string> Interpreter::Implementation::listed(const std::string& question) {
    if (Tcl_EvalEx(tcl, question.c_str(), -1, TCL_EVAL_GLOBAL) != TCL_OK)
        return {};
    Tcl_Obj* names = Tcl_GetObjResult(tcl);
    Tcl_IncrRefCount(names);
    int count = 0;
    Tcl_Obj** elements = nullptr;
    Tcl_ListObjGetElements(tcl, names, &count, &elements);
    std::vector<std::string> result;
    for (int i = 0; i < count; ++i)
        result.emplace_back(textOf(elements[i]));
    Tcl_DecrRefCount(names);
    return result;
}

void Interpreter::Implementation::deleteHidden() {
    for (const std::string& name : listed("interp hidden {}"))
        if (Tcl_ExposeCommand(tcl, name.c_str(), "exposed") == TCL_OK)
            Tcl_DeleteCommand(tcl, "exposed");
}

// Deletes every command of a namespace that is not allowed.
void Interpreter::Implementation::keepOnly(const char* space,
                                           const std::set<std::string, std::less<>>& allowed) {
    for (const std::string& name : listed(std::string("info commands ") + space + "*")) {
        const auto tail = name.rfind("::");
        if (!allowed.contains(tail == std::string::npos ? name : name.substr(tail + 2)))
            Tcl_DeleteCommand(tcl, name.c_str());
    }
}

// Questions about the script itself; none about the machine, the files or the library.
void Interpreter::Implementation::shrinkInfo() {
    static constexpr const char* kept[] = {"args",    "body",   "commands",   "complete",
                                           "default", "exists", "globals",    "level",
                                           "locals",  "procs",  "tclversion", "vars"};
    std::string map = "namespace ensemble configure ::info -map {";
    std::set<std::string, std::less<>> names;
    for (const char* name : kept) {
        map += std::string(name) + " ::tcl::info::" + name + " ";
        names.insert(name);
    }
    Tcl_EvalEx(tcl, (map + "}").c_str(), -1, TCL_EVAL_GLOBAL);
    Tcl_GetCommandInfo(tcl, "::tcl::info::body", &infoBody);
    keepOnly("::tcl::info::", names);
    Tcl_CreateObjCommand(tcl, "::tcl::info::body", &bodyOfProcedure, this, nullptr);
}

void Interpreter::Implementation::addCommands() {
    for (const Refusal& refusal : refusals()) {
        Tcl_CreateObjCommand(tcl, std::string(refusal.command).c_str(), &refusedCommand,
                             const_cast<Refusal*>(&refusal), nullptr);
        if (refusal.command == "rand" || refusal.command == "srand")
            Tcl_CreateObjCommand(tcl, ("::tcl::mathfunc::" + std::string(refusal.command)).c_str(),
                                 &refusedCommand, const_cast<Refusal*>(&refusal), nullptr);
    }
    for (const std::string_view name : sceneCommands())
        Tcl_CreateObjCommand(tcl, std::string(name).c_str(), &sceneCommand, this, nullptr);
    // Figure 4.6 says index.
    Tcl_CmdInfo lindex{};
    if (Tcl_GetCommandInfo(tcl, "lindex", &lindex))
        Tcl_CreateObjCommand(tcl, "index", lindex.objProc, lindex.objClientData, nullptr);
}

Interpreter::Interpreter(Progress& progress)
    : implementation_(std::make_unique<Implementation>(progress)) {
    Implementation& self = *implementation_;
    Tcl_FindExecutable(nullptr);
    self.tcl = Tcl_CreateInterp();
    // Tcl's own fence first: it must find all commands that it hides. What it hid goes too.
    Tcl_MakeSafe(self.tcl);
    self.deleteHidden();
    std::set<std::string, std::less<>> allowed;
    for (const std::string_view name : tclCommands())
        allowed.emplace(name);
    for (const char* space :
         {"::oo", "::tcl::chan", "::tcl::clock", "::tcl::file", "::tcl::encoding", "::tcl::binary",
          "::tcl::unsupported", "::tcl::process", "::zlib", "::tcl::zlib"})
        if (Tcl_Namespace* found = Tcl_FindNamespace(self.tcl, space, nullptr, 0))
            Tcl_DeleteNamespace(found);
    self.shrinkInfo();
    self.keepOnly("::tcl::", {});
    self.keepOnly("::", allowed);
    for (const char* name : {"tcl_platform", "env", "tcl_library", "tcl_pkgPath", "auto_path",
                             "tcl_patchLevel", "argv", "argv0", "argc"})
        Tcl_UnsetVar(self.tcl, name, TCL_GLOBAL_ONLY);
    self.addCommands();
    Tcl_ResetResult(self.tcl);
}

Interpreter::~Interpreter() {
    if (implementation_->tcl)
        Tcl_DeleteInterp(implementation_->tcl);
}

// --- commands -------------------------------------------------------------------------------

// M OFFSET, or M OFFSET COMMAND WORD...
int Interpreter::Implementation::markCommand(ClientData data, Tcl_Interp* tcl, int count,
                                             Tcl_Obj* const words[]) {
    auto& self = *static_cast<Implementation*>(data);
    Tcl_WideInt offset = 0;
    if (count < 2 || Tcl_GetWideIntFromObj(tcl, words[1], &offset) != TCL_OK)
        return TCL_ERROR;
    self.start(static_cast<std::uint64_t>(offset));
    self.pending = noOffset;
    if (count == 2)
        return TCL_OK;
    std::string_view name = textOf(words[2]);
    if (name.starts_with("::"))
        name.remove_prefix(2);
    if (isSceneCommand(name))
        self.pending = self.current;
    else // a procedure: what comes after it is not inside it
        Tcl_NRAddCallback(tcl, &restore, data, reinterpret_cast<ClientData>(self.current), nullptr,
                          nullptr);
    return Tcl_NREvalObjv(tcl, count - 2, words + 2, 0);
}

int Interpreter::Implementation::restore(ClientData data[], Tcl_Interp*, int status) {
    auto& self = *static_cast<Implementation*>(data[0]);
    if (status == TCL_OK)
        self.start(reinterpret_cast<std::uint64_t>(data[1]));
    return status;
}

int Interpreter::Implementation::sceneCommand(ClientData data, Tcl_Interp* tcl, int count,
                                              Tcl_Obj* const words[]) {
    auto& self = *static_cast<Implementation*>(data);
    if (self.recording.commands() >= mostRecordedCommands) {
        Tcl_SetObjResult(tcl, newText("a scene has at most 100,000 elements"));
        return TCL_ERROR;
    }
    std::vector<std::string_view> texts;
    std::size_t bytes = 0;
    for (int i = 0; i < count; ++i) {
        texts.push_back(textOf(words[i]));
        bytes += texts.back().size();
    }
    if (self.recording.bytes().size() + bytes > mostRecordedBytes / 2) {
        Tcl_SetObjResult(tcl, newText("the elements of this scene take more than 16 MB"));
        return TCL_ERROR;
    }
    if (texts[0].starts_with("::"))
        texts[0].remove_prefix(2);
    if (texts[0] == "parameter")
        self.setParameter(texts);
    self.recording.command(self.pending, self.current, texts);
    self.pending = noOffset;
    Tcl_SetObjResult(tcl, count > 1 && !texts[1].starts_with('-') ? words[1] : Tcl_NewObj());
    return TCL_OK;
}

// $NAME is the parameter's value: the one that the reader was given, else the author's. A value
// that is no number is reported when elements are made; here it must not stop the script.
void Interpreter::Implementation::setParameter(const std::vector<std::string_view>& words) {
    if (words.size() < 2)
        return;
    const std::string name(words[1]);
    std::string value = "0";
    bool whole = true;
    for (std::size_t i = 2; i + 1 < words.size(); i += 2) {
        if (words[i] == "-value" && decimalNumber(words[i + 1])) {
            value = words[i + 1];
            whole = value.find_first_of(".eE") == std::string::npos;
        }
    }
    if (const auto given = parameters.find(name); given != parameters.end())
        value = numberText(given->second, whole);
    Tcl_SetVar2(tcl, name.c_str(), nullptr, value.c_str(), TCL_GLOBAL_ONLY);
}

int Interpreter::Implementation::refusedCommand(ClientData data, Tcl_Interp* tcl, int,
                                                Tcl_Obj* const[]) {
    const auto& refusal = *static_cast<const Refusal*>(data);
    const std::string message = "scenes have no command \"" + std::string(refusal.command) +
                                "\": " + std::string(refusal.reason);
    Tcl_SetObjResult(tcl, newText(message));
    return TCL_ERROR;
}

// info body: as the author wrote it.
int Interpreter::Implementation::bodyOfProcedure(ClientData data, Tcl_Interp* tcl, int count,
                                                 Tcl_Obj* const words[]) {
    auto& self = *static_cast<Implementation*>(data);
    const int status = self.infoBody.objProc(self.infoBody.objClientData, tcl, count, words);
    if (status == TCL_OK)
        Tcl_SetObjResult(tcl, newText(withoutMarks(textOf(Tcl_GetObjResult(tcl)), self.mark)));
    return status;
}

// --- evaluation -----------------------------------------------------------------------------

// Names that exist where an unknown one was used.
void Interpreter::Implementation::findCandidates(Recording& ending,
                                                 std::vector<std::string>& storage) {
    const bool variable = ending.message.starts_with("can't read ");
    if (!variable && !ending.message.starts_with("invalid command name"))
        return;
    const char* query = variable ? "info globals" : "info commands ::*";
    if (Tcl_EvalEx(tcl, query, -1, TCL_EVAL_GLOBAL) != TCL_OK)
        return;
    int count = 0;
    Tcl_Obj** names = nullptr;
    Tcl_ListObjGetElements(tcl, Tcl_GetObjResult(tcl), &count, &names);
    for (int i = 0; i < count && storage.size() < 1000; ++i) {
        std::string_view name = textOf(names[i]);
        if (name.starts_with("::"))
            name.remove_prefix(2);
        const bool refused = std::any_of(refusals().begin(), refusals().end(),
                                         [&](const Refusal& r) { return r.command == name; });
        if (name != mark && !refused && name.size() < 100 && !name.starts_with("tcl_") &&
            !name.starts_with("error"))
            storage.emplace_back(name);
    }
    std::sort(storage.begin(), storage.end());
    ending.candidates.assign(storage.begin(), storage.end());
}

const std::string& Interpreter::evaluate(const Request& request) {
    Implementation& self = *implementation_;
    self.parameters = request.parameters;
    self.mark = markFor(request.text);
    Tcl_NRCreateCommand(self.tcl, self.mark.c_str(), &Implementation::markCommand,
                        &Implementation::markCommand, &self, nullptr);
    const std::string plain = withPlainContinuations(request.text);
    const std::string marked = instrumented(plain, structureOf(plain), self.mark);
    Tcl_Time until{};
    Tcl_GetTime(&until);
    until.sec += timeLimitSeconds;
    Tcl_LimitSetTime(self.tcl, &until);
    Tcl_LimitTypeSet(self.tcl, TCL_LIMIT_TIME);
    // A mark is a command too.
    Tcl_LimitSetCommands(
        self.tcl, static_cast<int>(std::min<std::int64_t>(2 * request.commands, 2'000'000'000)));
    Tcl_LimitTypeSet(self.tcl, TCL_LIMIT_COMMANDS);
    int status = TCL_ERROR;
    if (marked.size() < 0x7fff0000)
        status =
            Tcl_EvalEx(self.tcl, marked.data(), static_cast<int>(marked.size()), TCL_EVAL_GLOBAL);
    self.finish(status);
    return self.recording.bytes();
}

void Interpreter::Implementation::finish(int status) {
    Recording ending;
    ending.offset = current;
    if (Tcl_LimitExceeded(tcl)) {
        ending.ending =
            Tcl_LimitTypeExceeded(tcl, TCL_LIMIT_TIME) ? Ending::timeLimit : Ending::commandLimit;
        recording.end(ending);
        return;
    }
    Tcl_LimitTypeReset(tcl, TCL_LIMIT_TIME);
    Tcl_LimitTypeReset(tcl, TCL_LIMIT_COMMANDS);
    if (status == TCL_OK || status == TCL_RETURN) {
        recording.end(ending);
        return;
    }
    ending.ending = Ending::error;
    std::string message = withoutMarks(textOf(Tcl_GetObjResult(tcl)).substr(0, 4000), mark);
    if (status == TCL_BREAK || status == TCL_CONTINUE)
        message = status == TCL_BREAK ? "there is no loop that this break could leave"
                                      : "there is no loop that this continue could go on with";
    if (const auto whose = substitutedCommand(); whose != noOffset)
        ending.offset = whose;
    const std::string executing = failedCommand();
    ending.message = message;
    ending.executing = executing;
    std::vector<std::string> storage;
    findCandidates(ending, storage);
    recording.end(ending);
}

// What Tcl's trace shows first: "...while executing\n"COMMAND"", cut at 150 bytes.
std::string Interpreter::Implementation::failedCommand() {
    const char* trace = Tcl_GetVar(tcl, "errorInfo", TCL_GLOBAL_ONLY);
    if (!trace)
        return "";
    const std::string_view text = trace;
    constexpr std::string_view label = "\n    while executing\n\"";
    const auto from = text.find(label);
    if (from == std::string_view::npos)
        return "";
    std::string_view command = text.substr(from + label.size());
    command =
        command.substr(0, std::min(command.find("\"\n    ("), command.find("\"\n    invoked")));
    if (command.ends_with('"'))
        command.remove_suffix(1);
    if (command.ends_with("..."))
        command.remove_suffix(3);
    std::string plain = withoutMarks(command, mark);
    // A mark that was cut in two.
    if (const auto cut = plain.find('\xee'); cut != std::string::npos)
        plain.resize(cut);
    return plain;
}

// The command of the text whose words were being put together, when that is what failed: its mark
// begins it in Tcl's trace, and was never started. What stands before it there are commands in its
// brackets, and no body of a procedure or a loop.
std::uint64_t Interpreter::Implementation::substitutedCommand() {
    const char* trace = Tcl_GetVar(tcl, "errorInfo", TCL_GLOBAL_ONLY);
    const std::string_view text = trace ? trace : "";
    const std::string begun = "\n\"" + mark + " ";
    const auto at = text.find(begun);
    const auto body = text.find("\n    (");
    if (at == std::string_view::npos || body < at)
        return noOffset;
    std::uint64_t offset = noOffset;
    const std::string_view digits = text.substr(at + begun.size());
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), offset);
    const bool isWhole =
        error == std::errc{} && end != digits.data() + digits.size() && *end == ' ';
    return isWhole ? offset : noOffset;
}

const std::string& Interpreter::recorded() const { return implementation_->recording.bytes(); }

} // namespace script

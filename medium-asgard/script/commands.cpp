#include "script/commands.h"

#include <algorithm>

namespace script {

namespace {

constexpr std::string_view sceneNames[] = {
    "simulator", "shape_set",   "body", "instance",  "force",   "link",
    "spring",    "joint",       "gear", "rope",      "contact", "trajectory",
    "constrain", "lightsource", "view", "parameter", "plot"};

constexpr std::string_view tclNames[] = { // sorted
    "append", "apply",   "array",     "break",    "catch",   "concat",   "continue", "dict",
    "error",  "eval",    "expr",      "for",      "foreach", "format",   "global",   "if",
    "incr",   "index",   "info",      "join",     "lappend", "lassign",  "lindex",   "linsert",
    "list",   "llength", "lmap",      "lrange",   "lrepeat", "lreplace", "lreverse", "lsearch",
    "lset",   "lsort",   "namespace", "proc",     "regexp",  "regsub",   "return",   "scan",
    "set",    "split",   "string",    "subst",    "switch",  "tailcall", "throw",    "try",
    "unset",  "uplevel", "upvar",     "variable", "while"};

constexpr std::string_view files = "a scene cannot read or write files";
constexpr std::string_view programs = "a scene cannot start programs or load code";
constexpr std::string_view network = "a scene cannot use the network";
constexpr std::string_view repeatable = "one text must always make the same scene";
constexpr std::string_view events = "a scene is read at once, and waits for nothing";
constexpr std::string_view output = "a scene describes and cannot print";
constexpr std::string_view structure = "places in the text would be lost";
constexpr std::string_view interpreters = "a scene has one interpreter";

constexpr Refusal refused[] = {{"after", events},
                               {"auto_execok", programs},
                               {"auto_import", programs},
                               {"auto_load", programs},
                               {"bgerror", events},
                               {"binary", files},
                               {"cd", files},
                               {"chan", files},
                               {"clock", repeatable},
                               {"close", files},
                               {"coroinject", structure},
                               {"coroprobe", structure},
                               {"coroutine", structure},
                               {"encoding", files},
                               {"eof", files},
                               {"exec", programs},
                               {"exit", "a scene cannot end the program that reads it"},
                               {"fblocked", files},
                               {"fconfigure", files},
                               {"fcopy", files},
                               {"file", files},
                               {"fileevent", files},
                               {"flush", output},
                               {"gets", files},
                               {"glob", files},
                               {"history", events},
                               {"interp", interpreters},
                               {"load", programs},
                               {"my", "scenes have no classes"},
                               {"next", "scenes have no classes"},
                               {"open", files},
                               {"package", programs},
                               {"parray", output},
                               {"pid", repeatable},
                               {"puts", output},
                               {"pwd", files},
                               {"rand", repeatable},
                               {"read", files},
                               {"rename", structure},
                               {"seek", files},
                               {"self", "scenes have no classes"},
                               {"socket", network},
                               {"source", files},
                               {"srand", repeatable},
                               {"tell", files},
                               {"thread", interpreters},
                               {"time", repeatable},
                               {"timerate", repeatable},
                               {"trace", structure},
                               {"unload", programs},
                               {"update", events},
                               {"vwait", events},
                               {"yield", structure},
                               {"yieldto", structure},
                               {"zipfs", files},
                               {"zlib", files}};

} // namespace

std::span<const std::string_view> sceneCommands() { return sceneNames; }

bool isSceneCommand(std::string_view name) {
    return std::find(std::begin(sceneNames), std::end(sceneNames), name) != std::end(sceneNames);
}

std::span<const std::string_view> tclCommands() { return tclNames; }

bool isTclCommand(std::string_view name) {
    return std::binary_search(std::begin(tclNames), std::end(tclNames), name);
}

std::span<const Refusal> refusals() { return refused; }

} // namespace script

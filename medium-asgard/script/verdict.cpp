#include "script/verdict.h"

#include "script/locate.h"
#include "script/make_scene.h"
#include "script/meant.h"
#include "script/structure.h"
#include "script/suggestion.h"

#include <algorithm>
#include <csignal>
#include <cstring>

namespace script {

namespace {

scene::Diagnostic diagnosticAt(const text::Places& places, Range range, std::string message,
                               std::string suggestion = "") {
    scene::Diagnostic diagnostic;
    diagnostic.range = range;
    diagnostic.message = std::move(message);
    diagnostic.suggestion = std::move(suggestion);
    locate(places, diagnostic);
    return diagnostic;
}

// The length of the UTF-8 character at `at`, 0 when there is none.
std::size_t characterAt(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned first = byte(at);
    if (first < 0x80)
        return 1;
    const std::size_t length = first >= 0xf0 && first < 0xf5   ? 4
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xc2 && first < 0xe0 ? 2
                                                               : 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xc0) != 0x80)
            return 0;
    if ((first == 0xe0 && byte(at + 1) < 0xa0) || (first == 0xed && byte(at + 1) >= 0xa0) ||
        (first == 0xf0 && byte(at + 1) < 0x90) || (first == 0xf4 && byte(at + 1) >= 0x90))
        return 0;
    return length;
}

std::string seconds(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.'))
        text.pop_back();
    return text;
}

std::string grouped(long value) {
    std::string text = std::to_string(value);
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
        text.insert(static_cast<std::size_t>(at), ",");
    return text;
}

std::string sentenceFor(const Answer& answer, const Limits& limits) {
    std::string time = "the script did not end within " +
                       seconds(static_cast<double>(limits.wallClock.count()) / 1000) +
                       " s; it was stopped here";
    std::string processor = "the script took more than " + grouped(limits.cpuSeconds) +
                            " s of processor time; it was stopped here";
    std::string memory = "the script took more than " +
                         grouped(static_cast<long>(limits.bytes >> 20)) +
                         " MB of memory; it was stopped here";
    switch (answer.end) {
    case End::notStarted:
        return "the system starts no process that evaluates this script; close other programs and "
               "try again";
    case End::serverEnded:
        return "the process that evaluates scripts was ended twice while it read this one";
    case End::endedTooOften:
        return "the process that evaluates scripts was ended " +
               std::to_string(limits.restarts + 1) + " times within " +
               seconds(static_cast<double>(limits.restartsWithin.count()) / 1000) +
               " s; try again when as much time has passed";
    case End::noServer:
        return "the processes that evaluate scripts were ended from outside; save, and start this "
               "program again";
    case End::cancelled:
        return "reading was cancelled";
    case End::outOfTime:
        return time;
    case End::tooMuch:
        return "the elements of this scene take more than 32 MB";
    case End::exited:
        if (answer.status == exitOutOfMemory)
            return memory;
        break;
    case End::signalled:
        if (answer.status == SIGXCPU || answer.status == SIGKILL)
            return processor;
        if (answer.status == SIGSEGV || answer.status == SIGBUS)
            return "the script nests brackets, braces or lists too deeply; its evaluation crashed "
                   "here";
        if (answer.status == SIGABRT)
            return memory;
        return std::string("the evaluation of the script was ended by ") + strsignal(answer.status);
    }
    return "the evaluation of the script gave no answer that makes sense";
}

// The command that ran, or nothing.
Range commandAt(const Structure& structure, std::uint64_t offset) {
    const Command* command = offset == ~std::uint64_t{0} ? nullptr : structure.startingAt(offset);
    return command ? command->range : Range{};
}

// --- errors of Tcl --------------------------------------------------------------------------

bool startsLike(std::string_view text, const Command& command, std::string_view beginning) {
    return !beginning.empty() && text.substr(command.range.from).starts_with(beginning);
}

// The command that failed is the one that was started last, one in brackets inside it, or one
// around it whose words were being substituted; Tcl tells how its text begins.
const Command* failed(std::string_view text, const Structure& structure,
                      const Recording& recording) {
    const Command* last =
        recording.offset == noOffset ? nullptr : structure.startingAt(recording.offset);
    if (!last || startsLike(text, *last, recording.executing))
        return last;
    const Command* end = structure.commands.data() + structure.commands.size();
    for (const Command* inner = last + 1; inner < end && inner->range.from < last->range.to;
         ++inner)
        if (startsLike(text, *inner, recording.executing))
            return inner;
    for (const Command* outer = last; outer->parent >= 0;) {
        outer = &structure.commands[static_cast<std::size_t>(outer->parent)];
        if (startsLike(text, *outer, recording.executing))
            return outer;
    }
    return last;
}

// "...\"NAME\"..." -> NAME
std::string quotedPart(std::string_view message) {
    const auto from = message.find('"');
    const auto to = from == std::string_view::npos ? from : message.find('"', from + 1);
    return to == std::string_view::npos ? "" : std::string(message.substr(from + 1, to - from - 1));
}

scene::Diagnostic tclError(std::string_view text, const Structure& structure,
                           const text::Places& places, const Recording& recording) {
    std::string message(recording.message);
    const Command* command = failed(text, structure, recording);
    Range range = command ? command->range : Range{};
    const std::vector<std::string> existing(recording.candidates.begin(),
                                            recording.candidates.end());
    std::string suggestion;
    if (message.starts_with("missing close-") || message.starts_with("missing \"") ||
        message.starts_with("missing )") || message.starts_with("extra characters after close") ||
        message.starts_with("unmatched")) {
        // A text that is no script: the walk over it knows where.
        const auto fault =
            std::find_if(structure.faults.begin(), structure.faults.end(), [&](const Fault& f) {
                return recording.offset == noOffset || f.range.from >= recording.offset;
            });
        if (fault != structure.faults.end())
            return diagnosticAt(places, fault->range, fault->message);
    } else if (message.starts_with("invalid command name")) {
        const std::string name = quotedPart(message);
        message = "there is no command \"" + name + "\"";
        if (command && !command->words.empty())
            range = command->words[0].range;
        if (std::string meant = meantBy(name); !meant.empty())
            suggestion = std::move(meant);
        else if (const std::string near = nearest(name, existing); !near.empty())
            suggestion = "did you mean \"" + near + "\"?";
        else if (const std::string word = name.size() > 4 ? nearest(name, meantWords()) : "";
                 !word.empty())
            suggestion = meantBy(word);
        else if (name == "DOCUMENT" || name.starts_with('<'))
            suggestion = "documents are opened by ensemble";
    } else if (message.starts_with("can't read ")) {
        const std::string name = quotedPart(message);
        if (command) {
            const std::string_view whole =
                text.substr(command->range.from, command->range.to - command->range.from);
            for (const std::string& written : {"$" + name, "${" + name + "}"})
                if (const auto at = whole.find(written); at != std::string_view::npos)
                    range = {command->range.from + at, command->range.from + at + written.size()};
        }
        if (const std::string near = nearest(name, existing); !near.empty())
            suggestion = "did you mean \"" + near + "\"?";
    } else if (const auto at = message.find(" at _@_"); at != std::string::npos) {
        message = message.substr(0, at) + " in this expression";
    } else if (message.starts_with("scenes have no command") && command &&
               !command->words.empty()) {
        range = command->words[0].range;
    }
    // One sentence, one line.
    message = message.substr(0, message.find('\n'));
    if (message.empty())
        message = "the script stopped with an error that says nothing";
    return diagnosticAt(places, range, std::move(message), std::move(suggestion));
}

scene::Diagnostic limitError(const Structure& structure, const text::Places& places,
                             const Recording& recording, const Limits& limits) {
    const Range range = commandAt(structure, recording.offset);
    if (recording.ending == Ending::commandLimit)
        return diagnosticAt(places, range,
                            "the script ran more than " + grouped(limits.commands) +
                                " commands; it was stopped here");
    return diagnosticAt(places, range, "the script ran longer than 2 s; it was stopped here");
}

} // namespace

std::optional<scene::Diagnostic> refuse(std::string_view text, std::size_t mostBytes) {
    const text::Places places(text.substr(0, mostBytes));
    if (text.size() > mostBytes)
        return diagnosticAt(places, {}, "the text is longer than 8 MB");
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = characterAt(text, at);
        if (length == 0 || text[at] == '\0')
            return diagnosticAt(places, {at, at + 1},
                                length == 0 ? "this byte is not UTF-8 text"
                                            : "a scene cannot hold a zero byte");
        at += length;
    }
    return std::nullopt;
}

ReadResult judge(std::string_view text, const Answer& answer, const Limits& limits,
                 const std::map<std::string, double>& parameters) {
    ReadResult result;
    const text::Places places(text);
    const Structure structure = structureOf(text);
    const auto decoded = decodeRecording(answer.bytes);
    const bool whole = decoded && decoded->complete && answer.end == End::exited;
    const Recording recording = decoded ? decoded->recording : Recording{};
    const bool finished = whole && recording.ending == Ending::complete;
    MadeScene made = makeScene(text, structure, recording, finished, parameters);
    result.scene = std::move(made.scene);
    result.diagnostics = std::move(made.diagnostics);
    if (!whole)
        result.diagnostics.push_back(diagnosticAt(places, commandAt(structure, answer.progress),
                                                  sentenceFor(answer, limits)));
    else if (recording.ending == Ending::error)
        result.diagnostics.push_back(tclError(text, structure, places, recording));
    else if (recording.ending != Ending::complete)
        result.diagnostics.push_back(limitError(structure, places, recording, limits));
    if (answer.serverReplaced)
        result.diagnostics.push_back(
            {scene::Severity::warning,
             {},
             0,
             0,
             0,
             0,
             "the process that evaluates scripts was ended from outside; another was started",
             ""});
    scene::sortByPlace(result.diagnostics);
    result.usable = std::none_of(
        result.diagnostics.begin(), result.diagnostics.end(),
        [](const scene::Diagnostic& d) { return d.severity == scene::Severity::error; });
    return result;
}

} // namespace script

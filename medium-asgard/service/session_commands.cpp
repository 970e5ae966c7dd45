// The medium's own commands (script/evaluate), as docs/medium-protocol.md lists them.
#include "service/session.h"

#include <charconv>
#include <cstdio>

namespace service {
namespace {

struct Command {
    std::string name, argument;
};

Command commandOf(const std::string& script) {
    const char* blanks = " \t\r\n";
    const std::size_t begin = script.find_first_not_of(blanks);
    if (begin == std::string::npos)
        return {};
    const std::size_t end = std::min(script.find_first_of(blanks, begin), script.size());
    Command command{script.substr(begin, end - begin), ""};
    const std::size_t argument = script.find_first_not_of(blanks, end);
    if (argument != std::string::npos)
        command.argument = script.substr(argument, script.find_last_not_of(blanks) + 1 - argument);
    return command;
}

std::optional<double> numberOf(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value - value == 0))
        return std::nullopt;
    return value;
}

std::string written(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string shown(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

const char* inWords(ipc::MotionState state) {
    switch (state) {
    case ipc::MotionState::current:
        return "current";
    case ipc::MotionState::draft:
        return "draft";
    case ipc::MotionState::computing:
        return "computing";
    case ipc::MotionState::stale:
        return "stale";
    case ipc::MotionState::failed:
        break;
    }
    return "failed";
}

ipc::Error error(std::string sentence) {
    return {ipc::ErrorCode::notPossible, std::move(sentence)};
}

template <class Elements> std::string names(const Elements& elements) {
    std::string all;
    for (const auto& element : elements)
        all += (all.empty() ? "" : " ") + element.name;
    return all;
}

} // namespace

auto Session::evaluate(const std::string& script) -> Reply<ipc::Evaluated> {
    const Command command = commandOf(script);
    Playback& playback = subdocument_.playback;
    const auto number = numberOf(command.argument);
    if (command.name == "time" || command.name == "rate" || command.name == "loop") {
        if (!command.argument.empty() && !number)
            return error(command.name + " wants a number, not \"" + command.argument + "\"");
        if (command.name == "time" && number)
            playback.seek(*number, at_.now);
        if (command.name == "rate" && number) {
            if (*number < 1e-6 || *number > 1e6)
                return error("a rate lies in 1e-6 to 1e6");
            playback.setRate(*number, playback.loops(), at_.now);
        }
        if (command.name == "loop" && number)
            playback.setRate(playback.rate(), *number != 0, at_.now);
        return ipc::Evaluated{command.name == "time"   ? written(playback.time(at_.now))
                              : command.name == "rate" ? written(playback.rate())
                                                       : written(playback.loops())};
    }
    if (command.name == "play" || command.name == "pause" || command.name == "stop") {
        if (command.name == "play")
            playback.play(at_.now);
        else if (command.name == "pause")
            playback.pause(at_.now);
        else
            playback.stop(at_.now);
        return ipc::Evaluated{""};
    }
    if (command.name == "value") {
        const auto read = values({command.argument}, std::nullopt);
        if (const auto* fault = std::get_if<ipc::Error>(&read))
            return *fault;
        const auto& of = std::get<ipc::Values>(read);
        if (!of.faults.empty())
            return error(of.faults.front());
        return ipc::Evaluated{written(of.values.at(0))};
    }
    if (command.name == "view") {
        if (command.argument.empty())
            return ipc::Evaluated{names(drawnScene().views)};
        for (const scene::View& view : drawnScene().views)
            if (view.name == command.argument) {
                for (auto& [id, rendition] : shown_.all)
                    rendition.follow(view.name);
                return ipc::Evaluated{view.name};
            }
        return error("no view named \"" + command.argument +
                     "\" (views here: " + names(drawnScene().views) + ")");
    }
    if (command.name == "bodies")
        return ipc::Evaluated{names(drawnScene().bodies)};
    if (command.name == "state")
        return ipc::Evaluated{inWords(subdocument_.state())};
    return error("no command \"" + command.name +
                 "\" (commands: time play pause stop rate loop value view bodies state)");
}

auto Session::values(const std::vector<std::string>& expressions, std::optional<double> time)
    -> Reply<ipc::Values> {
    const auto& motion = subdocument_.motion();
    if (!motion)
        return error("there is no motion to read values from");
    if (!subdocument_.computing() && !subdocument_.upToDate())
        return error("the text is faulty: its last values are those of an older text");
    if (subdocument_.waitsToBeAsked())
        return error("the motion of this text takes long and has not been computed: Recompute "
                     "Motion computes it");
    const ValueReader reader = valuesOf(expressions);
    const double at = time.value_or(subdocument_.playback.time(at_.now));
    if (subdocument_.motionIsStale())
        return reader.none("the motion of this text is being computed");
    if (at >= motion->start() && at <= motion->computed())
        return reader.at(at);
    return reader.none("there is no motion at " + shown(at) + " s: it is known from " +
                       shown(motion->start()) + " s to " + shown(motion->computed()) + " s");
}

ValueReader Session::valuesOf(const std::vector<std::string>& expressions) {
    return values_.reader(subdocument_.scene(), subdocument_.motion(), expressions);
}

} // namespace service

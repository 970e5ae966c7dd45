// Any text is a scene's, and any bytes are the recording of its evaluation: commands, words and
// lists have their places in the text, and what is made of them names its faults there. Nothing is
// evaluated: a script that runs may end the process that it runs in, which is what evaluators are
// for (tests/hostile).
#include "input.h"
#include "require.h"

#include "script/evaluator.h"
#include "script/instrument.h"
#include "script/make_scene.h"
#include "script/structure.h"
#include "script/verdict.h"
#include "script/wire.h"

#include <deque>

namespace {

using script::Structure;

bool isWithin(scene::Range range, std::size_t size) {
    return range.from <= range.to && range.to <= size;
}

void checkStructure(const Structure& structure, std::string_view text) {
    std::size_t from = 0;
    for (const script::Command& command : structure.commands) {
        FUZZ_REQUIRE(isWithin(command.range, text.size()) && command.range.from >= from);
        from = command.range.from;
        for (const script::Word& word : command.words)
            FUZZ_REQUIRE(isWithin(word.range, text.size()) && isWithin(word.content, text.size()));
    }
    for (const script::Fault& fault : structure.faults)
        FUZZ_REQUIRE(isWithin(fault.range, text.size()) && !fault.message.empty());
}

void checkList(std::string_view text) {
    const script::ElementList list = script::elementsOf(text, 1000);
    for (const script::Element& element : list.elements)
        FUZZ_REQUIRE(isWithin(element.range, text.size()) &&
                     isWithin(element.content, text.size()));
}

void checkMarks(std::string_view text, const Structure& structure) {
    const std::string mark = script::markFor(text);
    FUZZ_REQUIRE(text.find(mark) == std::string_view::npos);
    const std::string marked = script::instrumented(text, structure, mark);
    FUZZ_REQUIRE(script::withoutMarks(marked, mark).size() >= text.size());
}

// As if every command ran once, with its words as they are written.
std::string recordingOf(std::string_view text, const Structure& structure) {
    script::RecordingWriter writer;
    for (const script::Command& command : structure.commands) {
        std::vector<std::string_view> words;
        for (const script::Word& word : command.words)
            words.push_back(text.substr(word.content.from, word.content.to - word.content.from));
        const std::uint64_t caller =
            command.parent < 0
                ? script::noOffset
                : structure.commands[static_cast<std::size_t>(command.parent)].range.from;
        writer.command(command.range.from, caller, words);
    }
    writer.end({});
    return writer.bytes();
}

void checkMade(std::string_view text, std::string recording) {
    script::Answer answer;
    answer.bytes = std::move(recording);
    const script::ReadResult result = script::judge(text, answer, {}, {{"n", 3}, {"g", 9.8}});
    for (const scene::Diagnostic& diagnostic : result.diagnostics) {
        FUZZ_REQUIRE(isWithin(diagnostic.range, text.size()) && !diagnostic.message.empty());
        (void)scene::formatted(diagnostic, "scene.al", std::string(text));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (script::refuse(text, size + 1)) {
        // No text: the bytes that a subverted evaluator answers.
        checkMade("body b s", std::string(text));
        return 0;
    }
    const Structure structure = script::structureOf(text);
    checkStructure(structure, text);
    checkList(text);
    checkMarks(text, structure);
    checkMade(text, recordingOf(text, structure));
    return 0;
}

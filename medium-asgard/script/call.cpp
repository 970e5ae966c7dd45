// A recorded command and the command of the text that it is a run of.
#include "script/scene_maker.h"

namespace script {

namespace {

// The word of the text that the word at `index` of `count` came from. Between words that {*} made
// into several, places are known from either end only.
const Word* wordOf(const Command& command, std::size_t index, std::size_t count, bool& whole) {
    const std::vector<Word>& words = command.words;
    std::size_t front = 0;
    while (front < words.size() && !words[front].expanded)
        ++front;
    whole = true;
    if (index < front || words.size() == front)
        return index < words.size() ? &words[index] : nullptr;
    std::size_t back = 0;
    while (back < words.size() && !words[words.size() - 1 - back].expanded)
        ++back;
    if (index + back >= count)
        return &words[words.size() - (count - index)];
    whole = false;
    return &words[front];
}

} // namespace

Call callOf(std::string_view text, const Structure& structure, const RecordedCommand& recorded) {
    Call call;
    const Command* command =
        recorded.offset == noOffset ? nullptr : structure.startingAt(recorded.offset);
    const Command* caller =
        recorded.caller == noOffset ? nullptr : structure.startingAt(recorded.caller);
    Range fallback;
    if (command) {
        call.source.command = command->range;
    } else if (caller && !caller->words.empty()) {
        fallback = caller->words[0].range; // the nearest place that is known
    }
    for (std::size_t i = 0; i < recorded.words.size(); ++i) {
        Value value;
        value.text = recorded.words[i];
        value.range = fallback;
        bool whole = false;
        const Word* word = command ? wordOf(*command, i, recorded.words.size(), whole) : nullptr;
        if (word) {
            value.range = word->range;
            const std::string_view content =
                text.substr(word->content.from, word->content.to - word->content.from);
            value.exact = whole && word->literal && !word->expanded && content == value.text;
            value.origin = word->content.from;
        }
        call.words.push_back(std::move(value));
    }
    return call;
}

} // namespace script

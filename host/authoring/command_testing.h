// A document before and after a command, written short, for tests.
#pragma once

#include "authoring/authoring.h"
#include "authoring/authoring_testing.h"
#include "authoring/draft.h"
#include "document/faults.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace authoring {

using Command = std::function<Result(const Manuscript&, Selection)>;

inline std::string inside(const std::string& body, const std::string& before,
                          const std::string& after) {
    return body.substr(before.size(), body.size() - before.size() - after.size());
}

// The document after the command, with its marks; "refused: " and the sentence. The step's inverse
// gives the bytes back, and the structure has no fault that it had not before.
inline std::string after(const std::string& before, const Command& command) {
    const Marked marked = readMarks(renamed(before, false));
    document::Document document(marked.bytes);
    EXPECT_FALSE(document.isBroken()) << before;
    const auto faults = [&] {
        std::string all;
        for (const sgml::Fault& fault :
             document::documentFaults(document, testSchemas(), {"ANIMATION"}))
            all += fault.message + "\n";
        return all;
    };
    const std::string first = faults();
    const Result result = command({document, testGrammars()}, marked.selection);
    if (const auto* refusal = std::get_if<Refusal>(&result))
        return "refused: " + refusal->why.toStdString();
    const Step& step = std::get<Step>(result);
    EXPECT_FALSE(step.label.isEmpty());
    const text::Edits back = text::inverse(document.bytes(), step.edits);
    if (!step.edits.empty()) {
        EXPECT_EQ(document.edit(step.edits, step.label), document::EditResult::applied);
    }
    EXPECT_EQ(text::applied(document.bytes(), back), marked.bytes);
    EXPECT_EQ(faults(), first) << document.bytes();
    return renamed(withMarks(document.bytes(), step.after), true);
}

inline const std::string memoHead = "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{S}</SUBJECT>\n<BODY>\n";
inline const std::string memoTail = "\n</BODY>\n</CMEMO>\n";
inline const std::string reportHead = "DOCUMENT REPORT\n<REPORT>\n<TITLE>{T}</TITLE>\n";
inline const std::string reportTail = "\n</REPORT>\n";

inline std::string cut(const std::string& whole, const std::string& head, const std::string& tail) {
    return whole.starts_with("refused") ? whole : inside(whole, head, tail);
}

// In the body of a memo.
inline std::string memo(const std::string& body, const Command& command) {
    return cut(after(memoHead + body + memoTail, command), memoHead, memoTail);
}

// In a report.
inline std::string report(const std::string& body, const Command& command) {
    return cut(after(reportHead + body + reportTail, command), reportHead, reportTail);
}

inline Command typed(const std::string& text) {
    return [text](const Manuscript& manuscript, Selection selection) {
        return type(manuscript, selection, text);
    };
}

inline Result enter(const Manuscript& manuscript, Selection selection) {
    return breakParagraph(manuscript, selection);
}

inline Command erased(Direction direction, Unit unit = Unit::character) {
    return [=](const Manuscript& manuscript, Selection selection) {
        return erase(manuscript, selection, direction, unit);
    };
}

inline const Command backspace = erased(Direction::backward);
inline const Command del = erased(Direction::forward);

} // namespace authoring

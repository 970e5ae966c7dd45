// Changes of the text that windows of the process propose to the host.
#include "service/session_testing.h"

namespace service {
namespace {

using namespace held;

TEST_F(SessionTest, AChangeIsTheHostsToAcceptAndThenTheTextHere) {
    load("one two", 7);
    std::optional<std::optional<std::string>> refusal;
    const auto keep = [&](std::optional<std::string> why) { refusal = std::move(why); };
    session->propose({4, 7, "three"}, "Edit text", keep);
    exchange();
    ASSERT_EQ(asked.size(), 1u);
    const auto& change = std::get<ipc::SubdocumentChanged>(asked[0].call);
    EXPECT_EQ(change.base, 7);
    EXPECT_EQ(change.label, "Edit text");
    ASSERT_EQ(change.edits.size(), 1u);
    EXPECT_EQ(change.edits[0].text, "three");
    EXPECT_EQ(session->subdocument().text(), "one two");
    EXPECT_FALSE(refusal);
    host.answer(asked[0].id, ipc::Revised{8});
    exchange();
    ASSERT_TRUE(refusal);
    EXPECT_EQ(*refusal, std::nullopt);
    EXPECT_EQ(session->subdocument().text(), "one three");
    EXPECT_EQ(session->subdocument().revision(), 8);
}

TEST_F(SessionTest, AChangeOfATextThatTheHostHasChangedMeanwhileIsRefused) {
    load("one two", 7);
    std::optional<std::string> why;
    session->propose({4, 7, "three"}, "Edit text", [&](auto refusal) { why = refusal; });
    exchange();
    ask(ipc::SubdocumentEdit{8, {{0, 3, "1"}}, "Undo"});
    ASSERT_EQ(asked.size(), 1u);
    host.refuse(asked[0].id, {ipc::ErrorCode::staleBase, "the text is at revision 8"});
    exchange();
    EXPECT_EQ(why, "the text is at revision 8");
    EXPECT_EQ(session->subdocument().text(), "1 two");
}

} // namespace
} // namespace service

// "|" stands for the place of the caret.
#include "element_edits/completion.h"

#include "script/commands.h"
#include "script/reader.h"
#include "script/structure.h"

#include <gmock/gmock.h>

namespace editing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Completion at(std::string text, const scene::Scene& scene = {}) {
    const std::size_t place = text.find('|');
    text.erase(place, 1);
    return completionAt(text, place, scene);
}

std::vector<std::string> words(const std::string& text) { return at(text).words; }

const std::string two = "shape_set ball -desc {-sub {-sphere 1}}\nshape_set box -desc {}\n"
                        "body b1 ball\nbody b2 box\ntrajectory path -points {}\n";

TEST(Completion, OffersCommandsWhereACommandBegins) {
    EXPECT_THAT(words("bo|"), ElementsAre("body"));
    EXPECT_THAT(words("foreach i {1 2} {\n    bo|"), ElementsAre("body"));
    EXPECT_THAT(words("foreach i {1 2} {\n    bo|\n}\n"), ElementsAre("body"));
    EXPECT_THAT(words("fore|"), ElementsAre("foreach"));
    EXPECT_THAT(words("set x [ex|"), ElementsAre("expr"));
    EXPECT_THAT(words("|"), Contains("simulator"));
    EXPECT_THAT(words("set bo|"), IsEmpty());
    EXPECT_THAT(words("# bo|"), IsEmpty());
}

TEST(Completion, OffersOptionsThatAreNotThereYet) {
    EXPECT_THAT(words("body b ball -init_p|"), ElementsAre("-init_pos"));
    EXPECT_THAT(words("body b ball -|"), Contains("-mass"));
    EXPECT_THAT(words("body b ball -mass 2 \\\n  -ma|"), IsEmpty());
    EXPECT_THAT(words("foreach i {1 2} { body b$i ball -mas|"), ElementsAre("-mass"));
    EXPECT_THAT(words("proc p {} { link -tight|"), ElementsAre("-tightness"));
    EXPECT_THAT(words("body b ball | -mass 2"), Contains("-color"));
}

TEST(Completion, KnowsJointsGearsAndSprings) {
    const std::string text = two + "joint pin -type hinge -body1 b1\n"
                                   "joint tube -type cylindrical -body1 b2 -axis {1 0 0}\n"
                                   "spring cord -body1 b1 -body2 b2 -stiffness 1\n"
                                   "spring -body1 b1 -body2 b2 -stiffness 1\n";
    EXPECT_THAT(words("joint pin -type h|"), ElementsAre("hinge"));
    EXPECT_THAT(words("joint pin -pos|"), ElementsAre("-position", "-position1", "-position2"));
    EXPECT_THAT(words(text + "gear g -joint1 |"), ElementsAre("pin", "tube"));
    EXPECT_THAT(words(text + "force -body b1 -x {pin.d|"), ElementsAre("dq"));
    EXPECT_THAT(words(text + "force -body b1 -x {tube.d|"), ElementsAre("dq1", "dq2"));
    EXPECT_THAT(words(text + "force -body b1 -x {cord.|"), ElementsAre("length", "force"));
    EXPECT_THAT(words(text + "force -body b1 -x {co|"), Contains("cord"));
    EXPECT_THAT(words("spring -body1 b -pull|"), ElementsAre("-pull_only"));
    EXPECT_THAT(words("rope r -cl|"), ElementsAre("-closed"));
    EXPECT_THAT(words("contact -body1 b -co|"), ElementsAre("-collide"));
    EXPECT_THAT(words(text + "contact -body1 |"), ElementsAre("b1", "b2"));
    EXPECT_THAT(words(text + "contact c -body1 b1 -body2 b2\nplot p -values {c.s|}"),
                ElementsAre("slip", "state"));
    EXPECT_THAT(words(text + "rope r -points {}\nplot p -values {r.|}"),
                ElementsAre("length", "tension", "tension1"));
}

TEST(Completion, OffersNamesOfWhatTheTextHas) {
    EXPECT_THAT(words(two + "body b3 ba|"), ElementsAre("ball"));
    EXPECT_THAT(words(two + "body b3 -shape b|"), ElementsAre("ball", "box"));
    EXPECT_THAT(words(two + "force -body |"), ElementsAre("b1", "b2"));
    EXPECT_THAT(words(two + "constrain |"), Contains("b2"));
    EXPECT_THAT(words(two + "constrain b1 -pos |"), ElementsAre("path"));
    EXPECT_THAT(words("force -frame |"), ElementsAre("world", "body"));
    // What is being typed is not offered to itself.
    EXPECT_THAT(words("body b|"), IsEmpty());
}

TEST(Completion, OffersNamesOfTheSceneThatALoopMade) {
    scene::Scene scene;
    scene.bodies.emplace_back().name = "made3";
    scene.parameters.emplace_back().name = "gravity";
    EXPECT_THAT(at("force -body ma|", scene).words, ElementsAre("made3"));
    EXPECT_THAT(at("set x $gra|", scene).words, ElementsAre("gravity"));
}

TEST(Completion, OffersQuantitiesInExpressions) {
    EXPECT_THAT(words(two + "force -body b1 -y {-10 * b1.ma|"), ElementsAre("mass"));
    EXPECT_THAT(words(two + "force -body b1 -y {-10 * b1.ma|}"), ElementsAre("mass"));
    EXPECT_THAT(words(two + "force -body b1 -y {b1.pd|}"), ElementsAre("pdx", "pdy", "pdz"));
    EXPECT_THAT(words(two + "force -body b1 -x {path.|}"),
                ElementsAre("x", "y", "z", "dx", "dy", "dz"));
    EXPECT_THAT(words(two + "force -body b1 -x {2 * si|}"), ElementsAre("sign", "sin", "sinh"));
}

TEST(Completion, SaysWhatIsWanted) {
    EXPECT_THAT(at("body b ball -init_pos |").hint, HasSubstr("where its reference point starts"));
    EXPECT_THAT(at("body |").hint, HasSubstr("body NAME SHAPE"));
}

TEST(Completion, AnyTextIsAnswered) {
    const std::string text = two + "foreach i {1 2} { body b$i [list ball \"x y -init_pos {1 2 3}";
    for (std::size_t i = 0; i <= text.size(); ++i)
        for (const std::string& word : completionAt(text, i, {}).words)
            EXPECT_FALSE(word.empty());
}

// The hints know the options that the reader knows.
TEST(Hints, NameTheOptionsThatScenesHave) {
    script::Reader reader;
    EXPECT_EQ(commandHints().size(), script::sceneCommands().size());
    const auto complains = [&](const std::string& line, const std::string& option) {
        for (const auto& diagnostic : reader.read(line + " " + option + " 1\n").diagnostics)
            if (diagnostic.message.find("no option") != std::string::npos)
                return diagnostic.suggestion;
        return std::string();
    };
    for (const CommandHint& hint : commandHints()) {
        std::string line(hint.name);
        line += hint.named ? " n" : hint.second == Wants::body ? " b" : "";
        line += hint.second == Wants::shapeSet ? " s" : "";
        for (const OptionHint& option : hint.options)
            EXPECT_EQ(complains(line, std::string(option.name)), "") << hint.name << option.name;
        // The first dozen of those that there are is told with the fault.
        std::string told = complains(line, "-nothing_like_this");
        ASSERT_FALSE(told.empty()) << line;
        std::erase_if(told, [](char c) { return c == ',' || c == ')'; });
        std::size_t known = 0;
        for (std::size_t at = told.find(" -"); at != std::string::npos; ++known) {
            const std::size_t end = std::min(told.find(' ', at + 1), told.size());
            EXPECT_NE(hintOf(hint, told.substr(at + 1, end - at - 1)), nullptr) << told;
            at = told.find(" -", at + 1);
        }
        EXPECT_GT(known, 0U) << told;
        if (told.find("...") == std::string::npos) {
            EXPECT_EQ(known, hint.options.size()) << told;
        }
    }
}

TEST(Completion, KnowsAWordThatIsWhole) {
    EXPECT_TRUE(at("for|").whole);
    EXPECT_THAT(words("for|"), Contains("force"));
    EXPECT_TRUE(at("force|").whole);
    EXPECT_FALSE(at("forc|").whole);
    EXPECT_FALSE(at("|").whole);
}

TEST(Hints, NameTheMethodsThatThereAre) {
    script::Reader reader;
    const auto told = [&](const std::string& method) {
        const auto result = reader.read("simulator -method " + method + "\n");
        return result.diagnostics.empty() ? std::string() : result.diagnostics.front().suggestion;
    };
    const std::string_view choices = hintOf(*hintOf("simulator"), "-method")->choices;
    std::string listed;
    for (const auto& method : script::elementsOf(choices).elements) {
        EXPECT_EQ(told(method.value), "") << method.value;
        listed += (listed.empty() ? "" : ", ") + method.value;
    }
    EXPECT_EQ(told("nothing"), "(methods: " + listed + ")");
}

} // namespace
} // namespace editing

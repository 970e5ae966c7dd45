#include "processes/environment.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace media {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class EnvironmentTest : public ::testing::Test {
protected:
    void give(const char* name, const char* value) {
        setenv(name, value, 1);
        given_.push_back(name);
    }
    void TearDown() override {
        for (const char* name : given_)
            unsetenv(name);
    }
    std::vector<const char*> given_;
};

TEST_F(EnvironmentTest, AConfinedProcessLearnsNothingOfTheDesktop) {
    give("QT_SCALE_FACTOR", "2");
    give("DISPLAY", ":7");
    give("LC_ALL", "de_DE.UTF-8");
    for (const ipc::Mode mode : {ipc::Mode::play, ipc::Mode::batch})
        EXPECT_THAT(environmentFor(mode),
                    ::testing::ElementsAre(StartsWith("PATH="), "LANG=C.UTF-8", "LC_ALL=C.UTF-8"));
}

TEST_F(EnvironmentTest, WindowsLookAndTypeLikeAllOthers) {
    const std::pair<const char*, const char*> theirs[] = {
        {"QT_SCALE_FACTOR", "2"},        {"QT_QPA_PLATFORMTHEME", "gtk3"},
        {"QT_STYLE_OVERRIDE", "Fusion"}, {"QT_IM_MODULE", "ibus"},
        {"XMODIFIERS", "@im=ibus"},      {"XCURSOR_SIZE", "48"},
        {"XDG_CONFIG_HOME", "/c"},       {"GTK_THEME", "Adwaita:dark"},
        {"LANGUAGE", "de:en"},           {"DISPLAY", ":7"}};
    for (const auto& [name, value] : theirs)
        give(name, value);
    give("SSH_AUTH_SOCK", "/secret");
    give("LD_PRELOAD_OF_MINE", "/secret");
    const std::vector<std::string> got = environmentFor(ipc::Mode::edit);
    for (const auto& [name, value] : theirs)
        EXPECT_THAT(got, Contains(std::string(name) + '=' + value));
    EXPECT_THAT(got, Not(Contains(HasSubstr("/secret"))));
}

TEST_F(EnvironmentTest, TheLanguageIsTheUsersAndNumbersAreC) {
    give("LANG", "fr_FR.UTF-8");
    give("LC_TIME", "en_GB.UTF-8");
    give("LC_NUMERIC", "fr_FR.UTF-8");
    EXPECT_THAT(environmentFor(ipc::Mode::edit),
                ::testing::AllOf(Contains("LANG=fr_FR.UTF-8"), Contains("LC_TIME=en_GB.UTF-8"),
                                 Contains("LC_NUMERIC=C"), Not(Contains(StartsWith("LC_ALL=")))));
    give("LC_ALL", "de_DE.UTF-8"); // holds for everything
    EXPECT_THAT(environmentFor(ipc::Mode::edit),
                ::testing::AllOf(Contains("LANG=de_DE.UTF-8"), Contains("LC_TIME=de_DE.UTF-8"),
                                 Contains("LC_NUMERIC=C"), Not(Contains(StartsWith("LC_ALL=")))));
}

} // namespace
} // namespace media

#include "screen/display.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <map>

namespace screen {
namespace {

std::string faultWith(const std::map<std::string, std::string>& variables) {
    return displayFault([&](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? std::string() : found->second;
    });
}

// Listens, as a display server does.
class Server {
public:
    explicit Server(const std::string& name) : name_(name) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, name.data(), name.size());
        std::filesystem::remove(name_);
        const auto* place = reinterpret_cast<const sockaddr*>(&address);
        EXPECT_EQ(bind(handle_, place, sizeof address), 0);
        EXPECT_EQ(listen(handle_, 4), 0);
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    ~Server() {
        close(handle_);
        std::filesystem::remove(name_);
    }

private:
    std::string name_;
    int handle_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
};

TEST(Display, IsMissingWhenNothingNamesOne) {
    EXPECT_EQ(faultWith({}), "there is no display to open a window on");
    EXPECT_EQ(faultWith({{"QT_QPA_PLATFORM", "offscreen"}}), "");
}

TEST(Display, ThatDoesNotAnswerIsNamed) {
    EXPECT_EQ(faultWith({{"DISPLAY", ":4711"}}), "the display :4711 does not answer");
    EXPECT_EQ(faultWith({{"DISPLAY", "nonsense"}}), "the display nonsense does not answer");
    EXPECT_EQ(faultWith({{"WAYLAND_DISPLAY", "wayland-9"}, {"XDG_RUNTIME_DIR", "/nowhere"}}),
              "the display wayland-9 does not answer");
    EXPECT_EQ(faultWith({{"DISPLAY", "far.example:0"}}), ""); // not ours to try
}

TEST(Display, ThatListensIsTaken) {
    const std::string folder = testing::TempDir();
    const Server server(folder + "/wayland-7");
    EXPECT_EQ(faultWith({{"WAYLAND_DISPLAY", "wayland-7"}, {"XDG_RUNTIME_DIR", folder}}), "");
    EXPECT_EQ(faultWith({{"WAYLAND_DISPLAY", folder + "/wayland-7"}}), "");
    EXPECT_EQ(
        faultWith(
            {{"DISPLAY", ":4711"}, {"WAYLAND_DISPLAY", "wayland-7"}, {"XDG_RUNTIME_DIR", folder}}),
        "");
    EXPECT_EQ(faultWith({{"DISPLAY", folder + "/wayland-7:0"}}), ""); // a socket by its name
}

} // namespace
} // namespace screen

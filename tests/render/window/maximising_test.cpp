// A maximised window is maximised again after filling the screen, whatever the window manager does meanwhile.
#include "render/window/maximising.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace trembler::render::test {
namespace maximising_test {
namespace {

/// A window manager that carries out requests after a number of pictures.
class FakeDesktop {
public:
    FakeDesktop(bool maximised, bool forgets, int delay)
        : forgets_(forgets), delay_(delay), state_{false, maximised} {}

    void fullscreen(bool on) {
        maximising_.switches(on, state_, seconds_);
        asked_.push_back({delay_, [this, on] {
                              state_.fullscreen = on;
                              state_.maximised = state_.maximised && !(forgets_ && on);
                          }});
        follow();
    }
    void picture() {
        seconds_ += 1.0 / 60;
        for (Request& request : asked_) {
            if (request.left-- == 0) {
                request.done();
            }
        }
        follow();
    }
    void pictures(int count) {
        for (int i = 0; i < count; ++i) {
            picture();
        }
    }
    /// Time in which nothing is drawn, as nothing changes.
    void wait(double seconds) { seconds_ += seconds; }
    void restore() { state_.maximised = false; }
    [[nodiscard]] WindowState state() const { return state_; }

private:
    struct Request {
        int left;
        std::function<void()> done;
    };
    void follow() {
        if (maximising_.due(state_, seconds_)) {
            state_.maximised = true;
        }
    }

    bool forgets_;
    int delay_;
    WindowState state_;
    double seconds_ = 100;
    Maximising maximising_;
    std::vector<Request> asked_;
};

TEST(Maximising, ComesBackFromTheWholeScreen) {
    for (bool const forgets : {false, true}) {
        for (int const delay : {0, 1, 8}) {
            FakeDesktop desktop(true, forgets, delay);
            for (int turn = 0; turn < 3; ++turn) {
                desktop.fullscreen(true);
                desktop.pictures(30);
                ASSERT_TRUE(desktop.state().fullscreen);
                desktop.fullscreen(false);
                desktop.pictures(30);
                EXPECT_FALSE(desktop.state().fullscreen);
                EXPECT_TRUE(desktop.state().maximised) << forgets << ", " << delay << ", " << turn;
            }
        }
    }
}

TEST(Maximising, LeavesOtherWindowsAlone) {
    FakeDesktop desktop(false, true, 1);
    desktop.fullscreen(true);
    desktop.pictures(30);
    desktop.fullscreen(false);
    desktop.pictures(30);
    EXPECT_FALSE(desktop.state().maximised);
}

TEST(Maximising, EndsSoon) {
    FakeDesktop desktop(true, true, 0);
    desktop.fullscreen(true);
    desktop.pictures(30);
    desktop.fullscreen(false);
    desktop.pictures(70);
    desktop.restore(); // by the player
    desktop.pictures(30);
    EXPECT_FALSE(desktop.state().maximised);
}

TEST(Maximising, EndsSoonWhereHardlyAnythingIsDrawn) {
    FakeDesktop desktop(true, true, 0);
    desktop.fullscreen(true);
    desktop.pictures(2);
    desktop.fullscreen(false);
    desktop.pictures(2);
    ASSERT_TRUE(desktop.state().maximised);
    desktop.wait(4);
    desktop.restore();
    desktop.pictures(30);
    EXPECT_FALSE(desktop.state().maximised);
}

TEST(Maximising, SettingsThatAreAppliedAgainChangeNothing) {
    FakeDesktop desktop(true, false, 0);
    desktop.fullscreen(false);
    desktop.pictures(2);
    desktop.restore();
    desktop.pictures(30);
    EXPECT_FALSE(desktop.state().maximised);
}

} // namespace
} // namespace maximising_test
} // namespace trembler::render::test

// Files that are dropped onto the window, and modifiers; the other events are tested by the screens that use
// them.
#include "render/window/input_events.hpp"
#include "tests/render/stage.hpp"
#include "tests/support/synthetic_input.hpp"

#include <gtest/gtest.h>

namespace trembler::render::test {
namespace {

TEST(InputEvents, FilesThatAreDroppedAreThereForOneFrame) {
    Window const& window = test::window(); // a second one would take the context from the shared canvas
    InputEvents input(window);
    input.poll();
    std::filesystem::path const first = "/tmp/one.json";
    std::filesystem::path const second =
        std::filesystem::path("/tmp") / std::filesystem::path(u8"Lösung.json");
    pushDrop(window, first);
    pushDrop(window, second);
    input.poll();
    ASSERT_EQ(input.dropped().size(), 2U);
    EXPECT_EQ(input.dropped()[0], first);
    EXPECT_EQ(input.dropped()[1], second);
    for (SDL_Event const& event : input.events()) {
        EXPECT_TRUE(event.type != SDL_DROPFILE || event.drop.file == nullptr) << "its text is freed";
    }
    input.poll();
    EXPECT_TRUE(input.dropped().empty());
}

// At five pictures a second Ctrl is pressed and let go again between two of them.
TEST(InputEvents, ModifiersOfASlowFrameAreNotLost) {
    Window const& window = test::window();
    InputEvents input(window);
    input.poll();
    pushKey(window, SDLK_LCTRL, true, KMOD_LCTRL);
    pushMouseButton(window, MouseButton::Left, true, {10, 10});
    pushKey(window, SDLK_LCTRL, false, KMOD_NONE);
    input.poll();
    EXPECT_TRUE(input.pressed(MouseButton::Left));
    EXPECT_NE(input.modifiers() & KMOD_CTRL, 0U);
    input.poll();
    EXPECT_EQ(input.modifiers() & KMOD_CTRL, 0U) << "of that frame only";
}

} // namespace
} // namespace trembler::render::test

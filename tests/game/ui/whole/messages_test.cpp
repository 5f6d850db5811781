// Messages cover nothing that the player must see.
#include "tests/game/ui/drawn_text.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>
#include <fstream>

namespace trembler::ui::test {
namespace messages_test {
namespace {

/// A level without a toolbox, so that its success is shown in the middle, where messages come, too.
std::filesystem::path levelWithoutToolbox() {
    auto const file = testFolder() / "roll.json";
    std::ofstream(file) << R"({"version": 2, "title": "Roll",
        "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4]},
        "objects": [
            {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
             "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}},
            {"name": "ball", "part": "rubber ball", "at": [0, 0.4]}],
        "goals": {"moved": {"object": "ball", "by": 0.5}}})";
    return file;
}

TEST(Messages, LieBelowTheCardOfSuccess) {
    for (render::Size const size : {render::Size{1280, 720}, render::Size{800, 600}}) {
        Player player(size);
        player.open(levelWithoutToolbox());
        player.key(SDLK_SPACE);
        player.simulate(30);
        World const& world = player.session().world();
        Vec2 const ball = world.find<Position>(world.store().find("ball"))->value;
        player.drag(player.at(ball), player.at(ball + Vec2{1.5, 0.5}), MouseButton::Left, 30);
        player.simulate(60);
        ASSERT_TRUE(player.session().solved());
        player.frames(30);
        ASSERT_TRUE(player.showsCard("success"));
        std::string const message = "A message that is of some length, which says where something was kept.";
        player.app().context().toasts.add(message);
        player.app().context().toasts.add(message + " Once more.");
        player.frames(30);
        auto const card = player.layout().card("success");
        ASSERT_TRUE(card);
        int seen = 0;
        for (DrawnText const& text : drawnTexts()) {
            if (text.text.starts_with("A message")) {
                ++seen;
                EXPECT_FALSE(card->overlaps(text.rect)) << size.width;
                EXPECT_LE(text.rect.high.y, size.height);
            }
        }
        EXPECT_EQ(seen, 2) << size.width;
        player.look("messages-" + std::to_string(size.width));
    }
}

TEST(Messages, LieOnNoCard) {
    for (render::Size const size : {render::Size{1280, 720}, render::Size{800, 600}}) {
        Player player(size);
        player.open(levelsFolder() / "5-everything/2-the-gate.json");
        player.frames(10);
        std::string const message = "A message that is of some length, which says where something was kept.";
        player.app().context().toasts.add(message);
        player.app().context().toasts.add(message + " Once more.");
        player.frames(30);
        int seen = 0;
        for (DrawnText const& text : drawnTexts()) {
            if (text.text.starts_with("A message")) {
                ++seen;
                for (Placed const& card : player.layout().cards()) {
                    EXPECT_FALSE(card.rect.overlaps(text.rect)) << card.name << " at " << size.width;
                }
                EXPECT_LE(text.rect.high.y, 0.6 * size.height) << size.width;
            }
        }
        EXPECT_GE(seen, 2) << size.width;
        player.look("messages-beside-cards-" + std::to_string(size.width));
    }
}

} // namespace
} // namespace messages_test
} // namespace trembler::ui::test

// Saving, changing the simulation while it runs, and starting again, with real input events.
#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace keeping_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";
auto const experiment = levelsFolder() / "experiments/1-switched-electromagnet.json";

ComponentStatus statusOf(World const& world, std::string const& name) {
    for (ComponentStatus const& status : world.status()) {
        if (title(*status.info) == name) {
            return status;
        }
    }
    ADD_FAILURE() << "no component " << name;
    return {};
}

TEST(Keeping, ARunIsSavedAndReplayedWithoutAWindow) {
    Player player;
    std::filesystem::remove_all(player.films());
    player.open(firstContact);
    player.key(SDLK_s, KMOD_LCTRL); // nothing has run yet: a message, and no file
    auto const saved = [&] { return player.app().context().solutions.of("first/1-first-contact.json"); };
    EXPECT_TRUE(saved().empty());
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    player.simulate(160);
    // Also an input by hand: the bar is lifted off its contacts and released.
    auto const& bar = player.session().world().find<Position>(
        player.session().objectOf(player.session().placed()[0].number));
    player.moveTo(player.at(bar->value));
    player.press();
    player.moveTo(player.at(bar->value + Vec2{0, 0.4}));
    player.frames(20);
    player.release();
    player.frames(3);
    player.key(SDLK_p);
    ASSERT_TRUE(player.session().solved());
    ASSERT_FALSE(player.session().inputs().empty());
    player.clickItem("save");
    ASSERT_EQ(saved().size(), 1U);
    auto const file = saved().front().file;

    LevelFile const level = loadLevel(gameData().registry, firstContact);
    Solution const solution = findOrLoadSolution(gameData().registry, level, file.string());
    EXPECT_TRUE(solution.solves);
    Session headless(gameData().registry, gameData().parts, level);
    headless.load(solution);
    while (headless.world().frame() < player.session().world().frame()) {
        headless.step();
    }
    EXPECT_TRUE(headless.solved());
    EXPECT_EQ(headless.world().stateHash(), player.session().world().stateHash());
    player.key(SDLK_s, KMOD_LCTRL);
    EXPECT_EQ(saved().size(), 2U);
}

TEST(Keeping, ContactsHaveNormalsAndImpulsesAsSoonAsTheyAreShown) {
    Player player;
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.simulate(120);
    player.key(SDLK_p);
    player.look("contacts-off-720");
    player.key(SDLK_3);
    player.look("contacts-720");
    auto const* patches = player.session().world().find<ContactPatches>();
    ASSERT_NE(patches, nullptr);
    double impulse = 0;
    for (ContactPatch const& patch : patches->patches) {
        EXPECT_NEAR(length(patch.normal), 1, 1e-6);
        impulse = std::max(impulse, patch.normalImpulse[0]);
    }
    EXPECT_GT(impulse, 0);
    // The display has no influence: the same run without it ends with the same bits.
    Session blind(gameData().registry, gameData().parts, loadLevel(gameData().registry, experiment));
    while (blind.world().frame() < player.session().world().frame()) {
        blind.step();
    }
    EXPECT_EQ(blind.world().stateHash(), player.session().world().stateHash());
}

TEST(Keeping, DetailAndPeriodAreChangedWhileItRuns) {
    Player player;
    player.open(experiment);
    player.key(SDLK_SPACE);
    player.simulate(24);
    player.key(SDLK_c);
    player.frames(3);
    EXPECT_EQ(statusOf(player.session().world(), "Two-wire Electricity DPS").activity == Activity::absent,
              false);
    player.clickItem("detail of electricity");
    player.frames(3);
    player.look("detail-720");
    player.clickItem("level single-cable"); // other physics: not allowed while the level runs
    player.frames(3);
    EXPECT_FALSE(player.session().world().options().detail.contains("electricity"));
    player.clickItem("level nodal");
    player.frames(3);
    EXPECT_EQ(player.session().world().options().detail.at("electricity"), "nodal");
    EXPECT_EQ(statusOf(player.session().world(), "Two-wire Electricity DPS").activity, Activity::absent);
    player.scrollTo("components", "period of Electricity Resolver");
    Point const fixed = player.item("period of Electricity Resolver"); // it must run in every frame
    player.drag(fixed, fixed + Point{60, 0});
    player.frames(2);
    EXPECT_EQ(statusOf(player.session().world(), "Electricity Resolver").period, 1);
    player.scrollTo("components", "period of Magnetic Forces DPS");
    player.wheel(-1); // away from the edge of the list
    player.frames(2);
    Point const field = player.item("period of Magnetic Forces DPS");
    player.drag(field, field + Point{60, 0});
    player.frames(2);
    int const period = statusOf(player.session().world(), "Magnetic Forces DPS").period;
    EXPECT_GT(period, 1);
    EXPECT_LE(period, 4);
    EXPECT_EQ(player.session().mode(), SessionMode::running);
    // The change holds for later runs as well.
    player.clickItem("stop");
    player.key(SDLK_SPACE);
    player.frames(3);
    EXPECT_EQ(statusOf(player.session().world(), "Magnetic Forces DPS").period, period);
}

TEST(Keeping, TheHandReleasesWhenTheWindowLosesTheFocus) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    player.simulate(160);
    auto const bar = player.session().objectOf(player.session().placed()[0].number);
    Vec2 const from = player.session().world().find<Position>(bar)->value;
    player.moveTo(player.at(from));
    player.press();
    player.moveTo(player.at(from + Vec2{0, 0.3}));
    player.frames(2);
    ASSERT_EQ(player.play().hand().held(), bar);
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.windowID = SDL_GetWindowID(window().handle());
    event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
    SDL_PushEvent(&event);
    player.frames(2);
    EXPECT_FALSE(player.play().hand().held().valid());
    ASSERT_FALSE(player.session().inputs().empty());
    EXPECT_EQ(player.session().inputs().back().kind, PlayerInput::Kind::release);
}

TEST(Keeping, TheMenuStartsTheLevelAgain) {
    Player player;
    player.open(firstContact);
    auto const fresh = player.session().world().stateHash();
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    player.simulate(64);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.clickItem("menu.restart");
    player.frames(3);
    EXPECT_EQ(player.session().mode(), SessionMode::building);
    EXPECT_TRUE(player.session().placed().empty());
    EXPECT_EQ(player.session().world().stateHash(), fresh);
}

} // namespace
} // namespace keeping_test
} // namespace trembler::ui::test

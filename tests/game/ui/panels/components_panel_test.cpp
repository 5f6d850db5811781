// The components panel: rows, knobs and the time budget.
#include "game/ui/panels/cost_rows.hpp"
#include "game/ui/shared/words.hpp"
#include "runtime/level/model/world_change.hpp"
#include "tests/game/ui/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace trembler::ui::test {
namespace {

auto const raft = levelsFolder() / "experiments/4-raft.json";

/// A cloud of stars in orbit: costly enough to be worth a budget.
std::filesystem::path starsLevel() {
    auto const path = testFolder() / "stars.json";
    std::ofstream file(path);
    file
        << R"({"version": 2, "title": "Stars", "text": "They attract each other.", "world": {"gravity_law": )"
        << R"({"constant": 0.02, "softening": 0.3}, "bounds": [-12, -8, 24, 16]}, "objects": [)";
    for (int i = 0; i < 150; ++i) {
        double const radius = 6 * std::pow((i + 0.5) / 150, 0.7);
        double const angle = i * pi * (3 - std::sqrt(5.0));
        double const speed = 1.2 / std::sqrt(radius + 1);
        file << fmt::format(
            R"({}{{"name": "star {:03}", "at": [{}, {}], "properties": {{"shape": [{{"form": )"
            R"("circle", "radius": 0.06}}], "material": "glass", "mass": {}, )"
            R"("velocity": [{}, {}]}}}})",
            i == 0 ? "" : ", ", i, radius * std::cos(angle), radius * std::sin(angle), 1 + i % 5,
            -speed * std::sin(angle), speed * std::cos(angle));
    }
    file << "]}";
    return path;
}

bool allOnScreen(Player& player) {
    render::Size const size = window().size();
    for (Placed const& card : player.layout().cards()) {
        bool const there = card.rect.low.x >= 0 && card.rect.low.y >= 0 && card.rect.high.x <= size.width &&
                           card.rect.high.y <= size.height && card.overflow <= 1;
        if (!there) {
            ADD_FAILURE() << card.name << " is cut off by " << card.overflow;
            return false;
        }
    }
    return true;
}

/// Of a computer on which a turn always takes the same time: a busy one may take so long for what no choice
/// changes that no choice is worth making.
std::vector<ComponentStatus> steadyTimes(World const& world) {
    std::vector<ComponentStatus> all = world.status();
    for (ComponentStatus& status : all) {
        std::string const name = title(*status.info);
        double const each = name == "Real Gravity DPS" ? 900 : name == "Tree Gravity DPS" ? 300 : 1;
        status.totalMicroseconds = static_cast<double>(status.updates) * each;
    }
    return all;
}

class BudgetPanel : public testing::TestWithParam<render::Size> {
protected:
    [[nodiscard]] static std::string named(char const* what) {
        return std::string(what) + "-" + std::to_string(GetParam().height);
    }
};

TEST_P(BudgetPanel, ShowsTimesKnobsAndErrors) {
    Player player(GetParam());
    player.open(raft);
    player.key(SDLK_c);
    player.frames(3);
    player.look(named("cost-building"));
    player.key(SDLK_SPACE);
    player.simulate(90);
    player.frames(3);
    for (char const* item :
         {"budget", "budget of a frame", "detail of buoyancy", "time of buoyancy", "error of buoyancy",
          "detail of dynamics", "error of dynamics", "time of the frame"}) {
        EXPECT_TRUE(player.shows(item)) << item;
    }
    EXPECT_TRUE(allOnScreen(player));
    EXPECT_GT(player.play().budget().figures().microseconds, 0);
    player.look(named("cost"));
    player.clickItem("detail of buoyancy");
    player.frames(3);
    player.look(named("cost-unfolded"));
    ASSERT_TRUE(player.shows("option 64 particles"));
    player.clickItem("option 64 particles");
    player.frames(2);
    EXPECT_EQ(player.session().world().options().detail.at("buoyancy"), "particles");
    EXPECT_EQ(player.session().changes().size(), 3U) << "level, number and period are part of the run";
    player.clickItem("show absent components");
    player.frames(3);
    player.look(named("cost-absent"));
    EXPECT_TRUE(allOnScreen(player));
}

TEST_P(BudgetPanel, ABudgetIsKeptAndItsChangesAreReported) {
    Player player(GetParam(), {}, levelsFolder(), nullptr, steadyTimes);
    player.open(starsLevel());
    player.key(SDLK_c);
    player.frames(8); // the goal card frees its space, the panel moves up
    player.clickItem("budget");
    player.frames(2);
    ASSERT_TRUE(player.play().budget().budget());
    player.look(named("cost-switched-on"));
    // The smallest possible budget, which is exceeded.
    Point const slider = player.item("budget of a frame");
    player.drag(slider, slider - Point{0.4 * static_cast<double>(window().size().width), 0},
                MouseButton::Left, 2);
    EXPECT_NEAR(*player.play().budget().budget(), 1000 * static_cast<double>(leastBudget), 0.1);
    player.key(SDLK_SPACE);
    player.simulate(80);
    player.frames(3);
    auto const& mode = player.play().budget();
    EXPECT_TRUE(std::any_of(mode.decisions().begin(), mode.decisions().end(),
                            [](auto const& decision) { return decision.effect == "gravity"; }));
    EXPECT_FALSE(player.session().changes().empty());
    EXPECT_TRUE(allOnScreen(player));
    player.look(named("cost-budget"));
    if (std::getenv("TREMBLER_PICTURES") != nullptr) { // the one in docs/budget.md
        for (int i = 0; i < 20; ++i) {
            player.play().commands().run("more-budget");
        }
        player.simulate(200);
        player.frames(150); // until all messages about the budget have disappeared
        player.look(named("cost-kept"));
    }
    player.key(SDLK_b);
    EXPECT_FALSE(mode.budget());
    player.key(SDLK_b);
    EXPECT_TRUE(mode.budget());
    player.key(SDLK_b);
}

INSTANTIATE_TEST_SUITE_P(Sizes, BudgetPanel, testing::ValuesIn([] {
                             std::vector<render::Size> sizes{{1280, 720}};
                             // The test of all screens checks the panel at this size; this picture is for
                             // people only.
                             if (std::getenv("TREMBLER_PICTURES") != nullptr) {
                                 sizes.push_back({3840, 2160});
                             }
                             return sizes;
                         }()),
                         [](auto const& info) { return "lines" + std::to_string(info.param.height); });

// A replay repeats the recorded decisions, although the clock would lead to others now.
TEST(Budget, ItsDecisionsAreReplayedBitForBit) {
    Player player({1280, 720}, {}, levelsFolder(), nullptr, steadyTimes);
    player.open(starsLevel());
    player.key(SDLK_b);
    player.key(SDLK_COMMA);
    for (int i = 0; i < 40; ++i) {
        player.play().commands().run("less-budget");
    }
    player.key(SDLK_SPACE);
    player.simulate(136);
    ASSERT_FALSE(player.session().changes().empty());
    player.key(SDLK_p);
    std::uint64_t const frame = player.session().world().frame();
    std::uint64_t const hash = player.session().world().stateHash();
    auto const changes = player.session().changes().size();
    player.key(SDLK_b);
    player.play().commands().run("watch-again");
    while (player.session().world().frame() + 8 <= frame) {
        player.simulate(8);
    }
    while (player.session().world().frame() < frame) {
        player.frame();
    }
    EXPECT_EQ(player.session().world().stateHash(), hash);
    EXPECT_EQ(player.session().changes().size(), changes);
    // Stopping restores everything, including detail levels and settings.
    player.key(SDLK_SPACE);
    EXPECT_TRUE(player.session().world().options().detail.empty());
}

TEST(Budget, WithoutABudgetAndThePanelNothingIsMeasured) {
    Player player;
    player.open(raft);
    player.key(SDLK_SPACE);
    player.simulate(72);
    EXPECT_EQ(player.play().budget().figures().frame, 0U);
    EXPECT_TRUE(player.play().budget().knobs().empty());
}

TEST(Budget, NumbersAreRoundedForDisplay) {
    EXPECT_EQ(words::duration(3.14159), "3.1 µs");
    EXPECT_EQ(words::duration(999.4), "999 µs");
    EXPECT_EQ(words::duration(1500), "1.5 ms");
    EXPECT_EQ(words::howFarOff(0), "not at all");
    EXPECT_EQ(words::howFarOff(5e-5), "< 0.1 mm");
    EXPECT_EQ(words::howFarOff(0.00216), "2.2 mm");
    EXPECT_EQ(words::howFarOff(0.081), "8.1 cm");
    EXPECT_EQ(words::howFarOff(4.2), "4.2 m");
}

TEST(Budget, AbsentEffectsStateTheMissingProperty) {
    Player player;
    player.open(raft);
    bool seen = false;
    for (EffectCost const& cost : effectCosts(player.session().world(), player.play().budget())) {
        if (cost.effect == "magnetism") {
            seen = true;
            EXPECT_EQ(cost.activity, Activity::absent);
            EXPECT_NE(cost.reason.find("nothing has"), std::string::npos) << cost.reason;
        }
        EXPECT_EQ(cost.reason.empty(), cost.activity != Activity::absent) << cost.effect;
    }
    EXPECT_TRUE(seen);
}

} // namespace
} // namespace trembler::ui::test

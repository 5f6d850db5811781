// Free play as a player meets it: wires, and the large toolbox with its groups and its search.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/shared/texts.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "render/window/gamepad.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/tidy.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace trembler::ui::test {
namespace toolbox_card_test {
namespace {

constexpr Vec2 plus{-0.72, 0.15};
constexpr Vec2 minus{-1.28, 0.15};
constexpr Vec2 lamp{1, 1.5};

void enter(Player& who) {
    who.clickItem("free play");
    who.frames(6);
}

/// Whether the lamp shines in a run.
bool lit(Player& who) {
    who.key(SDLK_SPACE);
    who.simulate(10);
    World const& world = who.session().world();
    auto const* const state = world.find<ElectricalState>();
    bool const on = state != nullptr && state->isOn(world.store().find("lamp 1"));
    who.key(SDLK_SPACE);
    return on;
}

std::vector<Placed> wholeTiles(Player& who) {
    std::vector<Placed> all;
    for (Placed const& item : who.layout().items()) {
        if (item.name.starts_with("part ") && item.overflow < 0.5 && item.rect.low.y >= 0 &&
            item.rect.high.y <= window().size().height) {
            all.push_back(item);
        }
    }
    return all;
}

class FreePlay : public testing::Test {
protected:
    explicit FreePlay(render::Size size = {1280, 800}) : player(size) { enter(player); }
    ~FreePlay() override { useLanguage("en"); }

    void type(std::string const& letters) {
        render::pushText(window(), letters);
        player.frames(2);
    }
    void seek(std::string const& name) {
        player.key(SDLK_f, KMOD_LCTRL);
        player.frames(2);
        type(name);
    }
    /// The parts whose tiles are wholly in sight.
    [[nodiscard]] std::vector<std::string> tiles() {
        std::vector<std::string> all;
        for (Placed const& item : wholeTiles(player)) {
            all.push_back(item.name.substr(5));
        }
        return all;
    }
    void place(std::string const& part, Vec2 at) {
        seek(part);
        player.drag(player.item("part " + part), player.at(at));
    }
    void placeBatteryAndLamp() {
        place("battery", {-1, 0.15});
        place("lamp", {1, 1.5});
        ASSERT_EQ(player.session().placed().size(), 2U);
    }
    [[nodiscard]] std::string told() { return player.app().context().toasts.newest(); }

    Player player;
};

TEST_F(FreePlay, ClicksLayWiresAndTheLampLights) {
    placeBatteryAndLamp();
    EXPECT_FALSE(lit(player));
    player.key(SDLK_w);
    EXPECT_TRUE(player.play().wires().laying());
    player.moveTo(player.at({0, 3}));
    player.look("free-play-wire-begins");
    player.click(player.at(plus));
    player.click(player.at(lamp));
    ASSERT_EQ(player.session().wires().size(), 1U);
    EXPECT_TRUE(player.play().wires().laying()) << "there is always another one";
    player.click(player.at(minus));
    player.click(player.at(lamp));
    ASSERT_EQ(player.session().wires().size(), 2U);
    player.look("free-play-wired");
    player.key(SDLK_w);
    EXPECT_FALSE(player.play().wires().laying());
    EXPECT_TRUE(lit(player));
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_EQ(player.session().wires().size(), 1U);
    EXPECT_FALSE(lit(player));
}

TEST_F(FreePlay, DragsLayWiresScissorsTakeThemAndTheBuildIsKept) {
    placeBatteryAndLamp();
    player.clickItem("wire");
    ASSERT_TRUE(player.play().wires().laying()) << "by the button of the toolbox";
    player.drag(player.at(plus), player.at(lamp));
    player.drag(player.at(lamp), player.at(minus));
    ASSERT_EQ(player.session().wires().size(), 2U);
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.app().menu().isOpen());
    EXPECT_TRUE(lit(player));
    player.app().showTitle();
    player.frames(3);
    enter(player);
    EXPECT_EQ(player.session().placed().size(), 0U) << "without a profile nothing is kept";
}

TEST(FreePlayKept, ABuildWithWiresIsThereAgain) {
    auto const folder = testFolder() / "kept";
    std::filesystem::remove_all(folder);
    Player keeping({1280, 800}, folder / "profile.json");
    enter(keeping);
    ASSERT_TRUE(keeping.session().place({"battery", {-1, 0.15}, 0, ""}));
    ASSERT_TRUE(keeping.session().place({"lamp", lamp, 0, ""}));
    keeping.play().worldChanged();
    keeping.frames(3);
    keeping.key(SDLK_w);
    for (Vec2 const pole : {plus, minus}) {
        keeping.click(keeping.at(pole));
        keeping.click(keeping.at(lamp));
    }
    keeping.key(SDLK_ESCAPE);
    ASSERT_EQ(keeping.session().wires().size(), 2U);
    keeping.app().showTitle();
    keeping.frames(3);
    enter(keeping);
    EXPECT_EQ(keeping.session().wires().size(), 2U);
    EXPECT_TRUE(lit(keeping));
    keeping.key(SDLK_x);
    EXPECT_TRUE(keeping.play().wires().cutting());
}

TEST_F(FreePlay, ShowsNoCountsAndMoreTilesThanSix) {
    EXPECT_GE(tiles().size(), 9U);
    player.look("free-play-800");
    for (std::string const& line : DrawnWords().lines()) {
        EXPECT_EQ(line.find("1000"), std::string::npos) << line;
        EXPECT_EQ(line.find("2147483647"), std::string::npos) << line;
    }
}

TEST_F(FreePlay, IsSoughtByTheShownName) {
    seek("iron");
    auto const found = tiles();
    EXPECT_TRUE(std::count(found.begin(), found.end(), "iron ball") == 1);
    EXPECT_TRUE(std::count(found.begin(), found.end(), "wooden ball") == 0);
    player.look("free-play-search");
    type(" BALL");
    EXPECT_EQ(tiles(), std::vector<std::string>{"iron ball"});
    // Letters are no commands here.
    EXPECT_FALSE(player.play().wires().laying());
    type("w");
    EXPECT_FALSE(player.play().wires().laying());
    EXPECT_TRUE(tiles().empty());
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.app().menu().isOpen()) << "Esc leaves the field first";
    player.frames(2);
    EXPECT_GE(tiles().size(), 9U) << "and ends the search";
    player.key(SDLK_w);
    EXPECT_TRUE(player.play().wires().laying()) << "the keys are commands again";
}

TEST_F(FreePlay, IsSoughtInTheLanguageInUse) {
    changeSettings(player.app().context(), {.language = "de"});
    player.frames(3);
    seek("türk");
    EXPECT_EQ(tiles(), std::vector<std::string>{"doorbell"});
    player.look("free-play-search-german");
    player.key(SDLK_ESCAPE);
    seek("TÜRK");
    EXPECT_EQ(tiles(), std::vector<std::string>{"doorbell"});
}

TEST_F(FreePlay, EnterTakesTheFirstPartThatWasFound) {
    player.moveTo(player.at({0, 2}));
    player.key(SDLK_SLASH);
    player.frames(2);
    type("anvil");
    player.hold(SDLK_RETURN);
    player.frames(4);
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_EQ(player.play().placing().carried()->landing.part, "anvil");
    EXPECT_TRUE(player.session().placed().empty()) << "the same press does not put it down";
    player.letGo(SDLK_RETURN);
    player.key(SDLK_RETURN);
    player.frames(2);
    ASSERT_EQ(player.session().placed().size(), 1U);
    EXPECT_EQ(player.session().placed()[0].placement.part, "anvil");
}

TEST_F(FreePlay, GroupsAreChosenByMouseAndByKey) {
    player.clickItem("group electricity");
    player.frames(2);
    auto const shown = player.play().tools();
    ASSERT_FALSE(shown.empty());
    auto const has = [&](char const* part) {
        auto const now = player.play().tools();
        return std::any_of(now.begin(), now.end(),
                           [&](ToolboxSlot const& slot) { return slot.part == part; });
    };
    EXPECT_TRUE(has("lamp"));
    EXPECT_FALSE(has("wooden ball"));
    player.look("free-play-electricity");
    player.key(SDLK_s);
    EXPECT_TRUE(has("bar magnet"));
    EXPECT_FALSE(has("lamp"));
    player.key(SDLK_s, KMOD_LSHIFT);
    player.key(SDLK_s, KMOD_LSHIFT);
    EXPECT_EQ(player.play().tools().size(), gameData().parts.names().size())
        << "before the first one all parts";
    // All groups together have every part, and each step on shows another one.
    std::vector<std::string> seen;
    for (int i = 0; i < 12; ++i) {
        player.key(SDLK_s);
        for (ToolboxSlot const& slot : player.play().tools()) {
            seen.push_back(slot.part);
        }
        if (player.play().tools().size() == gameData().parts.names().size()) {
            break;
        }
    }
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    EXPECT_EQ(seen.size(), gameData().parts.names().size());
}

TEST_F(FreePlay, KeysTakeTheShownPartsOnly) {
    player.clickItem("group sound");
    player.frames(2);
    auto const shown = player.play().tools();
    for (ToolboxSlot const& slot : shown) {
        player.key(SDLK_t);
        ASSERT_TRUE(player.play().placing().carried());
        EXPECT_EQ(player.play().placing().carried()->landing.part, slot.part);
        player.frames(2);
        auto const seen = tiles();
        EXPECT_EQ(std::count(seen.begin(), seen.end(), slot.part), 1) << "its tile comes into sight";
    }
    player.key(SDLK_t);
    EXPECT_FALSE(player.play().placing().carried());
}

TEST_F(FreePlay, AGamepadSeeksWithTheKeyboardOnTheScreen) {
    player.key(render::padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT));
    CommandSet& commands = player.app().screen().commands();
    player.app().screen().runNext(commands.indexOf("find-part")); // as the page of all commands does
    player.frames(4);
    EXPECT_TRUE(player.app().context().letters.open());
    player.look("free-play-letters");
}

TEST_F(FreePlay, NothingIsRefusedWithoutAReason) {
    player.key(SDLK_v);
    EXPECT_EQ(told(), "Take a part first, or select one.");
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_EQ(told(), "There is nothing to undo.");
    auto const before = player.app().context().toasts.count();
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_EQ(player.app().context().toasts.count(), before) << "once";
}

struct Room {
    render::Size size;
    float letters;
    std::size_t rows; ///< of tiles that are at least wholly in sight
};

TEST(FreePlayTiles, AreInSightInSeveralRowsWhateverTheWindowAndTheLetters) {
    for (Room const& room : {Room{{800, 600}, 1, 3}, Room{{800, 600}, 1.6F, 3}, Room{{1280, 720}, 1, 3},
                             Room{{1280, 720}, 1.6F, 2}, Room{{1280, 800}, 1, 3}, Room{{1280, 800}, 1.6F, 2},
                             Room{{1920, 1080}, 1.6F, 2}}) {
        for (char const* const language : {"en", "de"}) {
            Player player(room.size);
            changeSettings(player.app().context(), {.uiScale = room.letters, .language = language});
            player.frames(4); // the title screen is laid out anew
            enter(player);
            std::string const where = std::to_string(room.size.width) + "x" +
                                      std::to_string(room.size.height) + " at " +
                                      std::to_string(room.letters) + " in " + language;
            std::set<double> rows;
            std::set<double> columns;
            for (Placed const& tile : wholeTiles(player)) {
                rows.insert(std::round(tile.rect.low.y));
                columns.insert(std::round(tile.rect.low.x));
                EXPECT_GE(tile.rect.high.x - tile.rect.low.x, 60 * window().uiScale()) << where;
            }
            EXPECT_GE(rows.size(), room.rows) << where;
            EXPECT_GE(columns.size(), 2U) << where;
            expectTidy(player, where);
            player.look("free-play-tiles-" + std::to_string(room.size.width) + "-" +
                        std::to_string(static_cast<int>(100 * room.letters)) + language);
        }
    }
    window().setUiScaleRequest(1.F);
    useLanguage("en");
}

class SmallFreePlay : public FreePlay {
protected:
    SmallFreePlay() : FreePlay({800, 600}) {}
};

TEST_F(SmallFreePlay, HasRoomForTiles) {
    EXPECT_GE(tiles().size(), 6U);
    player.look("free-play-600");
    changeSettings(player.app().context(), {.language = "de"});
    player.frames(6);
    player.look("free-play-600-german");
}

// One button stands for the groups; it shows them in place of the tiles.
TEST_F(SmallFreePlay, OffersItsGroupsAsAList) {
    EXPECT_FALSE(player.shows("group electricity"));
    player.clickItem("groups");
    player.frames(2);
    EXPECT_TRUE(tiles().empty());
    EXPECT_TRUE(player.shows("group all"));
    player.look("free-play-600-groups");
    player.clickItem("groups");
    player.frames(2);
    EXPECT_FALSE(tiles().empty()) << "pressed again it shows the tiles";
    player.clickItem("groups");
    player.frames(2);
    player.clickItem("group electricity");
    player.frames(2);
    auto const shown = player.play().tools();
    EXPECT_LT(shown.size(), player.session().toolbox().size());
    EXPECT_TRUE(
        std::any_of(shown.begin(), shown.end(), [](ToolboxSlot const& slot) { return slot.part == "lamp"; }));
    EXPECT_FALSE(tiles().empty());
    player.clickItem("groups");
    player.frames(2);
    player.key(SDLK_s);
    player.frames(2);
    EXPECT_FALSE(tiles().empty()) << "the next group by its key";
    player.clickItem("groups");
    player.frames(2);
    seek("lamp");
    auto const found = tiles();
    EXPECT_EQ(std::count(found.begin(), found.end(), "lamp"), 1) << "and what is sought";
}

} // namespace
} // namespace toolbox_card_test
} // namespace trembler::ui::test

// Viewing the past of a run, and continuing from any moment of it, with real input events.
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/timeline/timeline.hpp"
#include "insight/probe/watch_table.hpp"
#include "insight/run/level_runs.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/player.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace trembler::ui::test {
namespace timeline_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";
auto const doorbell = levelsFolder() / "experiments/2-doorbell.json";

/// Runs the level, won by a steel bar; returns the hash of the world after each frame.
std::map<std::uint64_t, std::uint64_t> runFirstContact(Player& player, std::uint64_t frames) {
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    std::map<std::uint64_t, std::uint64_t> hashes;
    for (std::uint64_t i = 0; i < frames; ++i) {
        player.key(SDLK_f);
        hashes[player.session().world().frame()] = player.session().world().stateHash();
    }
    return hashes;
}

TEST(Timeline, ShowsAnyMomentAndComesBackToThePresent) {
    Player player;
    auto const hashes = runFirstContact(player, 90);
    Timeline& timeline = player.play().timeline();
    EXPECT_FALSE(player.showsCard("timeline"));
    player.key(SDLK_k);
    player.frames(2);
    ASSERT_TRUE(player.showsCard("timeline"));
    EXPECT_FALSE(timeline.looksBack());
    player.key(SDLK_PAGEUP);
    EXPECT_EQ(timeline.frame(), 89U);
    player.key(SDLK_LEFT);
    EXPECT_EQ(timeline.frame(), 88U);
    player.key(SDLK_PAGEUP, KMOD_LSHIFT);
    EXPECT_EQ(timeline.frame(), 78U);
    player.key(SDLK_HOME, KMOD_LCTRL);
    EXPECT_EQ(timeline.frame(), 0U);
    player.key(SDLK_RIGHT);
    EXPECT_EQ(timeline.frame(), 1U);
    EXPECT_EQ(player.session().world().frame(), 90U) << "the session stands still";
    EXPECT_EQ(player.session().world().stateHash(), hashes.at(90));
    player.key(SDLK_END);
    EXPECT_FALSE(timeline.looksBack());
    EXPECT_EQ(timeline.frame(), 90U);
    EXPECT_EQ(&timeline.world(), &player.session().world());
}

TEST(Timeline, IsDraggedAlongWithTheMouse) {
    Player player;
    runFirstContact(player, 90);
    player.key(SDLK_k);
    player.frames(2);
    Timeline& timeline = player.play().timeline();
    auto const track = player.layout().item("timeline track");
    ASSERT_TRUE(track);
    player.moveTo({track->low.x + 2, track->middle().y + 6});
    player.press();
    player.frames(2);
    EXPECT_EQ(timeline.frame(), 0U);
    player.moveTo({track->middle().x, track->middle().y + 6});
    player.frames(2);
    EXPECT_NEAR(static_cast<double>(timeline.frame()), 45, 2);
    player.release();
    player.moveTo({track->middle().x, track->low.y - 60});
    player.frames(2);
    EXPECT_NEAR(static_cast<double>(timeline.frame()), 45, 2);
    player.look("timeline-drag");
}

// A run that continues from a moment of the past is, to the bit, the earlier run.
TEST(Timeline, GoesOnFromAnyMomentDeterministically) {
    for (std::uint64_t const from : {60U, 1U, 0U}) {
        Player player;
        auto const hashes = runFirstContact(player, 90);
        Timeline& timeline = player.play().timeline();
        player.key(SDLK_k);
        timeline.seek(from);
        ASSERT_EQ(timeline.frame(), from);
        player.key(SDLK_u);
        player.frames(4);
        EXPECT_FALSE(timeline.looksBack());
        EXPECT_FALSE(player.session().playing());
        player.key(SDLK_p); // it has been running since
        std::uint64_t const frame = player.session().world().frame();
        ASSERT_GE(frame, from);
        ASSERT_LT(frame, from + 20);
        EXPECT_EQ(timeline.last(), frame);
        while (player.session().world().frame() < 90) {
            player.key(SDLK_f);
            std::uint64_t const now = player.session().world().frame();
            ASSERT_EQ(player.session().world().stateHash(), hashes.at(now)) << now;
        }
        timeline.seek(30); // earlier frames have not been lost
        EXPECT_EQ(timeline.frame(), 30U);
    }
}

TEST(Timeline, PlaysWhatWasRecordedAndRepeatsASection) {
    Player player;
    runFirstContact(player, 60);
    Timeline& timeline = player.play().timeline();
    player.key(SDLK_k);
    player.key(SDLK_o);
    player.frames(10);
    EXPECT_TRUE(timeline.playing());
    EXPECT_NEAR(static_cast<double>(timeline.frame()), 10, 3);
    player.frames(70);
    EXPECT_FALSE(timeline.playing()) << "it has come to its end";
    EXPECT_EQ(player.session().world().frame(), 60U);
    timeline.seek(20);
    player.key(SDLK_j);
    timeline.seek(30);
    player.key(SDLK_j);
    ASSERT_TRUE(timeline.loop());
    EXPECT_EQ(timeline.loop()->first, 20U);
    EXPECT_EQ(timeline.loop()->second, 30U);
    player.key(SDLK_o);
    for (int i = 0; i < 60; ++i) {
        player.frame();
        EXPECT_TRUE(timeline.playing());
        EXPECT_GE(timeline.frame(), 20U);
        EXPECT_LE(timeline.frame(), 30U);
    }
    player.key(SDLK_j);
    EXPECT_FALSE(timeline.loop());
}

// A recorded run has a frame each sixtieth of a second, at a quarter of the speed each fifteenth.
TEST(Timeline, PlaysAsSlowlyAsItIsAsked) {
    Player player;
    runFirstContact(player, 60);
    Timeline& timeline = player.play().timeline();
    for (double const speed : {1.0, 0.25, 0.1}) {
        timeline.seek(0);
        timeline.playOrPause();
        ASSERT_TRUE(timeline.playing());
        for (int i = 0; i < 40; ++i) {
            timeline.pass(1.0 / 60, speed);
        }
        EXPECT_NEAR(static_cast<double>(timeline.frame()), 40 * speed, 1) << speed;
        timeline.playOrPause();
    }
    // The speed is that of the run's buttons.
    timeline.seek(0);
    player.key(SDLK_k);
    player.clickItem("slower");
    player.clickItem("slower");
    double const speed = player.play().speed().now();
    ASSERT_LT(speed, 1);
    player.key(SDLK_o);
    std::uint64_t const first = timeline.frame();
    player.frames(40);
    EXPECT_NEAR(static_cast<double>(timeline.frame() - first), 40 * speed, 2);
}

TEST(Timeline, ForgetsARunThatHasEnded) {
    Player player;
    runFirstContact(player, 30);
    Timeline& timeline = player.play().timeline();
    player.key(SDLK_k);
    timeline.seek(10);
    player.key(SDLK_SPACE); // stop
    EXPECT_FALSE(timeline.looksBack());
    player.frames(2);
    EXPECT_FALSE(player.showsCard("timeline"));
    EXPECT_EQ(timeline.last(), 0U);
    player.key(SDLK_SPACE);
    player.simulate(20);
    EXPECT_GE(timeline.last(), 20U);
}

TEST(Timeline, MarksWhatSwitchesAndLeadsThere) {
    Player player;
    runFirstContact(player, 200);
    Timeline& timeline = player.play().timeline();
    bool on = false;
    bool goal = false;
    for (insight::Mark const& mark : timeline.marks().all()) {
        on = on || mark.kind == insight::MarkKind::on;
        goal = goal || mark.kind == insight::MarkKind::goal;
    }
    EXPECT_TRUE(on);
    EXPECT_EQ(goal, player.session().solved());
    timeline.seek(0);
    player.key(SDLK_PAGEDOWN, KMOD_LCTRL);
    EXPECT_EQ(timeline.frame(), timeline.marks().all().front().frame);
}

// The same picture from the recording as from the world itself.
TEST(Timeline, LooksAsItDid) {
    Player player;
    player.open(doorbell);
    player.key(SDLK_k);
    for (int i = 0; i < 80; ++i) {
        player.key(SDLK_f);
    }
    player.frames(240); // rings and sparks have disappeared
    player.look("timeline-present");
    for (int i = 0; i < 3; ++i) {
        player.key(SDLK_f);
    }
    player.play().timeline().seek(80);
    player.frames(3);
    player.look("timeline-past");
}

TEST(Probes, AreChosenPlottedAndWritten) {
    for (render::Size const size : {render::Size{800, 600}, render::Size{1280, 720}}) {
        Player player(size);
        runFirstContact(player, 90);
        player.key(SDLK_F4);
        player.frames(2);
        ASSERT_TRUE(player.showsCard("probe choice"));
        EXPECT_FALSE(player.showsCard("probes"));
        ObjectId const ball = player.session().world().store().find("iron ball");
        player.click(player.at(player.session().world().find<Position>(ball)->value));
        player.frames(3);
        ASSERT_TRUE(player.shows("plot iron ball.velocity.length"));
        player.clickItem("plot iron ball.velocity.length");
        player.frames(2);
        player.clickItem("plot iron ball.position.y");
        player.frames(6);
        ASSERT_TRUE(player.showsCard("probes"));
        Timeline& timeline = player.play().timeline();
        auto const& series = timeline.probes().probes().series();
        ASSERT_EQ(series.size(), 2U);
        ASSERT_EQ(series[1].samples.size(), 91U) << "the whole run, although it was asked for later";
        EXPECT_EQ(series[1].at(90), player.session().world().find<Position>(ball)->value.y);
        std::string const pixels = std::to_string(size.width);
        player.look("probe-choice-" + pixels);
        player.clickItem("save csv");
        player.clickItem("save svg");
        EXPECT_TRUE(std::filesystem::exists(player.films() / "plot-1.csv"));
        EXPECT_TRUE(std::filesystem::exists(player.films() / "plot-1.svg"));
        player.key(SDLK_F4);
        timeline.seek(40);
        player.frames(3);
        player.look("probes-" + pixels);
        player.clickItem("plots"); // the middle of the plots is about the middle of the run
        EXPECT_NE(timeline.frame(), 40U);
        std::filesystem::remove_all(player.films());
    }
}

/// What `trembler run --watch ... --csv` writes for the first frames of a recorded run.
std::string tableOf(Solution const& recorded, std::vector<std::string> const& what, std::uint64_t frames) {
    insight::LevelRuns const runs(gameData(), loadLevel(gameData().registry, firstContact));
    std::ostringstream out;
    std::unique_ptr<watch::WatchTable> table;
    insight::RunObserver observer;
    observer.begin = [&](LevelRun const& run) {
        table = std::make_unique<watch::WatchTable>(gameData().registry, run.world(), what, 1, out);
        table->look(run.world());
    };
    observer.frame = [&](LevelRun const& run) {
        table->look(run.world());
        return true;
    };
    observer.end = [&](LevelRun const&) { table.reset(); };
    EXPECT_FALSE(runs.run({recorded, {}}, {.frames = frames, .stopWhenSolved = false}, observer).fault);
    return out.str();
}

// Whole vectors, a number of the world, a length of a list, an element of one, and a device that has no value
// in the first frame.
TEST(Probes, AreWrittenAsTheTableOfTheCommandLine) {
    Player player;
    runFirstContact(player, 90);
    player.key(SDLK_F4);
    std::vector<std::string> const what{"electromagnet.electrical_state.on", "iron ball.position",
                                        "world.gravity.y", "world.contacts.current.count",
                                        "steel bar 1.shape.0.width"};
    for (std::string const& each : what) {
        player.play().timeline().probes().toggle(each);
    }
    player.frames(6);
    player.clickItem("save csv");
    std::ifstream in(player.films() / "plot-1.csv", std::ios::binary);
    std::stringstream written;
    written << in.rdbuf();
    EXPECT_EQ(written.str(), tableOf(player.session().record("it"), what, 90));
    std::filesystem::remove_all(player.films());
}

TEST(Probes, AreFoundByTheirNames) {
    Player player;
    runFirstContact(player, 30);
    player.key(SDLK_F4);
    player.frames(2);
    player.clickItem("find a number");
    render::pushText(window(), "current.count");
    player.frames(3);
    player.look("probe-found");
    ASSERT_TRUE(player.shows("plot world.contacts.current.count")) << "although no object is selected";
    player.clickItem("plot world.contacts.current.count");
    player.frames(3);
    auto const& series = player.play().timeline().probes().probes().series();
    ASSERT_EQ(series.size(), 1U);
    EXPECT_EQ(series[0].samples.size(), 31U);
    EXPECT_GT(series[0].samples.back().value, 0) << "the bar lies on the contacts";
    player.clickItem("find a number");
    player.key(SDLK_a, KMOD_LCTRL);
    render::pushText(window(), "world.gravty");
    player.frames(3);
    EXPECT_FALSE(player.shows("plot world.gravity"));
    player.look("probe-similar");
    player.clickItem("similar world.gravity");
    player.frames(3);
    EXPECT_TRUE(player.shows("plot world.gravity"));
}

// Beside the plot, the value in the frame to which the cursor is set.
TEST(Probes, TheCursorReadsThemOut) {
    Player player;
    runFirstContact(player, 90);
    player.key(SDLK_k);
    Timeline& timeline = player.play().timeline();
    timeline.probes().toggle("iron ball.position.y");
    player.frames(6);
    ObjectId const ball = player.session().world().store().find("iron ball");
    std::string earlier;
    for (std::uint64_t const frame : {20U, 90U}) {
        timeline.seek(frame);
        player.frames(3);
        (void)player.look("probe-cursor"); // draws the words
        double const height = timeline.world().find<Position>(ball)->value.y;
        std::string const shown = fmt::format("{:.3f} iron ball: Height", height);
        std::vector<std::string> const lines = DrawnWords().lines();
        EXPECT_TRUE(
            std::any_of(lines.begin(), lines.end(),
                        [&](std::string const& line) { return line.find(shown) != std::string::npos; }))
            << shown << "\n"
            << fmt::format("{}", fmt::join(lines, "\n"));
        EXPECT_NE(shown, earlier) << "the ball moves";
        earlier = shown;
    }
}

} // namespace
} // namespace timeline_test
} // namespace trembler::ui::test

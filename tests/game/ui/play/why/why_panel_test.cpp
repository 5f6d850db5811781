// A newcomer asks why, by mouse, keyboard and gamepad, and gets the answer of insight/why.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/cards/level_text.hpp"
#include "game/ui/play/why/why_panel.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/tidy.hpp"
#include "tests/game/ui/virtual_pad.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace trembler::ui::test {
namespace why_panel_test {
namespace {

auto const firstLevel = levelsFolder() / "first/1-first-contact.json";
auto const magnet = levelsFolder() / "experiments/1-switched-electromagnet.json";

/// A bar over the gap: solved.
void solve(Player& player) {
    player.open(firstLevel);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    player.simulate(400);
    ASSERT_TRUE(player.session().solved());
    player.frames(60);
}

/// Nothing over the gap.
void fail(Player& player) {
    player.open(firstLevel);
    player.key(SDLK_SPACE);
    player.simulate(60);
    player.key(SDLK_p);
    player.frames(2);
}

void waitForAnswer(Player& player) {
    player.play().why().wait();
    player.frames(3);
}

/// The answer of insight/why about the run.
insight::Answer answerTo(Player& player, insight::Question const& question) {
    insight::LevelRuns const runs(gameData(), player.session().level());
    insight::AskOptions options;
    options.frames = player.session().world().frame();
    return why(runs, player.session().record(""), question, options);
}

insight::Question aboutGoal(Player& player, std::size_t goal) {
    insight::Question question;
    question.goal = player.session().judge().status()[goal].id;
    return question;
}

void expectSame(insight::Answer const& shown, insight::Answer const& expected) {
    ASSERT_EQ(shown.happened, expected.happened);
    ASSERT_EQ(shown.chain.size(), expected.chain.size());
    for (std::size_t i = 0; i < shown.chain.size(); ++i) {
        EXPECT_EQ(shown.chain[i].step.what, expected.chain[i].step.what);
        EXPECT_EQ(shown.chain[i].step.objects, expected.chain[i].step.objects);
        EXPECT_EQ(shown.chain[i].step.frame, expected.chain[i].step.frame);
        EXPECT_EQ(shown.chain[i].step.because, expected.chain[i].step.because);
        EXPECT_EQ(shown.chain[i].proof, expected.chain[i].proof);
    }
    ASSERT_EQ(shown.nearest.has_value(), expected.nearest.has_value());
    if (shown.nearest) {
        EXPECT_EQ(shown.nearest->nearest.frame, expected.nearest->nearest.frame);
        EXPECT_EQ(shown.nearest->nearest.by, expected.nearest->nearest.by);
    }
}

TEST(WhyPanel, SaysWhyAGoalIsMetAndShowsEachStep) {
    Player player;
    solve(player);
    EXPECT_FALSE(player.showsCard("why"));
    ASSERT_TRUE(player.shows("why goal 1"));
    player.clickItem("why goal 1");
    waitForAnswer(player);
    ASSERT_TRUE(player.showsCard("why"));
    expectTidy(player, "an answer");
    insight::Answer const* const answer = player.play().why().answer();
    ASSERT_NE(answer, nullptr);
    EXPECT_TRUE(answer->confirmed);
    expectSame(*answer, answerTo(player, aboutGoal(player, 0)));
    player.look("why-answer");
    // The bar was laid there; a click shows its contact.
    std::vector<std::string> const lines = player.play().why().lines();
    ASSERT_EQ(lines.size(), answer->chain.size());
    EXPECT_EQ(lines.front(), "You laid steel bar 1 there before the start.");
    std::size_t contact = 0;
    while (answer->chain[contact].step.kind != insight::StepKind::contact) {
        ++contact;
        ASSERT_LT(contact, lines.size());
    }
    std::uint64_t const moment = answer->chain[contact].step.frame;
    player.clickItem("why step " + std::to_string(contact + 1));
    EXPECT_TRUE(player.play().timeline().looksBack());
    EXPECT_EQ(player.play().timeline().frame(), moment);
    EXPECT_EQ(player.play().why().step(), contact);
    player.look("why-step");
    player.clickItem("close why");
    player.frames(2);
    EXPECT_FALSE(player.showsCard("why"));
}

TEST(WhyPanel, SaysHowNearlyAGoalWasMet) {
    Player player;
    fail(player);
    player.clickItem("why goal 1");
    waitForAnswer(player);
    expectTidy(player, "a miss");
    insight::Answer const* const answer = player.play().why().answer();
    ASSERT_NE(answer, nullptr);
    EXPECT_FALSE(answer->happened);
    expectSame(*answer, answerTo(player, aboutGoal(player, 0)));
    ASSERT_TRUE(answer->nearest);
    EXPECT_EQ(answer->nearest->nearest.lack, insight::Lack::gap);
    std::vector<std::string> const lines = player.play().why().lines();
    ASSERT_GE(lines.size(), 2U);
    EXPECT_NE(lines[1].find("between the left contact and the right contact"), std::string::npos) << lines[1];
    player.look("why-not");
    player.clickItem("why step 2");
    EXPECT_EQ(player.play().timeline().frame(), answer->nearest->nearest.frame);
}

// The longest answer: the cause that ended a goal that held for a moment, and the effects of the water and
// the load. The goal requires four boxes, which the raft bears until the load turns it.
TEST(WhyPanel, SaysWhatEndedAGoalThatHeldTooShortly) {
    std::ifstream stored(levelsFolder() / "experiments/4-raft.json");
    std::string text{std::istreambuf_iterator<char>(stored), {}};
    std::string const asked = R"("part": "cargo box"}, "at_least": 5)";
    auto const place = text.find(asked);
    ASSERT_NE(place, std::string::npos);
    text.replace(place, asked.size(), R"("part": "cargo box"}, "at_least": 4)");
    std::filesystem::path const file = std::filesystem::path(testing::TempDir()) / "raft-of-four-boxes.json";
    std::ofstream(file) << text;
    Player player;
    player.open(file);
    Session& session = player.session();
    session.load(*session.level().findSolution("load the left end"));
    player.frames(2);
    player.key(SDLK_SPACE);
    player.simulate(300);
    player.key(SDLK_p);
    player.frames(2);
    player.clickItem("why goal 1");
    waitForAnswer(player);
    expectTidy(player, "what ended it");
    std::string all;
    for (std::string const& line : player.play().why().lines()) {
        all += line + " ";
    }
    EXPECT_NE(all.find("would have lifted the raft body there with"), std::string::npos) << all;
    EXPECT_NE(all.find("The load turned the raft body"), std::string::npos) << all;
    player.look("why-not-raft");
}

TEST(WhyPanel, IsAskedByKeys) {
    Player player;
    solve(player);
    player.moveTo({2, 2});
    player.key(SDLK_y, KMOD_LSHIFT);
    waitForAnswer(player);
    insight::Answer const* const answer = player.play().why().answer();
    ASSERT_NE(answer, nullptr);
    ASSERT_TRUE(answer->happened);
    for (std::size_t step = 0; step < answer->chain.size(); ++step) {
        player.key(SDLK_d);
        EXPECT_EQ(player.play().why().step(), step);
        EXPECT_EQ(player.play().timeline().frame(), answer->chain[step].step.frame);
    }
    player.key(SDLK_a);
    EXPECT_EQ(player.play().why().step(), answer->chain.size() - 2);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("why"));
    EXPECT_FALSE(player.app().menu().isOpen());
}

TEST(WhyPanel, SaysWhyAnObjectIsAsItIs) {
    Player player;
    player.open(magnet);
    player.key(SDLK_SPACE);
    player.simulate(64);
    player.key(SDLK_p);
    World const& world = player.session().world();
    player.moveTo(player.at(world.find<Position>(world.store().find("electromagnet"))->value));
    player.frames(2);
    player.key(SDLK_y);
    waitForAnswer(player);
    insight::Answer const* const answer = player.play().why().answer();
    ASSERT_NE(answer, nullptr);
    insight::Question question;
    question.object = "electromagnet";
    question.at = static_cast<double>(world.frame()) * frameDuration;
    expectSame(*answer, answerTo(player, question));
    EXPECT_TRUE(answer->happened);
}

TEST(WhyPanel, SaysThatNothingHasHappened) {
    Player player;
    fail(player);
    World const& world = player.session().world();
    player.moveTo(player.at(world.find<Position>(world.store().find("electromagnet"))->value));
    player.frames(2);
    player.key(SDLK_y);
    waitForAnswer(player);
    EXPECT_TRUE(player.play().why().open());
    EXPECT_TRUE(player.play().why().nothing());
    EXPECT_EQ(player.play().why().answer(), nullptr);
    expectTidy(player, "nothing");
    player.look("why-nothing");
}

TEST(WhyPanel, IsAskedByGamepad) {
    Player player;
    solve(player);
    VirtualPad const pad;
    ASSERT_TRUE(pad.works());
    player.frames(2);
    pad.press(player, SDL_CONTROLLER_BUTTON_BACK);
    waitForAnswer(player);
    insight::Answer const* const answer = player.play().why().answer();
    ASSERT_NE(answer, nullptr);
    EXPECT_TRUE(answer->happened);
    pad.press(player, SDL_CONTROLLER_BUTTON_RIGHTSTICK);
    EXPECT_EQ(player.play().why().step(), 0U);
    pad.press(player, SDL_CONTROLLER_BUTTON_B);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("why"));
}

TEST(WhyPanel, AnswersAboutAMarkOfTheTimeline) {
    Player player;
    player.open(magnet);
    player.key(SDLK_SPACE);
    player.simulate(64);
    player.key(SDLK_p);
    player.key(SDLK_k);
    player.frames(3);
    auto const& marks = player.play().timeline().marks().all();
    auto const on = std::find_if(marks.begin(), marks.end(), [](insight::Mark const& mark) {
        return mark.kind == insight::MarkKind::on;
    });
    ASSERT_NE(on, marks.end());
    insight::Mark const mark = *on;
    auto const track = player.layout().item("timeline track");
    ASSERT_TRUE(track);
    double const scale = static_cast<double>(window().uiScale());
    double const left = track->low.x + 11.5 * scale; // as timeline_bar.cpp places it
    double const right = track->high.x - 11.5 * scale;
    double const share =
        static_cast<double>(mark.frame) / static_cast<double>(player.play().timeline().last());
    player.click({left + share * (right - left), track->low.y + 0.3 * (track->high.y - track->low.y)});
    ASSERT_TRUE(player.play().why().open());
    waitForAnswer(player);
    insight::Answer const* const answer = player.play().why().answer();
    ASSERT_NE(answer, nullptr);
    EXPECT_TRUE(answer->happened);
    EXPECT_EQ(answer->chain.back().step.frame, mark.frame);
    player.look("why-mark");
}

struct MarkedRun {
    char const* level;
    char const* solution;
    int frames;
    std::vector<insight::MarkKind> kinds;
};

void expectAnswer(Player& player, insight::MarkKind kind) {
    auto const& marks = player.play().timeline().marks().all();
    auto const at = std::find_if(marks.begin(), marks.end(),
                                 [kind](insight::Mark const& mark) { return mark.kind == kind; });
    ASSERT_NE(at, marks.end());
    insight::Mark const mark = *at;
    LevelText const said(player.session());
    WhyPanel panel(gameData().registry, gameData().parts, nullptr, player.session(), said);
    panel.askMark(mark); // not by mouse: marks of other kinds may lie over it
    panel.wait();
    panel.pass();
    insight::Answer const* const answer = panel.answer();
    ASSERT_NE(answer, nullptr);
    EXPECT_TRUE(answer->happened);
    ASSERT_FALSE(answer->chain.empty());
    EXPECT_FALSE(panel.lines().empty());
    insight::Step const& asked = answer->chain.back().step;
    EXPECT_LE(asked.frame, mark.frame);
    EXPECT_EQ(asked.kind == insight::StepKind::goal, kind == insight::MarkKind::goal);
    EXPECT_EQ(answer->goal, mark.goal);
    for (std::string const& object : mark.objects) {
        EXPECT_NE(std::find(asked.objects.begin(), asked.objects.end(), object), asked.objects.end())
            << object;
    }
}

// A question at a mark of each kind; at the mark of a goal it is about the goal.
TEST(WhyPanel, AnswersAboutEachKindOfMark) {
    using insight::MarkKind;
    std::vector<MarkedRun> const runs{
        {"experiments/2-doorbell.json",
         "hands off",
         300,
         {MarkKind::contact, MarkKind::parted, MarkKind::on, MarkKind::off, MarkKind::magnetOn,
          MarkKind::magnetOff, MarkKind::sound}},
        {"4-water/6-drop-the-ballast.json",
         "two floats under one end",
         400,
         {MarkKind::dips, MarkKind::leaves, MarkKind::hit}},
        {"experiments/1-switched-electromagnet.json", "cut the wire", 200, {MarkKind::cut}},
        {"2-electricity/4-one-load-too-many.json", "rubber carries no current", 260, {MarkKind::broken}},
        {"first/1-first-contact.json", "the steel bar", 60, {MarkKind::goal}},
    };
    for (MarkedRun const& run : runs) {
        Player player;
        player.open(levelsFolder() / run.level);
        Solution const* const solution = player.session().level().findSolution(run.solution);
        ASSERT_NE(solution, nullptr) << run.solution;
        player.session().load(*solution);
        player.key(SDLK_SPACE);
        player.simulate(run.frames);
        player.key(SDLK_p);
        player.frames(2);
        for (MarkKind const kind : run.kinds) {
            SCOPED_TRACE(std::string(run.level) + ", kind " + std::to_string(static_cast<int>(kind)));
            expectAnswer(player, kind);
        }
    }
}

// The load is too heavy for its rope.
TEST(WhyPanel, AnswersAboutAJointThatGaveWay) {
    std::filesystem::path const file = std::filesystem::path(testing::TempDir()) / "thin-rope.json";
    std::ofstream(file) << R"({"version": 2, "title": "Thin rope", "text": "",
        "world": {"gravity": [0, -9.81], "bounds": [-2, 0, 4, 3]},
        "objects": [
            {"name": "beam", "at": [0, 2.5], "properties": {"fixed": true,
                "shape": [{"form": "box", "width": 1, "height": 0.1}]}},
            {"name": "load", "at": [0, 1.5], "properties": {"mass": 50,
                "shape": [{"form": "box", "width": 0.4, "height": 0.4}]}}],
        "joints": [{"name": "thin rope", "form": "distance", "a": "load", "b": "beam", "at": [0, 1.7],
            "at_b": [0, 2.45], "break_force": 20}],
        "goals": {"inside": {"object": "load", "area": [-2, 0, 4, 1]}, "id": "down", "text": "Let it fall"}})";
    Player player;
    player.open(file);
    player.key(SDLK_SPACE);
    player.simulate(40);
    player.key(SDLK_p);
    player.frames(2);
    expectAnswer(player, insight::MarkKind::broken);
}

void runFor(Player& player, int frames) {
    player.key(SDLK_SPACE);
    player.simulate(frames);
    player.key(SDLK_p);
    player.frames(2);
}

/// The steps of the answer about a goal that are known so well, and whether the card says it of each.
void expectShown(Player& player, std::size_t goal, insight::Proof proof, std::string const& mark,
                 std::string const& meaning) {
    player.clickItem("why goal " + std::to_string(goal + 1));
    waitForAnswer(player);
    insight::Answer const* const answer = player.play().why().answer();
    ASSERT_NE(answer, nullptr);
    auto const steps = std::count_if(answer->chain.begin(), answer->chain.end(),
                                     [&](insight::ChainStep const& one) { return one.proof == proof; });
    ASSERT_GT(steps, 0);
    (void)player.look("why-" + mark);
    std::string all;
    for (std::string const& line : DrawnWords().lines()) {
        all += line + " ";
    }
    long shown = 0;
    for (std::size_t at = all.find("· " + mark); at != std::string::npos;
         at = all.find("· " + mark, at + 1)) {
        ++shown;
    }
    EXPECT_EQ(shown, steps) << all;
    EXPECT_NE(all.find(meaning), std::string::npos) << all;
}

// What was found by tracing, and what by runs without it, one by one or several together.
TEST(WhyPanel, ShowsHowWellEachStepIsKnown) {
    {
        Player player;
        solve(player);
        expectShown(player, 0, insight::Proof::confirmed, "sure", "Sure: ");
    }
    {
        Player player;
        player.open(firstLevel);
        Solution solution = *player.session().level().findSolution("the steel bar");
        solution.placements.push_back(
            player.session().level().findSolution("the spanner")->placements.front());
        solution.placements.back().at.y += 0.5; // either of the two would do
        player.session().load(solution);
        runFor(player, 60);
        expectShown(player, 0, insight::Proof::together, "together", "Together: ");
    }
    // A lamp that is lit from the start by wires alone, which no run is without.
    Player player;
    player.open(levelsFolder() / "2-electricity/2-the-easy-way.json");
    player.session().load(*player.session().level().findSolution("metal from above"));
    runFor(player, 400);
    expectShown(player, 1, insight::Proof::traced, "seen", "Seen: ");
}

TEST(WhyPanel, TheLastRunCanBeAskedAboutWhileBuilding) {
    Player player;
    player.open(firstLevel);
    player.frames(2);
    EXPECT_FALSE(player.shows("why goal 1"));
    player.key(SDLK_SPACE);
    player.simulate(60);
    player.key(SDLK_SPACE);
    player.frames(2);
    ASSERT_EQ(player.session().mode(), SessionMode::building);
    player.clickItem("why goal 1");
    waitForAnswer(player);
    ASSERT_NE(player.play().why().answer(), nullptr);
    EXPECT_FALSE(player.play().why().answer()->happened);
    expectTidy(player, "while building");
    player.key(SDLK_SPACE); // another run: the answer was not about it
    player.simulate(16);
    EXPECT_FALSE(player.play().why().open());
}

TEST(WhyPanel, TheWorldGoesOnMeanwhileAndTheQuestionCanBeStopped) {
    Player player;
    fail(player);
    player.key(SDLK_p);
    std::uint64_t const before = player.session().world().frame();
    player.key(SDLK_y, KMOD_LSHIFT);
    EXPECT_TRUE(player.play().why().open());
    player.frames(5);
    EXPECT_GT(player.session().world().frame(), before);
    player.clickItem("close why");
    waitForAnswer(player);
    EXPECT_FALSE(player.play().why().busy());
}

TEST(WhyPanel, SpeaksGerman) {
    Player player;
    changeSettings(player.app().context(), {.reducedMotion = true, .language = "de"});
    solve(player);
    player.clickItem("why goal 1");
    waitForAnswer(player);
    std::vector<std::string> const lines = player.play().why().lines();
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.front().find("Du hast "), 0U) << lines.front();
    EXPECT_NE(lines.front().find("vor dem Start dorthin gelegt."), std::string::npos);
    expectTidy(player, "German");
    player.look("why-german");
}

// Of both sides the card takes the one at which it hides less of what it is about.
TEST(WhyPanel, LeavesWhatItExplainsInSight) {
    for (render::Size const size : {render::Size{640, 480}, render::Size{800, 600}, render::Size{1024, 768},
                                    render::Size{1280, 720}, render::Size{1280, 800}}) {
        Player player(size);
        fail(player);
        player.key(SDLK_SPACE); // build again
        player.frames(30);
        ASSERT_EQ(player.session().mode(), SessionMode::building);
        player.key(SDLK_y, KMOD_LSHIFT);
        waitForAnswer(player);
        player.frames(8); // until the card has its height
        std::string const where = std::to_string(size.width) + " x " + std::to_string(size.height);
        auto const card = player.layout().card("why");
        ASSERT_TRUE(card) << where;
        World const& world = player.session().world();
        for (char const* const name : {"left contact", "right contact"}) { // between them is the gap
            ObjectId const object = world.store().find(name);
            ASSERT_TRUE(object.valid()) << name;
            Point const at = player.at(world.find<Position>(object)->value);
            EXPECT_FALSE(card->contains(at)) << name << ", " << where;
        }
        if (size.width >= 1280) { // there is room for all of it
            ObjectId const magnet = world.store().find("electromagnet");
            EXPECT_FALSE(card->contains(player.at(world.find<Position>(magnet)->value))) << where;
        }
        auto const box = player.layout().card("toolbox");
        ASSERT_TRUE(box) << where;
        EXPECT_FALSE(box->overlaps(*card)) << where;
        expectTidy(player, "why, to build at " + where);
        player.look("why-not-building-" + std::to_string(size.width) + "x" + std::to_string(size.height));
    }
}

TEST(WhyPanel, FitsInEveryWindow) {
    for (render::Size const size : {render::Size{800, 600}, render::Size{1024, 768}, render::Size{1280, 720},
                                    render::Size{1920, 1080}, render::Size{3840, 2160}}) {
        for (float const scale : {0.75F, 1.F, 1.6F}) {
            Player player(size);
            changeSettings(player.app().context(),
                           {.uiScale = scale, .reducedMotion = true, .language = "de"});
            solve(player);
            player.key(SDLK_y, KMOD_LSHIFT);
            waitForAnswer(player);
            player.key(SDLK_d);
            player.frames(4);
            std::string const where = "why at " + std::to_string(size.width) + ", letters " +
                                      std::to_string(std::lround(100 * scale));
            EXPECT_TRUE(player.showsCard("why")) << where;
            expectTidy(player, where);
            if (size.width == 800) {
                player.look("why-800-" + std::to_string(std::lround(100 * scale)));
            }
        }
    }
    window().setUiScaleRequest(1.F);
}

} // namespace
} // namespace why_panel_test
} // namespace trembler::ui::test

// The editor's pages about the level: the report, and further solutions.
#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "game/ui/shared/texts.hpp"
#include "insight/report/report_text.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <nlohmann/json.hpp>

namespace trembler::ui::test {
namespace studies_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";

/// Few runs, so that a test takes a moment.
insight::ReportOptions briefReport() {
    insight::ReportOptions options;
    options.robustness.runs = 12;
    options.drops = 12;
    options.map.places = 24;
    options.maps = true;
    options.costs = false;
    return options;
}

class Examiner : public Designer {
public:
    using Designer::Designer;

    LevelStudies& studies() { return *parts().studies; }
    void openFirst() {
        editCopyOf(firstContact);
        studies().reportOptions = briefReport();
        studies().request.runs = 80;
    }
    /// Waits until the work has ended, and its result is shown.
    template <class Result>
    void await(Study<Result> const& study) {
        ASSERT_NE(study.work, nullptr);
        study.work->wait();
        frames(3);
    }
    void makeReport() {
        ctrl(SDLK_e);
        await(studies().report());
    }
    void search() {
        ctrl(SDLK_f);
        await(studies().searched());
    }
    /// Whether the panel contains a text, whose lines may be broken, somewhere without scrolling.
    bool says(std::string const& text) {
        (void)look("studies");
        std::string all;
        for (std::string const& line : DrawnWords().lines()) {
            all += line + " ";
        }
        return all.find(text) != std::string::npos;
    }
    void seek(std::string const& item) {
        moveTo(layout().card("panel")->middle());
        for (int i = 0; i < 60; ++i) {
            wheel(1);
        }
        scrollTo("panel", item);
    }
    void press(std::string const& item) {
        seek(item);
        clickItem(item);
        frames(2);
    }
};

/// The report of the command line, without the level's name.
nlohmann::json told(insight::LevelReport const& report) {
    auto json = nlohmann::json::parse(toJson(report).dump());
    json.erase("level");
    return json;
}

TEST(EditorReport, AgreesWithTheCommandLines) {
    Examiner designer;
    designer.openFirst();
    designer.makeReport();
    EXPECT_EQ(designer.parts().tab, Tab::report);
    auto const shown = designer.studies().report().result();
    ASSERT_NE(shown, nullptr);
    insight::LevelUnderTest const level(gameData(), firstContact);
    insight::Workers workers({});
    EXPECT_EQ(told(*shown), told(reportOn(level, briefReport(), workers)));
    for (std::size_t i = 0; i < shortcomingsOf(*shown).size(); ++i) {
        EXPECT_TRUE(designer.shows("shortcoming " + std::to_string(i)));
    }
    EXPECT_EQ(designer.says(words::nothingShort), shortcomingsOf(*shown).empty());
    EXPECT_FALSE(designer.says(words::olderState));
    for (char const* const item : {"reported 0", "reported 1", "reported 2"}) {
        EXPECT_TRUE(designer.shows(item)) << item;
    }
}

TEST(EditorReport, ShowsWhatASolutionNeedsAndPlaysIt) {
    Examiner designer;
    designer.openFirst();
    designer.makeReport();
    designer.press("reported 0");
    EXPECT_EQ(designer.studies().solution, 0U);
    designer.look("edit-report");
    designer.seek("places 0");
    designer.clickItem("places 0");
    EXPECT_EQ(designer.studies().placement, 0U);
    designer.press("watch reported");
    ASSERT_NE(designer.screen().test(), nullptr);
    for (int i = 0; i < 400 && !designer.screen().test()->session().solved(); ++i) {
        designer.frame();
    }
    EXPECT_TRUE(designer.screen().test()->session().solved());
    designer.key(SDLK_ESCAPE);
    designer.frames(2);
    EXPECT_EQ(designer.screen().test(), nullptr);
    EXPECT_EQ(designer.parts().tab, Tab::report) << "back where one was";
}

render::Pixel pixelAt(render::Image const& image, Point at) {
    return image.at(static_cast<int>(at.x), static_cast<int>(at.y));
}

TEST(EditorReport, DrawsWhereAPartMayLie) {
    Examiner designer;
    designer.editCopyOf(levelsFolder() / "first/2-into-the-basket.json");
    designer.studies().reportOptions = briefReport();
    designer.studies().reportOptions.map.places = 120;
    designer.makeReport();
    auto const report = designer.studies().report().result();
    insight::PlaceMap const& map = report->solutions[0].maps.at(0);
    Vec2 const middle = designer.parts().level.findSolution(report->solutions[0].name)->placements[0].at;
    render::Image const before = designer.look("edit-report-before");
    designer.press("reported 0");
    designer.moveTo({400, 700});
    designer.frames(4);
    render::Image const after = designer.look("edit-report-map");
    int solving = 0;
    int failing = 0;
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
        for (std::size_t column = 0; column < map.rows[row].size(); ++column) {
            char const state = map.rows[row][column];
            double const right = static_cast<double>(column) - static_cast<double>(map.column);
            double const up = static_cast<double>(map.row) - static_cast<double>(row);
            Point const at = designer.on(middle + map.step * Vec2{right, up});
            solving += state == '#' ? 1 : 0;
            failing += state == '.' ? 1 : 0;
            if (state == '#' || state == '.') {
                EXPECT_NE(pixelAt(after, at), pixelAt(before, at)) << row << ", " << column;
            }
        }
    }
    EXPECT_GT(solving, 10);
    EXPECT_GT(failing, 3);
    designer.press("reported 0");
    designer.moveTo({400, 700});
    designer.frames(4);
    EXPECT_EQ(designer.studies().solution, LevelStudies::noChoice) << "once more: nothing is chosen";
}

TEST(EditorReport, SaysWhatFallsShortAndIsOfTheUnsavedLevel) {
    Examiner designer;
    designer.openFirst();
    // Without its two solutions that solve it, nothing in the file changes.
    designer.key(SDLK_F7);
    designer.frames(2);
    designer.clickItem("solution 0 remove");
    designer.frames(2);
    ASSERT_EQ(designer.count("solutions"), 2U);
    designer.makeReport();
    auto const shown = designer.studies().report().result();
    ASSERT_NE(shown, nullptr);
    EXPECT_EQ(shown->solutions.size(), 2U);
    EXPECT_TRUE(designer.shows("shortcoming 0"));
    EXPECT_TRUE(designer.says(words::oneKind));
    designer.ctrl(SDLK_z);
    designer.frames(2);
    EXPECT_TRUE(designer.says(words::olderState));
    designer.makeReport();
    EXPECT_FALSE(designer.says(words::olderState));
    EXPECT_EQ(designer.studies().report().result()->solutions.size(), 3U);
}

TEST(EditorReport, StopsWithWhatItHasAndBlocksNothing) {
    Examiner designer;
    designer.openFirst();
    designer.studies().reportOptions.robustness.runs = 100'000;
    designer.ctrl(SDLK_e);
    // The needs of its solutions are shown at once; all the displaced runs would take minutes.
    for (int i = 0; i < 100'000 && designer.studies().report().result() == nullptr; ++i) {
        designer.frame();
    }
    ASSERT_NE(designer.studies().report().result(), nullptr);
    EXPECT_TRUE(designer.studies().busy());
    EXPECT_FALSE(designer.screen().still()) << "the numbers change by themselves";
    designer.frames(2);
    EXPECT_TRUE(designer.shows("reported 0"));
    designer.select({1.7, 0.15});
    EXPECT_EQ(designer.parts().selected().size(), 1U) << "one works on meanwhile";
    designer.clickItem("make report");
    designer.await(designer.studies().report());
    EXPECT_FALSE(designer.studies().busy());
    EXPECT_FALSE(designer.studies().report().result()->complete);
    EXPECT_TRUE(designer.says(words::stoppedEarly));
    EXPECT_TRUE(designer.shows("reported 0"));
}

TEST(EditorReport, IsForgottenWithItsLevelAndNeedsAGoal) {
    Examiner designer;
    designer.openFirst();
    designer.studies().reportOptions.robustness.runs = 100'000;
    designer.ctrl(SDLK_e);
    designer.frames(2);
    designer.ctrl(SDLK_n);
    designer.frames(2);
    EXPECT_EQ(designer.studies().report().work, nullptr);
    designer.ctrl(SDLK_e);
    designer.frames(2);
    EXPECT_EQ(designer.studies().report().work, nullptr) << "a new level has no goal";
}

TEST(EditorReport, MeasuresCostsWhenAsked) {
    Examiner designer;
    designer.openFirst();
    designer.makeReport();
    EXPECT_EQ(designer.studies().costs().work, nullptr);
    designer.press("measure costs");
    designer.await(designer.studies().costs());
    auto const costs = designer.studies().costs().result();
    ASSERT_NE(costs, nullptr);
    EXPECT_FALSE(costs->costs.empty());
    EXPECT_FALSE(costs->ways.empty());
    designer.look("edit-report-costs");
}

TEST(EditorSearch, FindsWhatTheCommandLineFinds) {
    Examiner designer;
    designer.openFirst();
    designer.search();
    EXPECT_EQ(designer.parts().tab, Tab::search);
    auto const shown = designer.studies().searched().result();
    ASSERT_NE(shown, nullptr);
    insight::LevelUnderTest const level(gameData(), firstContact);
    insight::Workers workers({});
    insight::SearchOptions options;
    options.runs = 80;
    insight::SearchResult const search = searchFor(level, options, workers);
    EXPECT_TRUE(shown->complete);
    EXPECT_EQ(shown->search.runs, search.runs);
    EXPECT_EQ(shown->search.solved, search.solved);
    ASSERT_EQ(shown->search.found.size(), search.found.size());
    ASSERT_FALSE(search.found.empty());
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        EXPECT_EQ(toJson(shown->search.found[i]), toJson(search.found[i]));
        ASSERT_NE(shown->moments[i], nullptr) << "a picture of it";
        EXPECT_TRUE(shown->moments[i]->solved());
    }
    designer.look("edit-search");
    designer.seek("found picture 0");
    EXPECT_TRUE(designer.shows("found picture 0"));
}

TEST(EditorSearch, KeepsWhatItFoundAsASolutionThatCanBeUndone) {
    Examiner designer;
    designer.openFirst();
    edit::Json const before = designer.tree();
    designer.search();
    designer.press("found 0 keep");
    ASSERT_EQ(designer.count("solutions"), before["solutions"].size() + 1);
    EXPECT_FALSE(designer.says(words::olderState)) << "a search does not look at recorded solutions";
    EXPECT_TRUE(designer.parts().document.undoName().starts_with("Record solution 'found 1: "));
    // The edited level has the solution, and it solves the level.
    LevelFile const level = designer.parts().document.level();
    Session session(gameData().registry, gameData().parts, level);
    session.load(level.solutions.back());
    for (int i = 0; i < *level.solutions.back().frames; ++i) {
        session.step();
    }
    EXPECT_TRUE(session.solved());
    designer.ctrl(SDLK_z);
    designer.frames(2);
    EXPECT_EQ(designer.tree(), before);
    designer.ctrl(SDLK_y);
    designer.frames(2);
    EXPECT_EQ(designer.count("solutions"), before["solutions"].size() + 1);
    designer.press("found 0 keep");
    EXPECT_EQ(designer.count("solutions"), before["solutions"].size() + 2) << "with a number";
}

TEST(EditorSearch, PlaysWhatItFound) {
    Examiner designer;
    designer.openFirst();
    designer.search();
    designer.press("found 0 play");
    ASSERT_NE(designer.screen().test(), nullptr);
    for (int i = 0; i < 1200 && !designer.screen().test()->session().solved(); ++i) {
        designer.frame();
    }
    EXPECT_TRUE(designer.screen().test()->session().solved());
    EXPECT_EQ(designer.count("solutions"), 3U) << "playing records nothing";
}

TEST(EditorSearch, StopsAtAnyTimeWithWhatItHas) {
    Examiner designer;
    designer.openFirst();
    designer.studies().request.runs = 1e8;
    designer.ctrl(SDLK_f);
    for (int i = 0; i < 100'000 && designer.studies().searched().result() == nullptr; ++i) {
        designer.frame();
    }
    ASSERT_NE(designer.studies().searched().result(), nullptr);
    designer.frames(2);
    designer.clickItem("search");
    designer.await(designer.studies().searched());
    auto const shown = designer.studies().searched().result();
    EXPECT_FALSE(shown->complete);
    EXPECT_GT(shown->search.runs, 0U);
    EXPECT_LT(shown->search.runs, 100'000'000U);
    EXPECT_TRUE(designer.says(words::stoppedEarly));
}

TEST(EditorStudies, SpeakGerman) {
    Examiner designer({800, 600}); // where long words have the least room
    designer.openFirst();
    useLanguage("de");
    designer.makeReport();
    designer.press("reported 0");
    designer.look("edit-german-report");
    EXPECT_TRUE(designer.says("Aufgezeichnete"));
    designer.search();
    designer.look("edit-german-search");
    EXPECT_TRUE(designer.says("gefundene"));
    useLanguage("en");
}

} // namespace
} // namespace studies_test
} // namespace trembler::ui::test

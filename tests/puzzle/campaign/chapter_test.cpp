// Descriptions of folders of levels.
#include "puzzle/campaign/chapter.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/data/published_schema.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

namespace trembler {
namespace {

namespace fs = std::filesystem;

Chapter chapterFrom(std::string text) {
    return readChapter(JsonDocument::parse(std::move(text), "chapter.json"));
}

TEST(Chapter, StatesItsTitlePlaceAndKind) {
    Chapter const all =
        chapterFrom(R"({"title": "Magnets", "text": "They pull.", "order": 3, "kind": "gallery"})");
    EXPECT_EQ(all.title, "Magnets");
    EXPECT_EQ(all.text, "They pull.");
    EXPECT_EQ(all.order, 3);
    EXPECT_EQ(all.kind, ChapterKind::gallery);
    Chapter const least = chapterFrom(R"({"title": "Water"})");
    EXPECT_EQ(least.kind, ChapterKind::puzzles);
    EXPECT_GT(least.order, 100) << "after the chapters that state an order";
}

TEST(Chapter, ErrorsAreRefusedWithTheirPlace) {
    for (char const* wrong :
         {"[]", "{}", R"({"title": 3})", R"({"title": ""})", R"({"title": "a", "order": "b"})",
          R"({"title": "a", "kind": "c"})", R"({"title": "a", "ordre": 1})"}) {
        EXPECT_THROW((void)chapterFrom(wrong), InputError) << wrong;
    }
    try {
        (void)chapterFrom("{\"title\": \"a\",\n \"ordre\": 1}");
        FAIL();
    } catch (InputError const& error) {
        std::string const problem = error.diagnostics().front().print();
        EXPECT_NE(problem.find("chapter.json:2"), std::string::npos) << problem;
        EXPECT_NE(problem.find("order"), std::string::npos) << problem;
    }
}

TEST(Chapter, AFolderWithoutOneIsCalledByItsName) {
    fs::path const folder = fs::path(TREMBLER_BINARY_DIR) / "chapter-test" / "2-moving_parts";
    fs::create_directories(folder);
    fs::remove(folder / chapterFile);
    EXPECT_EQ(loadChapter(folder).title, "Moving parts");
    std::ofstream(folder / chapterFile) << R"({"title": "Wheels"})";
    EXPECT_EQ(loadChapter(folder).title, "Wheels");
    EXPECT_TRUE(isNotALevel(folder / chapterFile));
    EXPECT_TRUE(isNotALevel("levels/level.schema.json"));
    EXPECT_FALSE(isNotALevel("levels/first/1-first-contact.json"));
}

TEST(Chapter, EveryFolderOfLevelsHasOneAndTheSchemaIsPublished) {
    fs::path const levels = fs::path(TREMBLER_SOURCE_DIR) / "levels";
    for (auto const& entry : fs::directory_iterator(levels)) {
        if (entry.is_directory()) {
            EXPECT_TRUE(fs::exists(entry.path() / chapterFile)) << entry.path();
            EXPECT_NO_THROW((void)loadChapter(entry.path())) << entry.path();
        }
    }
    std::ifstream in(levels / "chapter.schema.json");
    std::string const published(std::istreambuf_iterator<char>(in), {});
    EXPECT_EQ(published, publishedSchema(AuthoredFile::chapter).dump(2) + "\n");
}

} // namespace
} // namespace trembler

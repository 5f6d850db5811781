// Texts of a language: by the English text, and by texts with gaps.
#include "puzzle/language/catalogue.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace trembler {
namespace {

namespace fs = std::filesystem;

class CatalogueTest : public testing::Test {
protected:
    CatalogueTest() {
        fs::remove_all(folder);
        fs::create_directories(folder / "de");
        write("de.json", R"({"title.play": "Spielen"})");
        write("de/words.json", R"({"Undo": "Rückgängig", "{} of {}": "{} von {}"})");
        write("de/names.json", R"({"nouns": {"bucket": "der Eimer"}})");
        write("de/messages.json",
              R"({"it would overlap the {}": "es läge auf {dat}", "no {} here": "kein {name} hier",
            "off: {}": "aus: {}", "{}: {}": "{} - {}"})");
    }
    ~CatalogueTest() override { fs::remove_all(folder); }

    void write(char const* name, char const* text) const { std::ofstream(folder / name) << text; }

    fs::path const folder = fs::path(testing::TempDir()) / "trembler-catalogue-test";
};

TEST_F(CatalogueTest, FindsTextsOfAllFiles) {
    Catalogue const german(folder, "de");
    EXPECT_STREQ(german.find("title.play"), "Spielen");
    EXPECT_STREQ(german.find("Undo"), "Rückgängig");
    EXPECT_EQ(german.find("Redo"), nullptr);
    EXPECT_EQ(Catalogue().find("Undo"), nullptr);
    EXPECT_EQ(Catalogue(folder, "fr").translated("Undo"), "Undo");
}

TEST_F(CatalogueTest, TranslatesFinishedSentences) {
    Catalogue const german(folder, "de");
    EXPECT_EQ(german.translated("Undo"), "Rückgängig");
    EXPECT_EQ(german.translated("it would overlap the bucket"), "es läge auf dem Eimer");
    EXPECT_EQ(german.translated("no bucket here"), "kein Eimer hier");
    EXPECT_EQ(german.translated("off: it would overlap the bucket"), "aus: es läge auf dem Eimer")
        << "the text that leaves the least to its gaps, and what is in the gaps likewise";
    EXPECT_EQ(german.translated("3 of 4"), "3 of 4") << "only those of messages.json are recognised";
    EXPECT_EQ(german.translated("it would"), "it would");
    EXPECT_EQ(german.translated(""), "");
}

TEST_F(CatalogueTest, LeavesOwnNamesAndQuotedBracesAsTheyAre) {
    write("de/edits.json", R"({"rename '{}'": "„{own}“ umbenennen", "Change {}": "{} ändern", "Mass": "Masse",
                               "an object {\"part\"}": "ein Objekt {\"part\"}"})");
    Catalogue const german(folder, "de");
    EXPECT_EQ(german.translated("rename 'Undo'"), "„Undo“ umbenennen") << "a name, though it is a word, too";
    EXPECT_EQ(german.translated("Change mass"), "Masse ändern") << "a title in the middle of a sentence";
    EXPECT_EQ(german.translated("an object {\"part\"}"), "ein Objekt {\"part\"}");
    EXPECT_EQ(german.translated("an object of stone"), "an object of stone");
}

// Words of another sentence may be in a message, but a place is before it and no part of it.
TEST_F(CatalogueTest, LeavesThePlaceBeforeAMessage) {
    write("de/faults.json", R"({"{}; expected {}": "{}; erwartet: {}", "'{}' is not there; look at {}":
        "„{own}“ fehlt; siehe {own}", "{} is {}": "{} ist {}"})");
    Catalogue const german(folder, "de");
    EXPECT_EQ(german.translated("wind.lua:12: it would overlap the bucket"),
              "wind.lua:12: es läge auf dem Eimer");
    EXPECT_EQ(german.translated("wind.lua:12: 'x' is not there; look at y"),
              "wind.lua:12: „x“ fehlt; siehe y");
    EXPECT_EQ(german.translated("/my levels/a.json:3:14: no bucket here"),
              "/my levels/a.json:3:14: kein Eimer hier");
    EXPECT_EQ(german.translated("off: no bucket here"), "aus: kein Eimer hier") << "that is no place";
    EXPECT_EQ(german.translated("it: no bucket here"), "it - kein Eimer hier");
}

TEST_F(CatalogueTest, LeavesOutWhatIsDamaged) {
    write("de/words.json", R"({"Undo": "Rück)");
    write("de/other.json", R"({"Redo": 3, "Run": "Start"})");
    Catalogue const german(folder, "de");
    EXPECT_EQ(german.find("Undo"), nullptr);
    EXPECT_EQ(german.find("Redo"), nullptr);
    EXPECT_STREQ(german.find("Run"), "Start");
}

TEST(CataloguePieces, AreWhatLiesBetweenTheGaps) {
    auto const pieces = Catalogue::piecesOf("{} left of {:.1f} {{x}}");
    EXPECT_EQ(pieces.between, (std::vector<std::string>{"", " left of ", " {x}"}));
    EXPECT_EQ(pieces.gaps, (std::vector<std::string>{"", ":.1f"}));
    EXPECT_EQ(Catalogue::piecesOf("").between, (std::vector<std::string>{""}));
    EXPECT_EQ(Catalogue::piecesOf("{ open").between, (std::vector<std::string>{"{ open"}));
}

} // namespace
} // namespace trembler

// The document: opening, history, saving.
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

TEST(LevelDocument, UndoesAndRedoesAnyCommands) {
    rc::check([] {
        LevelDocument document = smallDocument();
        std::vector<std::string> texts{document.text()};
        int const count = *rc::gen::inRange(1, 25);
        for (int i = 0; i < count; ++i) {
            try {
                document.run(anyCommand(document, [](int below) { return *rc::gen::inRange(0, below); }));
            } catch (CommandError const&) {
                continue;
            }
            if (document.done() == texts.size()) {
                texts.push_back(document.text());
            }
            RC_ASSERT(Json::parse(document.text()) == document.tree());
        }
        std::size_t const done = document.done();
        RC_ASSERT(done + 1 == texts.size());
        for (std::size_t i = done; i > 0; --i) {
            RC_ASSERT(document.undo());
            RC_ASSERT(document.text() == texts[i - 1]);
        }
        RC_ASSERT(!document.undo());
        RC_ASSERT(document.text() == smallLevel());
        for (std::size_t i = 1; i <= done; ++i) {
            RC_ASSERT(document.redo());
            RC_ASSERT(document.text() == texts[i]);
        }
    });
}

TEST(LevelDocument, JoinsTheCommandsOfAGesture) {
    LevelDocument document = smallDocument();
    Gesture const drag{document.newGesture(), Gesture::Next::replaces};
    for (double x : {0.5, 1.0, 1.5}) {
        document.run(moveObjects(editData(), document.tree(), {"ball"}, {x, 0}), drag);
    }
    EXPECT_EQ(document.done(), 1U);
    EXPECT_EQ(document.undoName(), "Move ball");
    EXPECT_EQ(document.tree()["objects"][3]["at"], Json::array({1.5, 3}));
    Gesture const keys{document.newGesture(), Gesture::Next::adds};
    document.run(moveObjects(editData(), document.tree(), {"ball"}, {0, 1}), keys);
    document.run(moveObjects(editData(), document.tree(), {"ball"}, {0, 1}), keys);
    EXPECT_EQ(document.done(), 2U);
    EXPECT_EQ(document.tree()["objects"][3]["at"], Json::array({1.5, 5}));
    document.goTo(0);
    EXPECT_EQ(document.text(), smallLevel());
    EXPECT_EQ(document.redoName(), "Move ball");
    // A drag back to where it began is no step.
    Gesture const back{document.newGesture(), Gesture::Next::replaces};
    document.run(moveObjects(editData(), document.tree(), {"ball"}, {1, 0}), back);
    document.run(moveObjects(editData(), document.tree(), {"ball"}, {0, 0}), back);
    EXPECT_FALSE(document.canUndo());
}

TEST(LevelDocument, OpensFilesWithErrorsReadOnly) {
    fs::path const folder = testFolder();
    auto const opened = [&](std::string const& text) {
        writeText(folder / "level.json", text);
        return LevelDocument::open(editData(), folder / "level.json");
    };
    LevelDocument noJson = opened("{\"version\": 2,");
    EXPECT_TRUE(noJson.readOnly());
    EXPECT_FALSE(noJson.mayBeEdited());
    EXPECT_EQ(noJson.faults().size(), 1U);
    EXPECT_EQ(noJson.text(), "{\"version\": 2,");
    EXPECT_FALSE(noJson.save().ok());
    LevelDocument newer = opened(R"({"version": 99, "title": "x", "unheard": 1})");
    EXPECT_TRUE(newer.readOnly());
    EXPECT_NE(newer.faults().front().message.find("newer"), std::string::npos);
    EXPECT_NE(refusalOf([&] { newer.editNevertheless(); }), "");
    LevelDocument wrong = opened(R"({"version": 2, "title": "x", "objets": []})");
    EXPECT_TRUE(wrong.readOnly());
    EXPECT_NE(refusalOf([&] { wrong.run(setTitle(wrong.tree(), "y")); }), "");
    wrong.editNevertheless();
    wrong.run(setTitle(wrong.tree(), "y"));
    EXPECT_EQ(wrong.text(), R"({"version": 2, "title": "y", "objets": []})");
    for (std::string const text : {"[]", "3", "null", R"({"title": 3})"}) {
        EXPECT_TRUE(opened(text).readOnly()) << text;
    }
}

TEST(LevelDocument, SaysWhyAFileCannotBeOpened) {
    fs::path const folder = testFolder();
    EXPECT_THROW(static_cast<void>(LevelDocument::open(editData(), folder / "none.json")), InputError);
    EXPECT_THROW(static_cast<void>(LevelDocument::open(editData(), folder)), InputError);
}

TEST(LevelDocument, ConvertsOldVersionsWhereTheyDiffer) {
    fs::path const file = testFolder() / "old.json";
    writeText(
        file,
        "{\"version\": 0, \"title\": \"old\",\n \"gravity\": [0, -1.50],  \"toolbox\": {\"plank\": 2}}");
    LevelDocument const document = LevelDocument::open(editData(), file);
    EXPECT_FALSE(document.readOnly());
    EXPECT_FALSE(document.modified());
    EXPECT_NO_THROW(static_cast<void>(document.level()));
    EXPECT_EQ(document.text().substr(0, 33), "{\"version\": 2, \"title\": \"old\",  \"");
}

TEST(LevelDocument, SavesWithoutLosingAnothersChanges) {
    fs::path const file = testFolder() / "level.json";
    writeText(file, smallLevel());
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    LevelDocument document = LevelDocument::open(editData(), file);
    document.run(setTitle(document.tree(), "mine"));
    EXPECT_TRUE(document.modified());
    ASSERT_TRUE(document.save().ok());
    EXPECT_FALSE(document.modified());
    EXPECT_EQ(fileText(file), document.text());
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    document.undo();
    EXPECT_TRUE(document.modified());
    document.redo();
    EXPECT_FALSE(document.modified());

    writeText(file, "theirs");
    document.run(setTitle(document.tree(), "mine again"));
    EXPECT_EQ(document.save().kind, SaveResult::Kind::conflict);
    EXPECT_EQ(fileText(file), "theirs");
    EXPECT_FALSE(fs::exists(file.string() + ".damaged-1")) << "nothing is moved for a question";
    EXPECT_TRUE(document.save(LevelDocument::Overwrite::yes).ok());
    EXPECT_EQ(fileText(file), document.text());
    EXPECT_EQ(fileText(file.string() + ".damaged-1"), "theirs") << "it is no level, but somebody's work";
    std::string const before = document.text();
    document.run(setTitle(document.tree(), "mine once more"));
    ASSERT_TRUE(document.save().ok());
    EXPECT_EQ(fileText(file.string() + "~"), before);

    fs::path const other = file.parent_path() / "other.json";
    writeText(other, "there");
    EXPECT_EQ(document.saveAs(other).kind, SaveResult::Kind::conflict);
    EXPECT_EQ(document.saveAs(file.parent_path() / "no" / "folder.json").kind, SaveResult::Kind::failed);
    EXPECT_EQ(document.saveAs(file.parent_path()).kind, SaveResult::Kind::failed);
    EXPECT_EQ(document.path(), file);
    EXPECT_TRUE(document.saveAs(other, LevelDocument::Overwrite::yes).ok());
    EXPECT_EQ(document.path(), other);
    EXPECT_FALSE(LevelDocument::blank(editData()).save().ok());
}

TEST(LevelDocument, BeginsWithALevelThatCanBePlayed) {
    LevelDocument const blank = LevelDocument::blank(editData());
    EXPECT_FALSE(blank.readOnly());
    EXPECT_FALSE(blank.modified());
    EXPECT_EQ(blank.level().objects.size(), 1U);
}

TEST(LevelDocument, ARefusedStepOfADragLeavesTheStepBefore) {
    LevelDocument document = smallDocument();
    Gesture const drag{document.newGesture(), Gesture::Next::replaces};
    auto const title = [](char const* text, bool fails) {
        return Command{"Title", [=](Json& level) {
                           level["title"] = text;
                           if (fails) {
                               throw CommandError("no");
                           }
                       }};
    };
    document.run(title("one", false), drag);
    std::string const text = document.text();
    EXPECT_EQ(refusalOf([&] { document.run(title("two", true), drag); }), "no");
    EXPECT_EQ(document.text(), text);
    EXPECT_EQ(document.tree()["title"], "one");
    document.run(title("three", false), drag);
    EXPECT_EQ(document.done(), 1U);
    document.undo();
    EXPECT_EQ(document.text(), smallLevel());
    EXPECT_EQ(refusalOf([&] { document.run(title("four", true)); }), "no");
    EXPECT_EQ(document.text(), smallLevel());
}

TEST(LevelDocument, AnotherSpellingOfANumberIsNoChange) {
    LevelDocument document = smallDocument();
    document.run({"Spell", [](Json& level) {
                      level["objects"][2]["angle_deg"] = 90; // 90.0 in the file
                      level["objects"][1]["at"][0] = -2.0;
                      level["title"] = "changed";
                  }});
    Json const after = document.tree();
    EXPECT_TRUE(after["objects"][2]["angle_deg"].is_number_float());
    EXPECT_FALSE(after["objects"][1]["at"][0].is_number_float());
    document.undo();
    document.redo();
    EXPECT_EQ(document.tree().dump(), after.dump());
}

TEST(LevelDocument, ForgetsTheOldestStepsWhenItsHistoryTakesTooMuchMemory) {
    fs::path const file = testFolder() / "level.json";
    writeText(file, smallLevel());
    LevelDocument document = LevelDocument::open(editData(), file);
    constexpr std::size_t bytes = 200'000;
    constexpr std::size_t steps = 12;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < steps; ++i) {
        document.run(
            {"Step", [&](Json& tree) { tree["text"] = std::string(bytes, static_cast<char>('a' + i)); }});
        texts.push_back(document.text());
    }
    EXPECT_EQ(document.done(), steps);
    document.shortenHistory(2 * steps * bytes + steps * 10'000);
    document.goTo(0);
    EXPECT_EQ(document.text(), smallLevel()) << "all of them fit";
    EXPECT_FALSE(document.modified());
    document.goTo(steps);
    document.shortenHistory(10 * bytes); // five steps: each holds a text before and after it
    EXPECT_EQ(document.done(), steps) << "those that were forgotten count";
    std::size_t undone = 0;
    while (document.undo()) {
        ++undone;
        EXPECT_EQ(document.text(), texts[steps - 1 - undone]);
        EXPECT_TRUE(document.modified()) << "the state that was opened is out of reach";
    }
    EXPECT_GE(undone, 4U);
    EXPECT_LE(undone, 5U);
    EXPECT_EQ(document.done(), steps - undone);
    document.goTo(0); // no further than it can
    EXPECT_EQ(document.done(), steps - undone);
    document.goTo(steps);
    EXPECT_EQ(document.text(), texts.back());
    document.shortenHistory(0);
    undone = 0;
    while (document.undo()) {
        ++undone;
    }
    EXPECT_EQ(undone, LevelDocument::fewestSteps) << "the last ones stay, whatever they take";
    while (document.redo()) {
    }
    EXPECT_EQ(document.text(), texts.back());
}

TEST(LevelDocument, BoundsItsHistoryWhileItIsEdited) {
    LevelDocument document = smallDocument();
    // Half as much again as the history may take; each step holds a text before and after it.
    constexpr std::size_t bytes = 3 * LevelDocument::mostHistory / 2 / 40 / 2;
    for (int i = 0; i < 40; ++i) {
        document.run({"Step", [&](Json& tree) {
                          tree["text"] = std::string(bytes, static_cast<char>('a' + i % 26));
                      }});
    }
    EXPECT_EQ(document.done(), 40U);
    std::size_t undone = 0;
    while (document.undo()) {
        ++undone;
    }
    EXPECT_GT(undone, 24U);
    EXPECT_LT(undone, 29U) << "two thirds fit";
}

} // namespace
} // namespace trembler::edit

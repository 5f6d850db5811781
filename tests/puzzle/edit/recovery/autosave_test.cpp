// Recovery: what is left when a program ends without closing its document.
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/recovery/autosave.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

TEST(Autosave, LeavesWhatWasChangedWhenTheProgramDies) {
    fs::path const folder = testFolder();
    fs::path const file = folder / "level.json";
    fs::path const recovery = folder / "recovery";
    writeText(file, smallLevel());
    {
        LevelDocument document = LevelDocument::open(editData(), file);
        Autosave autosave(recovery);
        autosave.tick(document, 5);
        EXPECT_TRUE(findRecoveries(recovery).empty());
        document.run(setTitle(document.tree(), "unsaved"));
        autosave.tick(document, 0.6);
        autosave.tick(document, 0.6);
        EXPECT_FALSE(autosave.file().empty());
        EXPECT_FALSE(autosave.error());
        EXPECT_TRUE(findRecoveries(recovery).empty()); // this program is alive
        autosave.abandon();
    }
    EXPECT_EQ(fileText(file), smallLevel());
    auto const found = findRecovery(recovery, file);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->title, "unsaved");
    EXPECT_FALSE(found->changedSince);
    EXPECT_FALSE(findRecovery(recovery, {}));
    LevelDocument document = recover(editData(), *found);
    EXPECT_TRUE(document.modified());
    EXPECT_EQ(document.tree()["title"], "unsaved");
    ASSERT_TRUE(document.save().ok());
    EXPECT_FALSE(document.modified());
    EXPECT_TRUE(findRecoveries(recovery).empty()); // nothing would be lost, so it was removed
    EXPECT_TRUE(fs::is_empty(recovery));
}

TEST(Autosave, SurvivesKill) {
    fs::path const recovery = testFolder() / "recovery";
    LevelDocument document = smallDocument();
    document.run(setTitle(document.tree(), "killed"));
    static_cast<void>(document.text());
    pid_t const child = ::fork();
    if (child == 0) {
        Autosave autosave(recovery);
        autosave.flush(document);
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    auto const found = findRecoveries(recovery);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().title, "killed");
    EXPECT_EQ(found.front().text, document.text());
    discard(found.front());
    EXPECT_TRUE(fs::is_empty(recovery));
}

TEST(Autosave, EndsWithSavingAndClosing) {
    fs::path const folder = testFolder();
    fs::path const file = folder / "level.json";
    writeText(file, smallLevel());
    LevelDocument document = LevelDocument::open(editData(), file);
    Autosave autosave(folder / "recovery");
    document.run(setTitle(document.tree(), "x"));
    autosave.flush(document);
    EXPECT_TRUE(fs::exists(autosave.file()));
    ASSERT_TRUE(document.save().ok());
    autosave.tick(document, 2);
    EXPECT_TRUE(autosave.file().empty());
    EXPECT_TRUE(fs::is_empty(folder / "recovery"));
}

TEST(Autosave, SeesThatTheLevelChangedSince) {
    fs::path const folder = testFolder();
    fs::path const file = folder / "level.json";
    writeText(file, smallLevel());
    LevelDocument document = LevelDocument::open(editData(), file);
    document.run(setTitle(document.tree(), "mine"));
    Autosave autosave(folder / "recovery");
    autosave.flush(document);
    autosave.abandon();
    writeText(file, "{}");
    auto const found = findRecovery(folder / "recovery", file);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->changedSince);
    EXPECT_EQ(recover(editData(), *found).save().kind, SaveResult::Kind::conflict);
}

TEST(Autosave, SaysWhatWentWrongAndIgnoresOtherFiles) {
    fs::path const folder = testFolder();
    writeText(folder / "blocked", "a file, not a folder");
    LevelDocument document = smallDocument();
    document.run(setTitle(document.tree(), "x"));
    Autosave autosave(folder / "blocked");
    autosave.flush(document);
    EXPECT_TRUE(autosave.error());
    Autosave none{fs::path()};
    none.flush(document);
    EXPECT_FALSE(none.error());
    for (char const* const text : {"", "{", "[]", R"({"recovery": 1})", R"({"recovery": 1, "text": 3})"}) {
        writeText(folder / "other.json", text);
        EXPECT_TRUE(findRecoveries(folder).empty()) << text;
    }
    EXPECT_TRUE(findRecoveries(folder / "nowhere").empty());
}

} // namespace
} // namespace trembler::edit

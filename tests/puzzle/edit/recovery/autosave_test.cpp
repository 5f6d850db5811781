// Recovery: the files that remain when a program ends without closing its document.
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/recovery/autosave.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <random>
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
        EXPECT_TRUE(findRecoveries(recovery).empty()); // this program still runs
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

constexpr double secondsPerStep = 0.3;

/// The number that the designer of the test has written into the title of a level.
int numberIn(std::string const& title) {
    return title.empty() || title.front() < '0' || title.front() > '9' ? 0 : std::stoi(title);
}

/// Edits without end, and saves now and then; writes the number of every complete step.
[[noreturn]] void designUntilKilled(fs::path const& file, fs::path const& recovery, int tell) {
    LevelDocument document = LevelDocument::open(editData(), file);
    Autosave autosave(recovery);
    for (int step = 1;; ++step) {
        document.run(setTitle(document.tree(), std::to_string(step)));
        if (step % 11 == 0) {
            if (!document.save().ok()) {
                ::_exit(1);
            }
            autosave.close();
        }
        autosave.tick(document, secondsPerStep);
        if (autosave.error() || ::write(tell, &step, sizeof step) != sizeof step) {
            ::_exit(1);
        }
    }
}

TEST(Autosave, LosesAtMostTwoSecondsAndNeverTheFileWheneverItIsKilled) {
    fs::path const folder = testFolder();
    fs::path const file = folder / "level.json";
    std::mt19937 random(1);
    Json large = Json::parse(smallLevel()); // writing it takes a while
    for (int i = 0; i < 200; ++i) {
        large["objects"].push_back(
            {{"name", "crate " + std::to_string(i)}, {"part", "crate"}, {"at", {i, 9}}});
    }
    for (int run = 0; run < 25; ++run) {
        fs::path const recovery = folder / ("recovery " + std::to_string(run));
        writeText(file, large.dump(1));
        int ends[2] = {};
        ASSERT_EQ(::pipe(ends), 0);
        pid_t const child = ::fork();
        if (child == 0) {
            designUntilKilled(file, recovery, ends[1]);
        }
        ::close(ends[1]);
        int last = 0;
        int const wanted = static_cast<int>(random() % 30);
        while (last < wanted && ::read(ends[0], &last, sizeof last) == sizeof last) {
        }
        for (auto spins = random() % 3000000; spins > 0; --spins) { // lets the next steps begin
            asm volatile("");
        }
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status)) << "it did not end by itself";
        while (::read(ends[0], &last, sizeof last) == sizeof last) {
        }
        ::close(ends[0]);
        Json const saved = Json::parse(fileText(file), nullptr, false);
        ASSERT_TRUE(saved.is_object()) << "the file is whole";
        EXPECT_EQ(saved["objects"], large["objects"]);
        int found = numberIn(saved["title"].get<std::string>());
        for (Recovery const& left : findRecoveries(recovery)) {
            found = std::max(found, numberIn(left.title));
            EXPECT_EQ(recover(editData(), left).tree()["objects"], large["objects"]);
        }
        EXPECT_LE((last - found) * secondsPerStep, 2) << "of " << last << " steps";
    }
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

TEST(Autosave, ADamagedRecoveryIsMovedAsideAndTheLastGoodOneTaken) {
    fs::path const folder = testFolder();
    LevelDocument document = smallDocument();
    fs::path file;
    {
        Autosave autosave(folder / "recovery");
        for (char const* const title : {"first", "second"}) {
            document.run(setTitle(document.tree(), title));
            autosave.flush(document);
        }
        file = autosave.file();
        autosave.abandon();
    }
    for (std::uintmax_t const size : {fs::file_size(file) - 1, std::uintmax_t{20}, std::uintmax_t{0}}) {
        fs::resize_file(file, size);
        std::vector<DamagedFile> damaged;
        auto const found = findRecovery(folder / "recovery", {}, &damaged);
        ASSERT_TRUE(found) << size;
        EXPECT_EQ(found->title, "first");
        ASSERT_EQ(damaged.size(), 1U);
        EXPECT_EQ(fs::file_size(damaged[0].aside), size);
        EXPECT_EQ(findRecoveries(folder / "recovery").size(), 1U);
    }
    discard(*findRecovery(folder / "recovery", {}));
    EXPECT_TRUE(findRecoveries(folder / "recovery").empty());
}

TEST(Autosave, IsTriedAgainUntilItIsWritten) {
    fs::path const folder = testFolder();
    writeText(folder / "recovery", "a file, not a folder");
    LevelDocument document = smallDocument();
    document.run(setTitle(document.tree(), "x"));
    Autosave autosave(folder / "recovery");
    autosave.tick(document, 2);
    ASSERT_TRUE(autosave.error());
    EXPECT_EQ(autosave.error()->error(), ENOTDIR);
    EXPECT_EQ(autosave.error()->file(), folder / "recovery");
    fs::remove(folder / "recovery");
    autosave.tick(document, 0.5);
    EXPECT_TRUE(autosave.error()) << "not yet";
    autosave.tick(document, 0.5);
    EXPECT_FALSE(autosave.error());
    EXPECT_TRUE(fs::exists(autosave.file()));
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

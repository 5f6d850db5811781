// Recovery: the files that remain when a program ends without closing its document.
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/recovery/autosave.hpp"
#include "runtime/level/json/limits.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"
#include "tests/support/failing_calls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <random>
#include <sys/stat.h>
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

TEST(Autosave, IsOfferedForALevelWhosePathIsNotUtf8) {
    fs::path const folder = testFolder();
    fs::path const recovery = folder / "recovery";
    for (char const* const name : {"l\xe4vel.json", "l\xf6vel.json"}) {
        writeText(folder / name, smallLevel());
        LevelDocument document = LevelDocument::open(editData(), folder / name);
        Autosave autosave(recovery);
        document.run(setTitle(document.tree(), name[1] == '\xe4' ? "first" : "second"));
        autosave.flush(document);
        ASSERT_FALSE(autosave.error());
        autosave.abandon();
    }
    auto const found = findRecovery(recovery, folder / "l\xe4vel.json");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->title, "first");
    EXPECT_FALSE(found->changedSince);
    fs::remove_all(folder);
}

TEST(Autosave, ThatCannotBeReadIsTold) {
    fs::path const recovery = testFolder() / "recovery";
    fs::create_directories(recovery / "1-1.json"); // a folder in its place
    RecoveryTroubles troubles;
    EXPECT_TRUE(findRecoveries(recovery, &troubles).empty());
    ASSERT_EQ(troubles.notRead.size(), 1U);
    EXPECT_NE(std::string(troubles.notRead.front().what()).find("1-1.json"), std::string::npos);
    // A pipe in the place of the lock does not wait for its writer.
    ASSERT_EQ(::mkfifo((recovery / "1-1.lock").c_str(), 0600), 0);
    EXPECT_TRUE(findRecoveries(recovery, &troubles).empty());
    fs::remove_all(recovery);
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
        RecoveryTroubles troubles;
        auto const found = findRecovery(folder / "recovery", {}, &troubles);
        ASSERT_TRUE(found) << size;
        EXPECT_EQ(found->title, "first");
        ASSERT_EQ(troubles.damaged.size(), 1U);
        EXPECT_EQ(fs::file_size(troubles.damaged[0].aside), size);
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

// A recovery has the text of a level twice, quoted, so it may be larger than any other file of the kind. That
// one is read is seen by what is wrong with it, as good ones take long to be read.
TEST(Autosave, ReadsAndReplacesRecoveriesLargerThanALevelMayBe) {
    fs::path const recovery = testFolder() / "recovery";
    LevelDocument document = smallDocument();
    Autosave autosave(recovery);
    auto const keep = [&](char const* title) {
        document.run(setTitle(document.tree(), title));
        autosave.flush(document);
        ASSERT_FALSE(autosave.error()) << autosave.error()->what();
    };
    auto const enlarge = [&] { // with zeros that take no room
        fs::resize_file(autosave.file(), 0);
        fs::resize_file(autosave.file(), 2 * limits::fileSize);
    };
    keep("first");
    keep("second");
    enlarge();
    keep("third");
    fs::path const file = autosave.file();
    EXPECT_EQ(fs::file_size(file.string() + ".damaged-1"), 2 * limits::fileSize);
    keep("fourth");
    enlarge();
    autosave.abandon();
    RecoveryTroubles troubles;
    auto const found = findRecovery(recovery, {}, &troubles);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->title, "third") << "the last good one";
    ASSERT_EQ(troubles.damaged.size(), 1U);
    EXPECT_EQ(troubles.damaged[0].aside, file.string() + ".damaged-2");
    fs::remove_all(recovery);
}

/// A recovery file of a new level, changed so many hours ago.
void leaveRecovery(fs::path const& folder, std::string const& name, std::string const& title, int hours) {
    fs::path const file = folder / (name + ".json");
    writeText(file, Json{{"recovery", 1}, {"level", ""}, {"text", Json{{"title", title}}.dump()}}.dump());
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

std::vector<std::string> titlesOf(std::vector<Recovery> const& recoveries) {
    std::vector<std::string> titles;
    for (Recovery const& one : recoveries) {
        titles.push_back(one.title);
    }
    return titles;
}

TEST(Autosave, FindsTheNewestRecoveriesWhateverTheirNames) {
    fs::path const folder = testFolder();
    leaveRecovery(folder, "1", "oldest", 9);
    leaveRecovery(folder, "2", "newest", 1);
    leaveRecovery(folder, "3", "middle", 5);
    using Titles = std::vector<std::string>;
    EXPECT_EQ(titlesOf(findRecoveries(folder)), (Titles{"newest", "middle", "oldest"}));
    std::size_t const each = fs::file_size(folder / "2.json"); // all have the same size
    struct Case {
        RecoveryLimits most;
        Titles expected;
    };
    for (Case const& one :
         {Case{{.files = 2}, {"newest", "middle"}}, Case{{.files = 1}, {"newest"}},
          Case{{.bytes = each + 20}, {"newest", "middle"}}, // the text is shorter than its file
          Case{{.bytes = each}, {"newest"}}, Case{{.bytes = 0}, {"newest"}}}) {
        RecoveryTroubles troubles;
        EXPECT_EQ(titlesOf(findRecoveries(folder, &troubles, one.most)), one.expected);
        EXPECT_EQ(troubles.leftOut, 3 - one.expected.size());
    }
    EXPECT_EQ(findRecovery(folder, {})->title, "newest");
    for (char const* const title : {"newest", "middle", "oldest"}) { // the others come when it is gone
        auto const found = findRecovery(folder, {});
        ASSERT_TRUE(found);
        EXPECT_EQ(found->title, title);
        discard(*found);
    }
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST(Autosave, ReadsAThousandRecoveriesAtMost) {
    EXPECT_EQ(RecoveryLimits().files, 1000U);
    EXPECT_EQ(RecoveryLimits().bytes, 256U << 20U);
    fs::path const folder = testFolder();
    for (int i = 0; i < 1003; ++i) {
        leaveRecovery(folder, std::to_string(i), std::to_string(i), i);
    }
    RecoveryTroubles troubles;
    EXPECT_EQ(findRecoveries(folder, &troubles).size(), 1000U);
    EXPECT_EQ(troubles.leftOut, 3U);
    RecoveryTroubles ofAnother;
    EXPECT_FALSE(findRecovery(folder, folder / "another.json", &ofAnother));
    EXPECT_EQ(ofAnother.leftOut, 3U) << "it may be among them";
}

TEST(Autosave, LosesNothingWhereverItIsKilled) {
    fs::path const folder = testFolder();
    LevelDocument document = smallDocument();
    auto const titled = [&](char const* title) {
        document.run(setTitle(document.tree(), title));
        static_cast<void>(document.text());
    };
    fs::path const recovery = folder / "recovery";
    // The first recovery file of all, or a further version of it.
    for (bool const first : {true, false}) {
        int const killed = test::killedAtEachCall(
            [&] { fs::remove_all(recovery); },
            [&] {
                Autosave autosave(recovery);
                if (!first) {
                    test::FailingCalls whole; // is not killed
                    FileCallsReplaced const replaced(whole);
                    titled("before");
                    autosave.flush(document);
                }
                titled("now");
                autosave.flush(document);
                autosave.abandon();
            },
            [&](int at) {
                std::vector<Recovery> const found = findRecoveries(recovery);
                ASSERT_LE(found.size(), 1U) << at;
                ASSERT_TRUE(first || found.size() == 1) << at;
                for (Recovery const& one : found) {
                    EXPECT_TRUE(one.title == "now" || (!first && one.title == "before")) << at << one.title;
                    discard(one);
                }
                // Work goes on beside what was left behind.
                Autosave next(recovery);
                titled("next");
                next.flush(document);
                EXPECT_FALSE(next.error()) << at;
                next.abandon();
                EXPECT_EQ(titlesOf(findRecoveries(recovery)), std::vector<std::string>{"next"}) << at;
            });
        EXPECT_GT(killed, 8);
    }
}

TEST(Autosave, LosesNothingWhateverCallFails) {
    using Then = test::FailingCalls::Then;
    fs::path const recovery = testFolder() / "recovery";
    LevelDocument document = smallDocument();
    for (Then const then : {Then::failOnce, Then::failForEver}) {
        for (int at = 1;; ++at) {
            fs::remove_all(recovery);
            Autosave autosave(recovery);
            document.run(setTitle(document.tree(), "before " + std::to_string(at)));
            autosave.flush(document);
            std::string const before = document.text();
            document.run(setTitle(document.tree(), "now"));
            test::FailingCalls calls(then, at, ENOSPC);
            {
                FileCallsReplaced const replaced(calls);
                autosave.flush(document);
            }
            std::string const stored = Json::parse(fileText(autosave.file()))["text"].get<std::string>();
            EXPECT_TRUE(stored == document.text() || (autosave.error() && stored == before)) << at;
            if (autosave.error()) {
                EXPECT_TRUE(autosave.error()->error() == ENOSPC || autosave.error()->error() == EWOULDBLOCK)
                    << autosave.error()->what();
            }
            autosave.flush(document); // when there is room again
            EXPECT_FALSE(autosave.error()) << at;
            EXPECT_EQ(Json::parse(fileText(autosave.file()))["text"].get<std::string>(), document.text());
            bool const last = at > calls.calls();
            autosave.close();
            EXPECT_TRUE(fs::is_empty(recovery)) << at;
            if (last) {
                break;
            }
        }
    }
}

} // namespace
} // namespace trembler::edit

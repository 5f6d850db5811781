// Files that the player owns: after damage, failures of the disk, kills, and with several programs at once.
#include "runtime/file/kept_file.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "tests/support/failing_calls.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string const former = "{\"stars\": 1}\n";
std::string const good = "{\"stars\": 2, \"names\": [\"one\", \"two\"]}\n";
std::string const next = "{\"stars\": 3}\n";

class KeptFiles : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    static void put(fs::path const& path, std::string const& text) {
        std::ofstream(path, std::ios::binary) << text;
    }
    static std::string textOf(fs::path const& path) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    /// The file with its last good version, as after two writes.
    void begin() const {
        fs::remove_all(folder);
        fs::create_directories(folder);
        file.write(former);
        file.write(good);
    }
    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> all;
        for (auto const& entry : fs::directory_iterator(folder)) {
            all.insert(entry.path().filename().string());
        }
        return all;
    }

    fs::path const folder = fs::path(testing::TempDir()) / ("kept files " + std::to_string(::getpid()));
    KeptFile const file{folder / "it.json"};

private:
    CallsWithoutSync calls_;
    FileCallsReplaced const replaced_{calls_};
};

// Opening a pipe for writing would wait for a reader for ever.
TEST_F(KeptFiles, AreNotWrittenToDevicesAndPipes) {
    fs::path const pipe = folder / "pipe.json";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (fs::path const& other : {pipe, fs::path("/dev/null")}) {
        try {
            KeptFile(other).write(next);
            ADD_FAILURE() << other;
        } catch (OutputError const& error) {
            EXPECT_EQ(std::string(error.what()), other.string() + ": is no ordinary file; expected a file");
            EXPECT_EQ(error.file(), other);
        }
    }
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(KeptFiles, HoldAsManyValuesAsAFileMayHave) {
    auto const withValues = [](std::size_t values) { // the object and the list are two of them
        std::string text = "{\"a\":[1";
        text.reserve(2 * values + 10);
        for (std::size_t i = 3; i < values; ++i) {
            text += ",1";
        }
        return text + "]}";
    };
    EXPECT_TRUE(isWholeJson(withValues(limits::values)));
    std::string const tooMany = withValues(limits::values + 1);
    EXPECT_FALSE(isWholeJson(tooMany));
    begin();
    EXPECT_THROW(file.write(tooMany), OutputError) << "it could never be read";
    EXPECT_EQ(textOf(file.path()), good);
}

TEST_F(KeptFiles, KeepTheVersionBefore) {
    EXPECT_FALSE(file.read().text);
    EXPECT_FALSE(file.read().damaged);
    begin();
    EXPECT_EQ(file.read().text, good);
    EXPECT_FALSE(file.read().damaged);
    EXPECT_EQ(textOf(file.lastGood()), former);
    file.write(good);
    EXPECT_EQ(textOf(file.lastGood()), former) << "the same text is no new version";
    file.write(next);
    EXPECT_EQ(textOf(file.lastGood()), good);
    EXPECT_EQ(names(), (std::set<std::string>{"it.json", "it.json~"}));
    file.remove();
    EXPECT_TRUE(names().empty());
    EXPECT_FALSE(file.read().text);
    file.remove();
    KeptFile const deep(folder / "a" / "b" / "c.json");
    deep.write(good);
    EXPECT_EQ(deep.read().text, good);
}

TEST_F(KeptFiles, ThatAreCutAnywhereAreMovedAsideAndTheLastGoodOneIsTaken) {
    for (std::size_t size = 0; size <= good.size(); ++size) {
        begin();
        put(file.path(), good.substr(0, size));
        bool const whole = size + 1 >= good.size(); // without the line feed it still is
        KeptText const found = file.read();
        ASSERT_EQ(found.text, whole ? good.substr(0, size) : former) << size;
        ASSERT_EQ(found.damaged.has_value(), !whole) << size;
        if (!whole) {
            EXPECT_TRUE(found.damaged->lastTaken);
            EXPECT_EQ(textOf(found.damaged->aside), good.substr(0, size)) << "nothing of it is lost";
            KeptText const again = file.read();
            EXPECT_EQ(again.text, former);
            EXPECT_FALSE(again.damaged) << "it is reported once";
        }
        // Writing finds the damage, too.
        begin();
        put(file.path(), good.substr(0, size));
        file.write(next);
        EXPECT_EQ(file.read().text, next);
        EXPECT_EQ(textOf(file.lastGood()), whole ? good.substr(0, size) : former);
        EXPECT_EQ(names().contains("it.json.damaged-1"), !whole);
    }
}

TEST_F(KeptFiles, EachDamagedOneHasANameOfItsOwn) {
    for (std::string const& damage : {std::string(100, '\0'), std::string(), std::string("[1]"), good + good,
                                      std::string("\xff\xfe{}")}) {
        put(file.path(), damage);
        KeptText const found = file.read();
        EXPECT_FALSE(found.text);
        ASSERT_TRUE(found.damaged);
        EXPECT_FALSE(found.damaged->lastTaken) << "there is none";
        EXPECT_EQ(textOf(found.damaged->aside), damage);
        EXPECT_FALSE(fs::exists(file.path()));
    }
    EXPECT_EQ(names().size(), 5U);
    put(file.lastGood(), "{");
    put(file.path(), "{");
    EXPECT_FALSE(file.read().text) << "a last good one that is damaged is none";
    EXPECT_EQ(names().size(), 7U);
}

TEST_F(KeptFiles, ThatAreGoneAreTakenFromTheLastGoodOne) {
    begin();
    fs::remove(file.path());
    KeptText const found = file.read();
    EXPECT_EQ(found.text, former);
    ASSERT_TRUE(found.damaged);
    EXPECT_TRUE(found.damaged->gone);
    EXPECT_FALSE(found.inPlace());
    file.write(next);
    EXPECT_EQ(file.read().text, next);
    EXPECT_EQ(textOf(file.lastGood()), former);
}

TEST_F(KeptFiles, AreTheFormerOrTheNewOneAfterAKillBetweenAnyTwoCalls) {
    int const killed = killedAtEachCall([&] { begin(); }, [&] { file.write(next); },
                                        [&](int at) {
                                            KeptText const found = file.read();
                                            EXPECT_TRUE(found.text == good || found.text == next) << at;
                                            EXPECT_FALSE(found.damaged) << at;
                                            std::string const last = textOf(file.lastGood());
                                            EXPECT_TRUE(last == former || last == good) << at;
                                            file.write("{\"after\": 1}");
                                            EXPECT_EQ(file.read().text, "{\"after\": 1}") << at;
                                            EXPECT_EQ(names(), (std::set<std::string>{"it.json", "it.json~"}))
                                                << "what was left behind is removed, " << at;
                                        });
    EXPECT_GT(killed, 10);
    // While a damaged one is moved aside, and the last good one put in its place.
    killedAtEachCall(
        [&] {
            begin();
            put(file.path(), "{\"st");
        },
        [&] { static_cast<void>(file.read()); },
        [&](int at) {
            EXPECT_EQ(file.read().text, former) << at;
            std::set<std::string> kept;
            for (std::string const& name : names()) {
                kept.insert(textOf(folder / name));
            }
            EXPECT_TRUE(kept.contains("{\"st")) << "the damaged one is still there, " << at;
            EXPECT_EQ(file.read().text, former) << at;
        });
    // The first write of all.
    killedAtEachCall([&] { fs::remove_all(folder); }, [&] { file.write(next); },
                     [&](int at) {
                         KeptText const found = file.read();
                         EXPECT_TRUE(!found.text || found.text == next) << at;
                         EXPECT_FALSE(found.damaged) << at;
                     });
}

TEST_F(KeptFiles, LoseNothingWhateverCallFails) {
    using Then = FailingCalls::Then;
    for (bool const damaged : {false, true}) {
        for (int const error : {ENOSPC, EACCES}) {
            for (Then const then : {Then::failOnce, Then::failForEver}) {
                for (int at = 1;; ++at) {
                    begin();
                    if (damaged) {
                        put(file.path(), "{\"st");
                    }
                    std::string const before = damaged ? former : good;
                    FailingCalls calls(then, at, error);
                    bool written = false;
                    try {
                        FileCallsReplaced const replaced(calls);
                        file.write(next);
                        written = true;
                    } catch (OutputError const& reason) {
                        EXPECT_TRUE(reason.error() == error || reason.error() == EWOULDBLOCK)
                            << reason.what();
                        EXPECT_FALSE(reason.file().empty());
                    }
                    KeptText const found = file.read();
                    // After its folder could not be synchronised, it is the new one, or will be.
                    EXPECT_TRUE(found.text == next || (!written && found.text == before))
                        << "call " << at << " of " << calls.calls() << ": " << found.text.value_or("none");
                    if (damaged) {
                        std::set<std::string> kept;
                        for (std::string const& name : names()) {
                            kept.insert(textOf(folder / name));
                        }
                        EXPECT_TRUE(kept.contains("{\"st")) << at;
                    }
                    file.write(next); // and when the disk works again, it is written
                    EXPECT_EQ(file.read().text, next);
                    if (at > calls.calls()) {
                        EXPECT_TRUE(written);
                        break;
                    }
                }
            }
        }
    }
}

TEST_F(KeptFiles, AreSynchronisedBeforeTheyGetTheirName) {
    begin();
    FailingCalls calls;
    {
        FileCallsReplaced const replaced(calls);
        file.write(next);
    }
    auto const& log = calls.log();
    auto const placeOf = [&](std::string const& what, bool last = false) {
        auto const at = last ? std::find_if(
                                   log.rbegin(), log.rend(),
                                   [&](auto const& one) {
                                       return one.starts_with(what);
                                   }).base() -
                                   1
                             : std::find_if(log.begin(), log.end(),
                                            [&](auto const& one) { return one.starts_with(what); });
        return at - log.begin();
    };
    auto const isName = std::find_if(log.begin(), log.end(), [](std::string const& one) {
        return one.starts_with("rename") && one.ends_with("-> it.json");
    });
    ASSERT_NE(isName, log.end());
    auto const named = isName - log.begin();
    EXPECT_LT(placeOf("write", true), placeOf("fsync file"));
    EXPECT_LT(placeOf("fsync file"), named);
    EXPECT_GT(placeOf("fsync folder", true), named);
}

TEST_F(KeptFiles, AreWrittenWholeByAnyNumberOfWrites) {
    FailingCalls calls;
    calls.slow = true;
    FileCallsReplaced const replaced(calls);
    file.write(good);
    EXPECT_EQ(file.read().text, good);
    EXPECT_GT(static_cast<std::size_t>(calls.calls()), good.size());
}

TEST_F(KeptFiles, WorkOnFileSystemsOfAllKinds) {
    for (FailingCalls::Lacks const& lacks : fileSystems()) {
        FailingCalls calls;
        calls.lacks = lacks;
        FileCallsReplaced const replaced(calls);
        begin();
        EXPECT_EQ(textOf(file.lastGood()), former);
        put(file.path(), "");
        KeptText const found = file.read();
        EXPECT_EQ(found.text, former);
        EXPECT_EQ(names(), (std::set<std::string>{"it.json", "it.json.damaged-1", "it.json~"}));
        put(file.path(), "{");
        file.write(next);
        EXPECT_EQ(file.read().text, next);
        EXPECT_EQ(names(),
                  (std::set<std::string>{"it.json", "it.json.damaged-1", "it.json.damaged-2", "it.json~"}));
    }
}

TEST_F(KeptFiles, AreWholeAfterAKillOnFileSystemsOfAllKinds) {
    for (FailingCalls::Lacks const& lacks : fileSystems()) {
        for (int at = 1;; ++at) {
            ASSERT_LT(at, 1000);
            begin();
            bool const ended = inProcess([&] {
                FailingCalls calls(FailingCalls::Then::kill, at);
                calls.lacks = lacks;
                FileCallsReplaced const replaced(calls);
                file.write(next);
                return true;
            });
            KeptText const found = file.read();
            EXPECT_TRUE(found.text == good || found.text == next) << at;
            EXPECT_FALSE(found.damaged) << at;
            if (ended) {
                break;
            }
        }
    }
}

TEST_F(KeptFiles, HaveALimitThatHoldsForReadingAndWriting) {
    KeptFile const small(file.path(), isWholeJson, good.size());
    small.write(good);
    EXPECT_EQ(small.read().text, good);
    try {
        small.write(good + " ");
        FAIL() << "it could not be read again";
    } catch (OutputError const& error) {
        EXPECT_EQ(error.error(), EFBIG);
        EXPECT_EQ(error.file(), file.path());
    }
    EXPECT_EQ(textOf(file.path()), good);
    put(file.path(), good + " ");
    EXPECT_THROW(static_cast<void>(small.read()), InputError);
    EXPECT_EQ(names(), (std::set<std::string>{"it.json"}));
}

TEST_F(KeptFiles, StayWhereTheyAreWhenTheyAreOnlyLookedAt) {
    begin();
    put(file.path(), "{");
    KeptText const found = file.look();
    EXPECT_EQ(found.text, former);
    ASSERT_TRUE(found.damaged);
    EXPECT_TRUE(found.damaged->lastTaken);
    EXPECT_EQ(textOf(file.path()), "{");
    EXPECT_EQ(names(), (std::set<std::string>{"it.json", "it.json~"}));
}

TEST_F(KeptFiles, OnAFullDiskStayAsTheyWere) {
    begin();
    // The system's own limit: what is longer than that cannot be written.
    EXPECT_TRUE(inProcess([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        ::rlimit const most{10, 10};
        ::setrlimit(RLIMIT_FSIZE, &most);
        try {
            file.write(next);
        } catch (OutputError const& error) {
            return error.error() == EFBIG;
        }
        return false;
    }));
    EXPECT_EQ(file.read().text, good);
    EXPECT_EQ(names(), (std::set<std::string>{"it.json", "it.json~"}));
}

TEST_F(KeptFiles, ThatCannotBeReadAreNotReplaced) {
    fs::create_directories(file.path());
    EXPECT_THROW(static_cast<void>(file.read()), InputError);
    EXPECT_THROW(file.write(next), OutputError);
    EXPECT_TRUE(fs::is_directory(file.path()));
    KeptFile const behindAFile(folder / "it" / "x.json");
    put(folder / "it", "not a folder");
    EXPECT_FALSE(behindAFile.read().text);
    try {
        behindAFile.write(next);
        FAIL();
    } catch (OutputError const& error) {
        EXPECT_EQ(error.error(), ENOTDIR);
    }
}

TEST_F(KeptFiles, WhatIsGivenUpChangesNothing) {
    begin();
    put(file.path(), "damaged");
    auto const before = names();
    KeptText const found = file.change([](KeptText const&) { return std::nullopt; });
    EXPECT_EQ(found.text, former);
    EXPECT_THROW(file.change([](KeptText const&) -> std::optional<std::string> { throw 7; }), int);
    EXPECT_EQ(names(), before);
    EXPECT_EQ(textOf(file.path()), "damaged");
}

TEST_F(KeptFiles, ThatSeveralProgramsChangeAtOnceLoseNoChange) {
    constexpr int programs = 3;
    constexpr int changes = 15;
    auto const work = [&](int program) {
        for (int i = 0; i < changes;) {
            try {
                file.change([&](KeptText const& there) {
                    Json all = there.text ? Json::parse(*there.text) : Json::object();
                    all[std::to_string(program) + "." + std::to_string(i)] = true;
                    return all.dump();
                });
                ++i;
            } catch (OutputError const& busy) {
                if (busy.error() != EWOULDBLOCK) {
                    throw;
                }
            }
        }
    };
    std::vector<::pid_t> children;
    for (int program = 0; program < programs; ++program) {
        ::pid_t const child = ::fork();
        if (child == 0) {
            try {
                work(program);
                ::_exit(0);
            } catch (...) {
                ::_exit(1);
            }
        }
        children.push_back(child);
    }
    for (::pid_t const child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    EXPECT_EQ(Json::parse(*file.read().text).size(), static_cast<std::size_t>(programs * changes));
    EXPECT_EQ(names(), (std::set<std::string>{"it.json", "it.json~"}));
}

TEST_F(KeptFiles, NewFilesOfSeveralProgramsHaveDifferentNames) {
    constexpr int programs = 3;
    constexpr int each = 10;
    std::vector<::pid_t> children;
    for (int program = 0; program < programs; ++program) {
        ::pid_t const child = ::fork();
        if (child == 0) {
            for (int i = 0; i < each; ++i) {
                static_cast<void>(writeNewFile(
                    folder, [](int number) { return "new-" + std::to_string(number); },
                    std::to_string(program) + "." + std::to_string(i)));
            }
            ::_exit(0);
        }
        children.push_back(child);
    }
    for (::pid_t const child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
    }
    std::set<std::string> texts;
    for (std::string const& name : names()) {
        texts.insert(textOf(folder / name));
    }
    EXPECT_EQ(texts.size(), static_cast<std::size_t>(programs * each));
    EXPECT_EQ(names().size(), static_cast<std::size_t>(programs * each));
}

} // namespace
} // namespace trembler::test

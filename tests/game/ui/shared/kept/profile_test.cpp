// The profile file: saved, read, damaged, and shared by several instances.
#include "game/ui/shared/kept/profile.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"
#include "tests/support/failing_calls.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <random>
#include <set>
#include <string_view>
#include <vector>

namespace trembler::ui::test {
namespace {

class ProfileFile : public testing::Test {
protected:
    ProfileFile() { std::filesystem::remove_all(folder); }

    [[nodiscard]] std::filesystem::path written(std::string const& text) const {
        std::filesystem::create_directories(folder);
        auto const file = folder / "profile.json";
        std::ofstream(file) << text;
        return file;
    }

    std::filesystem::path const folder = testFolder() / "profile";
};

TEST_F(ProfileFile, KeysAreKeptBesideTheRest) {
    auto const file = folder / "deep" / "profile.json";
    {
        Profile profile(file);
        profile.setKeys({{"run", {"Ctrl+R", "F5"}}, {"hint", {}}});
        profile.markSolved("a level");
        Settings settings = profile.settings();
        settings.volume = 30;
        settings.touches = 20;
        settings.clearColours = true;
        profile.setSettings(settings);
    }
    Profile const kept(file);
    EXPECT_EQ(kept.keys(), (StatedKeys{{"run", {"Ctrl+R", "F5"}}, {"hint", {}}}));
    EXPECT_TRUE(kept.troubles().empty());
    EXPECT_TRUE(kept.solved("a level"));
    EXPECT_EQ(kept.settings().volume, 30);
    EXPECT_EQ(kept.settings().touches, 20);
    EXPECT_TRUE(kept.settings().clearColours);
}

TEST_F(ProfileFile, ADamagedEntryIsReportedAndTheOthersAreKept) {
    Profile const profile(written(
        R"({"volume": 20, "keys": {"run": "Space", "hint": ["F2"], "cut": [1], "names": null}, "solved": ["x"]})"));
    EXPECT_EQ(profile.keys(), (StatedKeys{{"hint", {"F2"}}}));
    EXPECT_EQ(profile.troubles().size(), 3U);
    EXPECT_EQ(profile.settings().volume, 20);
    EXPECT_TRUE(profile.solved("x"));
    for (char const* keys : {"[]", "7", "\"Space\"", "null"}) {
        Profile const none(written(std::string(R"({"volume": 20, "keys": )") + keys + "}"));
        EXPECT_TRUE(none.keys().empty()) << keys;
        EXPECT_EQ(none.troubles().size(), 1U) << keys;
        EXPECT_EQ(none.settings().volume, 20) << keys;
    }
}

TEST_F(ProfileFile, DamagedStarsAreNamedAndStay) {
    auto const file = written(R"({"progress": {"plain": 5, "x": "solved", "good": {"kinds": []}}})");
    {
        Profile profile(file);
        ASSERT_EQ(profile.troubles().size(), 2U);
        EXPECT_NE(profile.troubles()[0].find("plain"), std::string::npos) << profile.troubles()[0];
        EXPECT_NE(profile.troubles()[1].find("\"x\""), std::string::npos) << profile.troubles()[1];
        EXPECT_TRUE(profile.solved("good"));
        profile.markSolved("x");
    }
    auto const all = nlohmann::json::parse(textOfFile(file));
    EXPECT_EQ(all["progress"]["plain"], 5) << "a newer version may understand it";
    EXPECT_TRUE(all["progress"]["x"].is_object());
    std::string many;
    for (int i = 0; i < 1000; ++i) {
        many += (many.empty() ? "" : ", ") + ("\"" + std::to_string(i) + "\": 0");
    }
    Profile const profile(written(R"({"progress": {)" + many + "}}"));
    ASSERT_EQ(profile.troubles().size(), 4U);
    EXPECT_NE(profile.troubles()[3].find("997"), std::string::npos) << profile.troubles()[3];
}

TEST_F(ProfileFile, TheGameReportsTheErrorAndContinues) {
    auto const file = written(R"({"keys": {"hint": ["P"], "run": ["F5"], "save": 3}})");
    Player player({1280, 720}, file);
    EXPECT_EQ(player.app().context().toasts.count(), 2U);
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_h);
    EXPECT_EQ(player.play().hintsShown(), 1U) << "P belongs to another command, so H still is the key";
    player.key(SDLK_SPACE);
    EXPECT_EQ(player.session().mode(), SessionMode::building);
    player.key(SDLK_F5);
    EXPECT_EQ(player.session().mode(), SessionMode::running);
}

TEST_F(ProfileFile, ThatIsCutAnywhereLosesAtMostTheLastChange) {
    auto const file = folder / "profile.json";
    std::filesystem::create_directories(folder);
    std::string whole;
    std::string last;
    {
        Profile profile(file);
        profile.markSolved("one");
        Settings settings;
        settings.volume = 11;
        profile.setSettings(settings);
        last = textOfFile(file);
        profile.markSolved("two");
        whole = textOfFile(file);
    }
    for (std::size_t size = 0; size < whole.size() - 1; ++size) {
        for (auto const& entry : std::filesystem::directory_iterator(folder)) {
            std::filesystem::remove(entry.path());
        }
        std::ofstream(file) << whole.substr(0, size);
        std::ofstream(file.string() + "~") << last;
        Profile profile(file);
        ASSERT_TRUE(profile.solved("one")) << size;
        EXPECT_EQ(profile.settings().volume, 11);
        ASSERT_EQ(profile.troubles().size(), 1U);
        EXPECT_NE(profile.troubles()[0].find("profile.json.damaged-1"), std::string::npos)
            << profile.troubles()[0];
        EXPECT_EQ(textOfFile(file.string() + ".damaged-1"), whole.substr(0, size));
        profile.markSolved("three");
        EXPECT_EQ(textOfFile(file.string() + ".damaged-1"), whole.substr(0, size)) << "never overwritten";
        Profile const again(file);
        EXPECT_TRUE(again.troubles().empty());
        EXPECT_TRUE(again.solved("one") && again.solved("three")) << size;
    }
}

TEST_F(ProfileFile, WithoutALastGoodOneADamagedOneIsKeptAside) {
    auto const file = written("");
    Profile profile(file);
    ASSERT_EQ(profile.troubles().size(), 1U);
    profile.markSolved("x");
    EXPECT_TRUE(std::filesystem::exists(file.string() + ".damaged-1"));
    EXPECT_TRUE(Profile(file).solved("x"));
    // Progress that is no object cannot be added to: that is damage, too.
    std::ofstream(file) << R"({"volume": 20, "progress": 7})";
    EXPECT_EQ(Profile(file).troubles().size(), 1U);
    EXPECT_EQ(textOfFile(file.string() + ".damaged-2"), R"({"volume": 20, "progress": 7})");
}

TEST_F(ProfileFile, OfTwoInstancesMerges) {
    auto const file = folder / "profile.json";
    std::int64_t now = 1'000'000;
    auto const clock = [&now] { return now += 10; };
    Profile first(file, clock);
    Profile second(file, clock);
    first.markSolved("a");
    second.markSolved("b");
    EXPECT_TRUE(second.solved("a")) << "it is seen when the file is written";
    first.addKind("a", {{"bar"}, {}, {"x"}});
    second.addKind("a", {{"ball"}, {}, {"y"}});
    // Each setting by itself, whichever instance writes last.
    Settings settings = first.settings();
    settings.volume = 10;
    first.setSettings(settings);
    settings = second.settings();
    settings.language = "de";
    second.setSettings(settings);
    first.setKeys({{"run", {"F5"}}});
    second.setKeys({{"hint", {"F2"}}});
    second.setKeys({{"hint", {"F2"}}, {"run", {"F6"}}});
    first.setKeys({});
    first.markSolved("c");
    second.markSolved("d");
    Profile const all(file);
    for (char const* level : {"a", "b", "c", "d"}) {
        EXPECT_TRUE(all.solved(level)) << level;
    }
    EXPECT_EQ(all.progress().of("a").stars(), 2);
    EXPECT_EQ(all.settings().volume, 10) << "the second never chose one";
    EXPECT_EQ(all.settings().language, "de");
    EXPECT_EQ(all.keys(), (StatedKeys{{"hint", {"F2"}}})) << "the first set 'run' back after all";
    EXPECT_TRUE(all.troubles().empty());
}

TEST_F(ProfileFile, TheLaterChoiceStaysWhateverTheClockSaid) {
    auto const file = written(R"({"volume": 40, "changed_at": {"volume": 999999999999999, "names": "x"}})");
    Profile profile(file, [] { return 5; });
    EXPECT_EQ(profile.settings().volume, 40);
    for (int const volume : {30, 20, 10}) {
        Settings settings = profile.settings();
        settings.volume = volume;
        profile.setSettings(settings);
        EXPECT_EQ(Profile(file).settings().volume, volume);
    }
}

TEST_F(ProfileFile, AllOrdersOfAddingGiveTheSame) {
    std::mt19937 random(7);
    auto const any = [&](std::uint32_t below) { return static_cast<std::uint32_t>(random() % below); };
    for (int round = 0; round < 200; ++round) {
        std::vector<TimedValues> values(3);
        std::vector<CampaignProgress> progress(3);
        for (std::size_t i = 0; i < 3; ++i) {
            for (char const* const name : {"volume", "keys.run", "keys.hint", "language"}) {
                if (any(2) == 0) {
                    bool const keys = std::string_view(name).starts_with("keys.");
                    nlohmann::ordered_json value;
                    if (!keys || any(3) > 0) {
                        value = keys ? nlohmann::ordered_json::array({"F" + std::to_string(1 + any(3))})
                                     : nlohmann::ordered_json(any(4));
                    }
                    values[i][name] = {value, static_cast<std::int64_t>(1 + any(4))};
                }
            }
            for (std::uint32_t level = any(4); level > 0; --level) {
                std::string const id = std::to_string(any(3));
                progress[i].markSolved(id);
                progress[i].addKind(id, {{std::to_string(any(3))}, {}, {std::to_string(any(2))}});
            }
        }
        std::vector<std::size_t> order{0, 1, 2};
        std::set<std::string> results;
        do {
            nlohmann::ordered_json all = nlohmann::ordered_json::object();
            for (std::size_t const i : order) {
                all = withAdded(std::move(all), values[i], progress[i]);
            }
            auto const read = readProfile(all.dump());
            for (CampaignProgress const& one : progress) {
                for (char const* id : {"0", "1", "2"}) {
                    EXPECT_GE(read.progress.of(id).stars(), one.of(id).stars()) << "stars only grow";
                }
            }
            nlohmann::json stated{{"volume", settingsOf(read.values).volume}, {"keys", keysOf(read.values)}};
            results.insert(stated.dump());
            EXPECT_EQ(withAdded(all, values[order[0]], progress[order[0]]), all) << "once is enough";
        } while (std::next_permutation(order.begin(), order.end()));
        EXPECT_EQ(results.size(), 1U) << *results.begin() << *results.rbegin();
    }
}

TEST_F(ProfileFile, WhatTheProgramDoesNotKnowStays) {
    auto const file = written(
        R"({"later": {"x": [1]}, "volume": "loud", "keys": {"run": 7}, "solved": ["old"],
            "progress": {"a": {"kinds": [], "medal": true}, "b": 3}})");
    Profile profile(file);
    EXPECT_EQ(profile.troubles().size(), 3U) << "the volume, the keys and the stars of b";
    EXPECT_TRUE(profile.solved("old") && profile.solved("a"));
    profile.markSolved("c");
    auto const all = nlohmann::json::parse(textOfFile(file));
    EXPECT_EQ(all["later"]["x"][0], 1);
    EXPECT_EQ(all["volume"], "loud") << "until the player chooses one";
    EXPECT_EQ(all["keys"]["run"], 7);
    EXPECT_EQ(all["progress"]["a"]["medal"], true);
    EXPECT_EQ(all["progress"]["b"], 3);
    Settings settings = profile.settings();
    settings.volume = 12;
    profile.setSettings(settings);
    Profile const again(file);
    EXPECT_EQ(again.settings().volume, 12);
    EXPECT_TRUE(again.solved("old") && again.solved("c"));
}

TEST_F(ProfileFile, SurvivesAKillBetweenAnyTwoCalls) {
    auto const file = folder / "profile.json";
    int const killed = trembler::test::killedAtEachCall(
        [&] {
            std::filesystem::remove_all(folder);
            Profile profile(file);
            profile.markSolved("a");
            profile.markSolved("b");
        },
        [&] {
            Profile profile(file);
            profile.markSolved("c");
            Settings settings;
            settings.volume = 3;
            profile.setSettings(settings);
        },
        [&](int at) {
            Profile const left(file);
            EXPECT_TRUE(left.solved("a") && left.solved("b")) << at;
            EXPECT_TRUE(left.settings().volume == 80 || left.solved("c")) << at;
            EXPECT_TRUE(left.troubles().empty()) << at;
        });
    EXPECT_GT(killed, 20);
}

TEST_F(ProfileFile, OfProgramsThatPlayAtTheSameTimeHasAllStars) {
    auto const file = folder / "profile.json";
    constexpr int programs = 3;
    constexpr int levels = 8;
    std::vector<::pid_t> children;
    for (int program = 0; program < programs; ++program) {
        ::pid_t const child = ::fork();
        if (child == 0) {
            Profile profile(file);
            for (int level = 0; level < levels; ++level) {
                profile.markSolved(std::to_string(program) + "/" + std::to_string(level));
            }
            while (profile.unwritten()) { // the others hold it
                profile.finish();
            }
            ::_exit(0);
        }
        children.push_back(child);
    }
    for (::pid_t const child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    Profile const all(file);
    for (int program = 0; program < programs; ++program) {
        for (int level = 0; level < levels; ++level) {
            EXPECT_TRUE(all.solved(std::to_string(program) + "/" + std::to_string(level)));
        }
    }
}

TEST_F(ProfileFile, ThatCannotBeWrittenIsTriedAgain) {
    std::filesystem::create_directories(folder.parent_path());
    std::ofstream(folder) << "a file where the folder should be";
    Profile profile(folder / "profile.json");
    EXPECT_FALSE(profile.unwritten());
    profile.markSolved("x");
    ASSERT_TRUE(profile.unwritten());
    EXPECT_EQ(profile.unwritten()->error(), ENOTDIR);
    std::filesystem::remove(folder);
    profile.pass(Profile::patience / 2);
    EXPECT_TRUE(profile.unwritten()) << "not yet";
    profile.pass(Profile::patience);
    EXPECT_FALSE(profile.unwritten());
    EXPECT_TRUE(Profile(folder / "profile.json").solved("x"));
    // What cannot be read is not replaced.
    std::filesystem::remove(folder / "profile.json");
    std::filesystem::remove(folder / "profile.json~");
    std::filesystem::create_directories(folder / "profile.json");
    Profile unreadable(folder / "profile.json");
    EXPECT_EQ(unreadable.troubles().size(), 1U);
    unreadable.markSolved("y");
    EXPECT_TRUE(unreadable.unwritten());
}

} // namespace
} // namespace trembler::ui::test

#include "lua/interaction/allowed_limits.hpp"
#include "lua/mods/trust.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <unistd.h>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

class TrustedMods : public testing::Test {
protected:
    TrustedMods() : folder_(fs::temp_directory_path() / ("trembler-trust-" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
    }
    ~TrustedMods() override { fs::remove_all(folder_); }

    [[nodiscard]] fs::path file() const { return folder_ / "trembler" / "mods.json"; }
    void write(std::string const& text) const {
        fs::create_directories(file().parent_path());
        std::ofstream(file()) << text;
    }
    static Mod modNamed(std::string const& name, bool bundled = false) {
        Mod mod;
        mod.name = name;
        mod.bundled = bundled;
        mod.interactions.resize(2);
        return mod;
    }

    fs::path folder_;
};

TEST_F(TrustedMods, AreNoneWithoutAFile) {
    Problems problems;
    ModSettings const settings = readModSettings(file(), problems);
    EXPECT_EQ(problems.count(), 0U);
    EXPECT_TRUE(settings.trusted.empty());
    EXPECT_EQ(settings.most.instructions, ScriptLimits::greatest().instructions);
}

TEST_F(TrustedMods, AreInTheFileOfSettings) {
    write("{\"trusted\": [\"wind\", \"rain\"], \"most\": {\"instructions\": 400000}}");
    Problems problems;
    ModSettings const settings = readModSettings(file(), problems);
    EXPECT_EQ(problems.count(), 0U);
    EXPECT_EQ(settings.trusted, (std::set<std::string, std::less<>>{"rain", "wind"}));
    EXPECT_EQ(settings.most.instructions, 400'000U);
    EXPECT_EQ(settings.most.calls, ScriptLimits::greatest().calls);
}

TEST_F(TrustedMods, AreNotReadFromAFileThatIsWrong) {
    for (std::string const text :
         {"[", "[]", "{\"trusted\": 3}", "{\"trusted\": [3]}", "{\"most\": {\"instructions\": -1}}",
          "{\"most\": {\"instruction\": 1}}", "{\"trust\": []}"}) {
        write(text);
        Problems problems;
        EXPECT_TRUE(readModSettings(file(), problems).trusted.empty()) << text;
        EXPECT_GT(problems.count(), 0U) << text;
    }
}

TEST_F(TrustedMods, AreThoseOfTheProgramOfThePlayerAndOfTheCommandLine) {
    std::vector<Mod> mods{modNamed("bundled", true), modNamed("allowed"), modNamed("named-here"),
                          modNamed("other")};
    ModSettings settings;
    settings.trusted = {"allowed"};
    trustForThisRun({"named-here"});
    applyTrust(mods, settings);
    for (Mod const& mod : mods) {
        for (Manifest const& manifest : mod.interactions) {
            EXPECT_EQ(manifest.trust, mod.name == "other" ? Trust::untrusted : Trust::trusted) << mod.name;
        }
    }
}

// The author of a mod beside a level may have given it the name of a mod that the player trusts.
TEST_F(TrustedMods, AreNoneThatCameWithALevel) {
    std::vector<Mod> mods{modNamed("trusted-elsewhere"), modNamed("trusted-elsewhere")};
    mods.front().besideLevel = true;
    ModSettings settings;
    settings.trusted = {"trusted-elsewhere"};
    applyTrust(mods, settings);
    EXPECT_EQ(mods.front().interactions.front().trust, Trust::untrusted);
    EXPECT_EQ(mods.back().interactions.front().trust, Trust::trusted);
}

TEST_F(TrustedMods, CannotRaiseTheirLimitsThemselves) {
    std::string const script =
        "return interaction { name = \"Dynamics <- A\", calls = \"Dynamics\", reads = { \"Mass\" }, "
        "each = { \"Mass\" }, limits = { instructions = 300000 }, apply = function() end }";
    Problems refused;
    (void)readManifest(script, "a.lua", refused);
    EXPECT_EQ(refused.count(), 1U);
    ScriptLimits more = ScriptLimits::greatest();
    more.instructions = 400'000;
    allowLimits(more);
    Problems taken;
    EXPECT_EQ(readManifest(script, "a.lua", taken).limits.instructions, 300'000U);
    EXPECT_EQ(taken.count(), 0U);
    allowLimits(ScriptLimits::greatest());
}

} // namespace
} // namespace trembler::lua

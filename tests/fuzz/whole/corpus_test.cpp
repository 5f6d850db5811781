// The fuzzers' targets without libFuzzer: every input that is kept, and some random ones, the same in every
// run.
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;
using Target = void (*)(std::string_view);

std::vector<fs::path> filesOf(fs::path const& folder) {
    std::vector<fs::path> all;
    for (auto const& entry :
         fs::recursive_directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / "tests" / folder)) {
        if (entry.is_regular_file()) {
            all.push_back(entry.path());
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::string bytesOf(fs::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void replay(fs::path const& folder, Target target) {
    auto const files = filesOf(folder);
    EXPECT_FALSE(files.empty());
    for (fs::path const& file : files) {
        EXPECT_NO_THROW(target(bytesOf(file))) << file;
    }
}

/// TREMBLER_FUZZ=50 tries fifty times as many; 0.1 a tenth.
int times(int usual) {
    char const* const factor = std::getenv("TREMBLER_FUZZ");
    return std::max(3, static_cast<int>(usual * (factor == nullptr ? 1 : std::atof(factor))));
}

TEST(FuzzCorpus, OfScriptTextHolds) {
    replay("fuzz/corpus/script_text", fuzzScriptText);
}

TEST(FuzzCorpus, OfHostileScriptsHolds) {
    replay("lua/hostile", fuzzScriptText);
}

TEST(FuzzCorpus, OfCallArgumentsHolds) {
    replay("fuzz/corpus/call_arguments", fuzzCallArguments);
}

TEST(FuzzedCalls, OfRandomBytesHold) {
    std::mt19937_64 random(4242);
    for (int i = 0; i < times(60); ++i) {
        std::string bytes(40 + random() % 300, '\0');
        std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random()); });
        EXPECT_NO_THROW(fuzzCallArguments(bytes)) << scriptOfCalls(bytes);
    }
}

// If calls were refused, the fuzzer would test nothing.
TEST(FuzzedCalls, AreAcceptedWhateverTheBytes) {
    std::mt19937_64 random(17);
    for (int i = 0; i < 30; ++i) {
        std::string bytes(random() % 200, '\0');
        std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random()); });
        EXPECT_TRUE(playScript(scriptOfCalls(bytes), 1, 1).accepted) << scriptOfCalls(bytes);
    }
}

// Cut, doubled and mixed texts of the corpus: most are not Lua, which must only be reported.
TEST(FuzzedTexts, OfMixedScriptsHold) {
    std::vector<std::string> texts;
    for (char const* const folder : {"fuzz/corpus/script_text", "lua/hostile"}) {
        for (fs::path const& file : filesOf(folder)) {
            texts.push_back(bytesOf(file));
        }
    }
    std::mt19937_64 random(99);
    auto const any = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
    for (int i = 0; i < times(300); ++i) {
        std::string const& one = texts[any(texts.size())];
        std::string const& other = texts[any(texts.size())];
        std::string mixed = one.substr(0, any(one.size() + 1)) + other.substr(any(other.size() + 1));
        if (!mixed.empty() && i % 3 == 0) {
            mixed[any(mixed.size())] = static_cast<char>(random());
        }
        EXPECT_NO_THROW(fuzzScriptText(mixed)) << mixed;
    }
}

} // namespace
} // namespace trembler::lua

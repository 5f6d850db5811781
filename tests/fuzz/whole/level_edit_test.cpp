// The corpus of the level editor, and levels of the pack with random changes of their text and random
// commands.
#include "tests/fuzz/targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> keptEdits() {
    std::vector<fs::path> files;
    for (auto const& entry :
         fs::directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / "tests/fuzz/corpus/level_edit")) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> all;
    for (fs::path const& file : files) {
        std::ifstream in(file, std::ios::binary);
        all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return all;
}

TEST(FuzzCorpus, OfLevelEditHolds) {
    auto const all = keptEdits();
    EXPECT_FALSE(all.empty());
    for (std::string const& bytes : all) {
        EXPECT_NO_THROW(fuzzLevelEdit(bytes)) << bytes;
    }
}

TEST(FuzzedEdits, OfChangedLevelsHold) {
    auto const all = keptEdits();
    std::mt19937_64 random(71);
    char const* const factor = std::getenv("TREMBLER_FUZZ");
    int const times = std::max(3, static_cast<int>(60 * (factor == nullptr ? 1 : std::atof(factor))));
    for (int i = 0; i < times; ++i) {
        std::string const& kept = all[random() % all.size()];
        std::string bytes = kept.substr(0, kept.find('\0'));
        for (int change = i % 3; change > 0 && !bytes.empty(); --change) {
            // A digit, a quotation mark, a bracket: many are still JSON.
            bytes[random() % bytes.size()] = "0123456789\"[]{}-.e "[random() % 19];
        }
        bytes += '\0';
        for (auto length = random() % 200; length > 0; --length) {
            bytes += static_cast<char>(random());
        }
        EXPECT_NO_THROW(fuzzLevelEdit(bytes)) << bytes;
    }
}

} // namespace
} // namespace trembler::edit

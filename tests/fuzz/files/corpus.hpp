// The kept inputs of a target, and random changes of them, the same in every run.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::files {

inline std::vector<std::string> keptInputs(std::string const& target) {
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(TREMBLER_SOURCE_DIR) /
                                                                 "tests/fuzz/corpus" / target)) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> all;
    for (std::filesystem::path const& file : files) {
        std::ifstream in(file, std::ios::binary);
        all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return all;
}

/// One of the inputs with one to three changes: a character, after which the text is often still JSON,
/// another number, a piece removed or repeated, or the rest of another input.
template <class Random>
std::string changed(std::vector<std::string> const& all, Random& random) {
    auto const below = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
    std::string text = all[below(all.size())];
    for (std::size_t changes = 1 + below(3); changes > 0 && !text.empty(); --changes) {
        std::size_t const at = below(text.size());
        std::size_t const length = std::min(below(20), text.size() - at);
        switch (below(6)) {
        case 0:
            text[at] = "0123456789\"[]{}-.e, tn"[below(22)];
            break;
        case 1:
        case 2: {
            constexpr std::string_view numbers[] = {"0",   "-1", "1e308", "-1e-308",
                                                    "0.5", "3",  "1e400", "90071"};
            std::size_t const digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos) {
                std::size_t const end =
                    std::min(text.find_first_not_of("0123456789.e-+", digit), text.size());
                text.replace(digit, end - digit, numbers[below(std::size(numbers))]);
            }
            break;
        }
        case 3:
            text.erase(at, length);
            break;
        case 4:
            text.insert(at, text.substr(at, length));
            break;
        default: {
            std::string const& other = all[below(all.size())];
            text = text.substr(0, at) + other.substr(below(other.size()));
        }
        }
    }
    return text;
}

/// Every kept input, then `usual` changed ones; TREMBLER_FUZZ=50 tries fifty times as many, 0.1 a tenth.
inline void fuzzTarget(std::string const& name, void (*target)(std::string_view), int usual) {
    std::vector<std::string> const all = keptInputs(name);
    ASSERT_FALSE(all.empty());
    for (std::string const& bytes : all) {
        EXPECT_NO_THROW(target(bytes)) << bytes;
    }
    char const* const factor = std::getenv("TREMBLER_FUZZ");
    int const times = std::max(3, static_cast<int>(usual * (factor == nullptr ? 1 : std::atof(factor))));
    std::mt19937_64 random(2026);
    for (int i = 0; i < times; ++i) {
        std::string const bytes = changed(all, random);
        EXPECT_NO_THROW(target(bytes)) << bytes;
    }
}

} // namespace trembler::files

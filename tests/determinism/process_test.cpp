// Two processes produce the same bits: nothing depends on addresses, the environment or the clock.
#include "tests/determinism/level_runs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>

namespace trembler::determinism {
namespace {

std::string outputOf(std::string const& command) {
    std::string output;
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) {
        return output;
    }
    std::array<char, 4096> buffer{};
    while (std::size_t const got = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        output.append(buffer.data(), got);
    }
    pclose(pipe);
    return output;
}

nlohmann::json hashesOfProgram(std::string const& environment, std::string const& level, int threads) {
    std::string const command = environment + " " + TREMBLER_BINARY_DIR + "/trembler run " + level +
                                " --json --frames 300 --hash-every 60 --threads " + std::to_string(threads);
    auto const report = nlohmann::json::parse(outputOf(command), nullptr, false);
    return report.is_discarded() ? nlohmann::json(command + " printed no JSON") : report["hashes"];
}

TEST(Processes, GiveTheSameHashes) {
    for (auto const& path : gameData().levels()) {
        auto const first = hashesOfProgram("", path.string(), 1);
        ASSERT_TRUE(first.is_array()) << first;
        EXPECT_EQ(first.size(), 5U);
        EXPECT_EQ(first,
                  hashesOfProgram("LANG=de_DE.UTF-8 MALLOC_PERTURB_=42 FILLER=$(seq 1 999 | tr '\\n' x)",
                                  path.string(), 2));
    }
}

} // namespace
} // namespace trembler::determinism

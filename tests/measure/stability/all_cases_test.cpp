// The hard cases with the automatic settings, one seed each; bench_stability runs them over twenty.
#include "measure/stability/hard_case.hpp"

#include <gtest/gtest.h>

#include <cctype>

namespace trembler::stability {
namespace {

class HardCases : public ::testing::TestWithParam<HardCase> {};

TEST_P(HardCases, HoldWithTheAutomaticSettings) {
    for (Figure const& figure : GetParam().run({}, 1)) {
        EXPECT_LE(figure.value, figure.limit) << figure.what << " in " << figure.unit;
    }
}

std::vector<HardCase> quickCases() {
    std::vector<HardCase> quick;
    for (HardCase& one : allCases()) {
        if (one.quick) {
            quick.push_back(std::move(one));
        }
    }
    return quick;
}

std::string nameOf(::testing::TestParamInfo<HardCase> const& info) {
    std::string name = info.param.row + " " + info.param.name;
    for (char& c : name) {
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Stability, HardCases, ::testing::ValuesIn(quickCases()), nameOf);

} // namespace

// For GoogleTest's messages.
// NOLINTNEXTLINE(readability-identifier-naming)
void PrintTo(HardCase const& one, std::ostream* out) {
    *out << one.row << ' ' << one.name;
}

} // namespace trembler::stability

// The largest files that are read, and the smallest that are too large.
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/json/limits.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace trembler {
namespace {

std::vector<std::string> problemsOf(std::string text) {
    std::vector<std::string> problems;
    try {
        (void)JsonDocument::parse(std::move(text), "f.json");
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            problems.push_back(diagnostic.print());
        }
    }
    return problems;
}

TEST(FileLimits, AsManyValuesAsTheLimitAreReadAndNotOneMore) {
    std::string text = "[0";
    for (std::size_t i = 2; i < limits::values; ++i) { // the list itself counts as well
        text += ",1";
    }
    EXPECT_EQ(problemsOf(text + "]"), std::vector<std::string>());
    EXPECT_EQ(problemsOf(text + ",1]"),
              std::vector<std::string>{"f.json:1:1: has too many values; expected at most 4000000"});
}

TEST(FileLimits, ALargerFileIsRefusedUnread) {
    EXPECT_EQ(problemsOf(std::string(limits::fileSize + 1, ' ')),
              std::vector<std::string>{"f.json: has 67108865 bytes; expected at most 67108864"});
}

} // namespace
} // namespace trembler

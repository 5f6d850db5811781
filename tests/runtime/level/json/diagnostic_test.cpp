#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace diagnostic_test {
namespace {

Diagnostic at(std::size_t line, std::size_t column, std::string message, std::string file = "f") {
    Diagnostic made;
    made.file = std::move(file);
    made.line = line;
    made.column = column;
    made.message = std::move(message);
    return made;
}

std::vector<Diagnostic> thrownBy(Problems const& problems) {
    try {
        problems.throwIfAny();
        return {};
    } catch (InputError const& error) {
        return error.diagnostics();
    }
}

TEST(Diagnostic, PrintsItsPresentFields) {
    Diagnostic one = at(0, 0, "cannot be read", "a.json");
    EXPECT_EQ(one.print(), "a.json: cannot be read");
    one.line = 3;
    one.column = 14;
    EXPECT_EQ(one.print(), "a.json:3:14: cannot be read");
    one.path = "/objects/2";
    one.expected = "a circle";
    EXPECT_EQ(one.print(), "a.json:3:14: /objects/2: cannot be read; expected a circle");
}

TEST(Diagnostic, IsOneLineOfLimitedLength) {
    Diagnostic one = at(1, 1, "a\nb\x1b[2J");
    EXPECT_EQ(one.print().find('\n'), std::string::npos);
    EXPECT_EQ(one.print().find('\x1b'), std::string::npos);
    for (std::size_t pad = 0; pad < 3; ++pad) { // a cut inside a character would leave an incomplete one
        one.message.assign(pad, 'x');
        while (one.message.size() < 5000) {
            one.message += "\xE2\x86\x92";
        }
        EXPECT_LT(one.print().size(), 2100U);
        EXPECT_EQ(one.print().find('<'), std::string::npos) << pad;
    }
}

TEST(Problems, AreThrownInOrderOfTheirPlaces) {
    Problems problems;
    EXPECT_TRUE(problems.empty());
    EXPECT_NO_THROW(problems.throwIfAny());
    problems.add(at(2, 1, "c", "f"));
    problems.add(at(1, 9, "b", "f"));
    problems.add(at(9, 9, "a", "e"));
    problems.add(at(2, 1, "d", "f")); // at the same place: the first problem first
    auto const sorted = thrownBy(problems);
    ASSERT_EQ(sorted.size(), 4U);
    std::string order;
    for (Diagnostic const& one : sorted) {
        order += one.message;
    }
    EXPECT_EQ(order, "abcd");
    try {
        problems.throwIfAny();
        FAIL();
    } catch (InputError const& error) {
        EXPECT_STREQ(error.what(), "e:9:9: a\nf:1:9: b\nf:2:1: c\nf:2:1: d");
    }
}

TEST(Problems, BeyondTheLimitAreOnlyCounted) {
    Problems problems;
    std::size_t made = 0;
    for (std::size_t i = 0; i < Problems::most + 7; ++i) {
        addProblem(problems, [&] {
            ++made;
            return at(i + 1, 1, "wrong");
        });
    }
    EXPECT_EQ(made, Problems::most) << "the texts of the others are not made";
    EXPECT_EQ(problems.count(), Problems::most + 7);
    problems.add(at(1, 1, "one more"));
    auto const all = thrownBy(problems);
    ASSERT_EQ(all.size(), Problems::most + 1);
    EXPECT_EQ(all.back().print(), "f: and 8 more");
}

} // namespace
} // namespace diagnostic_test
} // namespace trembler

#include "game/ui/shared/letters/letter_keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace trembler::ui {
namespace letter_keys_test {
namespace {

std::vector<KeysWanted> allKeyboards() {
    std::vector<KeysWanted> all;
    for (KeyPage const page : {KeyPage::letters, KeyPage::capitals, KeyPage::signs, KeyPage::numbers}) {
        for (bool const german : {false, true}) {
            all.push_back({page, german, false});
            all.push_back({page, german, true});
        }
    }
    return all;
}

TEST(LetterKeys, FillEveryRowWithoutGaps) {
    for (KeysWanted const& wanted : allKeyboards()) {
        std::array<double, rowsOfKeys> filled{};
        for (LetterKey const& key : letterKeys(wanted)) {
            ASSERT_LT(key.row, rowsOfKeys);
            EXPECT_NEAR(key.left, filled[key.row], 1e-9);
            filled[key.row] += key.width;
        }
        for (double const width : filled) {
            EXPECT_NEAR(width, rowOfKeys, 1e-9);
        }
    }
}

TEST(LetterKeys, HaveEveryLetterOfTheLanguage) {
    for (bool const german : {false, true}) {
        std::set<std::string> letters;
        for (KeyPage const page : {KeyPage::letters, KeyPage::capitals}) {
            for (LetterKey const& key : letterKeys({page, german, false})) {
                letters.insert(key.text);
            }
        }
        for (char letter = 'a'; letter <= 'z'; ++letter) {
            EXPECT_TRUE(letters.contains(std::string(1, letter))) << letter;
            EXPECT_TRUE(letters.contains(std::string(1, static_cast<char>(letter - 'a' + 'A')))) << letter;
        }
        for (char const* const umlaut : {"ä", "ö", "ü", "ß", "Ä", "Ö", "Ü"}) {
            EXPECT_EQ(letters.contains(umlaut), german) << umlaut;
        }
    }
}

TEST(LetterKeys, HaveEveryPrintableSignSomewhere) {
    for (bool const german : {false, true}) {
        std::set<std::string> there{" "};
        for (KeyPage const page : {KeyPage::letters, KeyPage::capitals, KeyPage::signs}) {
            for (LetterKey const& key : letterKeys({page, german, false})) {
                there.insert(key.text);
            }
        }
        for (char sign = ' '; sign <= '~'; ++sign) {
            if (sign != '`') { // a dead key on most keyboards
                EXPECT_TRUE(there.contains(std::string(1, sign))) << sign;
            }
        }
    }
}

TEST(LetterKeys, AreAllReachedByTheFourDirections) {
    for (KeysWanted const& wanted : allKeyboards()) {
        std::vector<LetterKey> const keys = letterKeys(wanted);
        std::set<std::size_t> reached{0};
        for (std::size_t before = 0; before != reached.size();) {
            before = reached.size();
            for (std::size_t const from : std::set<std::size_t>(reached)) {
                for (auto const& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    double aim = keys[from].left + 0.5 * keys[from].width;
                    reached.insert(keyBeside(keys, from, x, y, aim));
                }
            }
        }
        EXPECT_EQ(reached.size(), keys.size());
    }
}

TEST(LetterKeys, AreLeftTheWayOneCame) {
    std::vector<LetterKey> const keys = letterKeys({KeyPage::letters, false, false});
    for (std::size_t from = 0; from < 11; ++from) { // the digits, over the wide keys and around
        double aim = keys[from].left + 0.5 * keys[from].width;
        std::size_t at = from;
        for (std::size_t i = 0; i < rowsOfKeys; ++i) {
            at = keyBeside(keys, at, 0, 1, aim);
        }
        EXPECT_EQ(at, from);
        at = keyBeside(keys, at, 0, -1, aim);
        EXPECT_EQ(keys[at].row, rowsOfKeys - 1) << "above the first row is the last one";
        double sideways = 0;
        at = keyBeside(keys, from, 1, 0, sideways);
        EXPECT_EQ(at, (from + 1) % 11);
        EXPECT_EQ(keyBeside(keys, at, -1, 0, sideways), from);
    }
}

} // namespace
} // namespace letter_keys_test
} // namespace trembler::ui

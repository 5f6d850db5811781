// Which parts a large toolbox shows, compared with a plain search through all of them.
#include "game/ui/cards/toolbox_view.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>
#include <random>
#include <set>

namespace trembler::ui::test {
namespace toolbox_view_test {
namespace {

class ToolboxViewTest : public testing::Test {
protected:
    ~ToolboxViewTest() override { useLanguage("en"); }

    static std::vector<ToolboxSlot> slots(std::size_t most = 1000) {
        std::vector<ToolboxSlot> all;
        for (std::string const& part : gameData().parts.names()) {
            if (all.size() < most) {
                all.push_back({part, unlimitedCount, unlimitedCount});
            }
        }
        return all;
    }
    std::set<std::string> shown() {
        std::set<std::string> names;
        for (ToolboxSlot const& slot : view.shown(slots(), catalog())) {
            EXPECT_TRUE(names.insert(slot.part).second) << slot.part << " is shown twice";
        }
        return names;
    }
    PartCatalog& catalog() { return player.app().context().catalog; }

    Player player;
    ToolboxView view;
};

TEST_F(ToolboxViewTest, OfASmallToolboxShowsAllInTheirOrder) {
    auto const few = slots(ToolboxView::mostInSmall);
    view.seek("no such part");
    auto const all = view.shown(few, catalog());
    ASSERT_EQ(all.size(), few.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
        EXPECT_EQ(all[i].part, few[i].part);
    }
}

TEST_F(ToolboxViewTest, SortsALargeOneByTheShownNames) {
    for (char const* const language : {"en", "de"}) {
        useLanguage(language);
        auto const all = view.shown(slots(), catalog());
        EXPECT_EQ(all.size(), gameData().parts.names().size());
        for (std::size_t i = 1; i < all.size(); ++i) {
            EXPECT_LE(inSmallLetters(catalog().titleOf(all[i - 1].part)),
                      inSmallLetters(catalog().titleOf(all[i].part)));
        }
    }
}

// A piece of a name finds that part, in whichever case; and every part that is found has the piece in its
// name.
TEST_F(ToolboxViewTest, FindsEveryPartByEachPieceOfItsName) {
    std::mt19937 random(7);
    for (char const* const language : {"en", "de"}) {
        useLanguage(language);
        for (std::string const& part : gameData().parts.names()) {
            std::string const name = inSmallLetters(catalog().titleOf(part));
            std::size_t const from = random() % name.size();
            std::string piece = name.substr(from, 1 + random() % (name.size() - from));
            piece.erase(std::remove(piece.begin(), piece.end(), ' '), piece.end());
            if (piece.empty() || name.find(piece) == std::string::npos) {
                continue; // it went across a blank
            }
            for (char& letter : piece) {
                letter = random() % 2 == 0 && letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 32)
                                                                             : letter;
            }
            view.seek(piece);
            std::set<std::string> expected;
            for (std::string const& other : gameData().parts.names()) {
                if (inSmallLetters(catalog().titleOf(other)).find(inSmallLetters(piece)) !=
                    std::string::npos) {
                    expected.insert(other);
                }
            }
            EXPECT_EQ(shown(), expected) << piece;
            EXPECT_EQ(expected.count(part), 1U);
        }
    }
}

TEST_F(ToolboxViewTest, SeekingAndChoosingAGroupEndEachOther) {
    view.choose(PartGroup::sound);
    EXPECT_EQ(shown().count("iron ball"), 0U);
    view.seek("iron ball");
    EXPECT_FALSE(view.group());
    EXPECT_EQ(shown(), std::set<std::string>{"iron ball"});
    view.choose(PartGroup::sound);
    EXPECT_EQ(view.sought(), "");
    view.seek(std::string(1000, 'x'));
    EXPECT_EQ(view.sought().size(), ToolboxView::longestText);
    EXPECT_FALSE(view.firstShown(slots(), catalog()));
}

TEST_F(ToolboxViewTest, AGroupShowsItsPartsAndOnlyThose) {
    for (PartGroup const group : ToolboxView::groupsIn(slots(), catalog())) {
        view.choose(group);
        auto const names = shown();
        EXPECT_FALSE(names.empty());
        for (std::string const& part : gameData().parts.names()) {
            auto const& groups = catalog().groupsOf(part);
            bool const belongs = std::find(groups.begin(), groups.end(), group) != groups.end();
            EXPECT_EQ(names.count(part) == 1, belongs) << part;
        }
    }
}

TEST_F(ToolboxViewTest, StepsThroughTheGroupsAndBack) {
    auto const there = ToolboxView::groupsIn(slots(), catalog());
    for (int by : {1, -1}) {
        view.choose({});
        for (std::size_t i = 0; i < there.size(); ++i) {
            view.chooseNext(there, by);
            EXPECT_EQ(view.group(), there[by > 0 ? i : there.size() - 1 - i]);
        }
        view.chooseNext(there, by);
        EXPECT_FALSE(view.group());
    }
}

TEST_F(ToolboxViewTest, KnowsSmallLetters) {
    EXPECT_EQ(inSmallLetters("ÄÖÜ ÀÉÞ aZ × ß ñ 5"), "äöü àéþ az × ß ñ 5");
    EXPECT_EQ(inSmallLetters("\xC3"), "\xC3"); // the end of a cut letter
}

} // namespace
} // namespace toolbox_view_test
} // namespace trembler::ui::test

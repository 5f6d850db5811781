// Whether a screen is laid out well, whatever its size.
#pragma once

#include "tests/game/ui/player.hpp"

#include <cstddef>
#include <string>

namespace trembler::ui::test {

/// Every card lies on the screen, has room for its content and overlaps no other card.
inline void expectTidy(Player& player, std::string const& what) {
    auto const& cards = player.layout().cards();
    EXPECT_FALSE(cards.empty()) << what;
    render::Size const size = window().size();
    for (std::size_t i = 0; i < cards.size(); ++i) {
        EXPECT_GE(cards[i].rect.low.x, 0) << what << ": " << cards[i].name;
        EXPECT_GE(cards[i].rect.low.y, 0) << what << ": " << cards[i].name;
        EXPECT_LE(cards[i].rect.high.x, size.width) << what << ": " << cards[i].name;
        EXPECT_LE(cards[i].rect.high.y, size.height) << what << ": " << cards[i].name;
        EXPECT_LE(cards[i].overflow, 1.0) << what << ": the content of " << cards[i].name << " is cut off";
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(cards[i].rect.overlaps(cards[j].rect))
                << what << ": " << cards[i].name << " lies on " << cards[j].name;
        }
    }
    // Rows of a list meet in the middle of the gap between them, which may be half a pixel.
    auto const inner = [](Rect const& rect) {
        return Rect{rect.low + Point{0.6, 0.6}, rect.high - Point{0.6, 0.6}};
    };
    auto const& items = player.layout().items();
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(inner(items[i].rect).overlaps(inner(items[j].rect)))
                << what << ": " << items[i].name << " lies on " << items[j].name;
        }
    }
}

} // namespace trembler::ui::test

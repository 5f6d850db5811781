// Undo and redo against a plain list of all states.
#include "puzzle/session/history.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace trembler {
namespace {

TEST(History, ForgetsTheOldestStatesOnly) {
    std::mt19937_64 random(36);
    for (int round = 0; round < 50; ++round) {
        History<int> history(0);
        std::vector<int> all{0};
        std::size_t at = 0;
        std::size_t oldest = 0; // that can still be returned to
        for (int i = 1; i <= 200; ++i) {
            switch (random() % 5) {
            case 0:
                ASSERT_EQ(history.undo(), at > oldest);
                at -= at > oldest ? 1 : 0;
                break;
            case 1:
                ASSERT_EQ(history.redo(), at + 1 < all.size());
                at += at + 1 < all.size() ? 1 : 0;
                break;
            case 2: {
                std::size_t const most = random() % 8;
                history.forgetBefore(most);
                oldest = at - oldest > most ? at - most : oldest;
                break;
            }
            default:
                all.resize(at + 1);
                all.push_back(i);
                ++at;
                history.change(i);
            }
            ASSERT_EQ(history.now(), all[at]);
            ASSERT_EQ(history.canUndo(), at > oldest);
            ASSERT_EQ(history.canRedo(), at + 1 < all.size());
        }
    }
}

} // namespace
} // namespace trembler

// Groups of sources by place.
#include "audio/effect/hearing/source_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace trembler {
namespace {

TEST(SourceTree, GroupsLimitTheirMembersAndHalvesShareThem) {
    EXPECT_TRUE(rc::check("of sources anywhere", [] {
        std::vector<SoundSource> sources;
        for (std::uint32_t i = *rc::gen::inRange(0U, 80U); i > 0; --i) {
            sources.push_back({{i, 0},
                               {1.0 * *rc::gen::inRange(-9, 9), 1.0 * *rc::gen::inRange(-9, 9)},
                               1e-3 * *rc::gen::inRange(1, 1000),
                               1.0 * *rc::gen::inRange(20, 9000),
                               {}});
        }
        SourceTree const tree(sources);
        RC_ASSERT(tree.groups().empty() == sources.empty());
        for (std::size_t g = 0; g < tree.groups().size(); ++g) {
            SourceTree::Group const& group = tree.groups()[g];
            RC_ASSERT(g > 0 || group.size() == sources.size());
            for (std::uint32_t const member : tree.membersOf(group)) {
                SoundSource const& source = sources[member];
                RC_ASSERT(group.bounds.meets({source.at, source.at}));
                RC_ASSERT(source.loudness <= group.loudest);
                RC_ASSERT(source.frequency >= group.lowestFrequency);
            }
            if (group.second != 0) {
                auto const all = tree.membersOf(group);
                auto const one = tree.membersOf(tree.groups()[g + 1]);
                auto const other = tree.membersOf(tree.groups()[group.second]);
                std::vector<std::uint32_t> both(one.begin(), one.end());
                both.insert(both.end(), other.begin(), other.end());
                RC_ASSERT(std::equal(both.begin(), both.end(), all.begin(), all.end()));
            }
        }
        if (!sources.empty()) {
            auto const members = tree.membersOf(tree.groups().front());
            std::vector<std::uint32_t> all(members.begin(), members.end());
            std::sort(all.begin(), all.end());
            for (std::uint32_t i = 0; i < all.size(); ++i) {
                RC_ASSERT(all[i] == i);
            }
        }
    }));
}

} // namespace
} // namespace trembler

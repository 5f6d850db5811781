// Events in a part of a frame are not lost to readers that run once per frame. Each property declares whether
// it reports events (runtime/property/news.hpp); these properties must not declare that they report none.
#include "puzzle/data/effects.hpp"
#include "runtime/property/slot.hpp"
#include "runtime/world/registry.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace trembler {
namespace {

TEST(News, OfEveryPartReachReadersThatRunOncePerFrame) {
    Registry registry;
    registerEffects(registry);
    std::set<std::string_view> reporting;
    for (Registration const& registration : registry.components()) {
        for (PropertyInfo const* const offer : registration.info->offers) {
            if (offer->makeSlot()->reportsNews()) {
                reporting.insert(offer->text.key);
            }
        }
    }
    for (std::string_view const key :
         {"player_commands", "population_changes", "contacts", "impacts", "overloaded_joints"}) {
        EXPECT_TRUE(reporting.contains(key)) << key;
    }
}

} // namespace
} // namespace trembler

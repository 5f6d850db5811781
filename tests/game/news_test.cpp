// Nothing that happens in a part of a frame is lost to whoever looks once a frame: every resolver property
// either gathers the news of all parts, or is known here to tell how things stand.
#include "game/core/effects.hpp"
#include "runtime/property/slot.hpp"
#include "runtime/world/registry.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace trembler {
namespace {

// Key of the property -> why the last part's value is the frame's.
std::map<std::string_view, std::string_view> const standing{
    {"hand", "what is held, and where it is pulled to"},
    {"frame_parts", "in how many parts the frame is computed"},
    {"contact_patches", "how those touch that still do"},
    {"joint_forces", "what joints carry"},
    {"motion_causes", "the recent causes, not those of a part"},
    {"force_rates", "how fast the forces vary that stand"},
    {"force_lag", "what a force's lag is"},
    {"solver_choice", "what it was computed with"},
    {"engine_state", "which engine computes"},
    {"graph_changes", "a numbered journal, from which each reader takes what it has missed"},
    {"electricity_graph", "who is connected"},
    {"magnet_switching", "the event that last switched each magnet"},
    {"linear_gravity", "the gravity that was told"},
    {"buoyancy_force", "the forces that act"},
    {"centre_of_buoyancy", "where they act"},
    {"immersion", "what is in which liquid, and how"},
};

TEST(News, OfEveryPartReachWhoeverLooksOnceAFrame) {
    Registry registry;
    registerEffects(registry);
    std::set<std::string_view> telling;
    for (Registration const& registration : registry.components()) {
        if (registration.info->kind != ComponentKind::resolver) {
            continue;
        }
        for (PropertyInfo const* const offer : registration.info->offers) {
            if (offer->makeSlot()->tellsNews()) {
                telling.insert(offer->text.key);
                EXPECT_FALSE(standing.contains(offer->text.key)) << offer->text.key;
            } else {
                EXPECT_TRUE(standing.contains(offer->text.key))
                    << offer->text.name << " ('" << offer->text.key
                    << "'): if it tells what happened in a part of "
                    << "a frame, it needs 'static void gather(P& frame, P const& part, PartSpan span)' (see "
                    << "runtime/property/news.hpp), or whoever looks once a frame misses all but the last "
                       "part's; if "
                    << "it tells how things stand, say so in the table of this test";
            }
        }
    }
    for (std::string_view const key :
         {"player_commands", "population_changes", "contacts", "impacts", "overloaded_joints"}) {
        EXPECT_TRUE(telling.contains(key)) << key;
    }
}

} // namespace
} // namespace trembler

// Effects depend only on each other's properties and calls, never on another effect's setup or internal
// choices.
#include "audio/effect/register.hpp"
#include "physics/register_physics.hpp"
#include "runtime/component/info.hpp"
#include "runtime/world/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace trembler {
namespace {

Registry const& everything() {
    static Registry const registry = [] {
        Registry made;
        registerEverything(made);
        registerSound(made);
        return made;
    }();
    return registry;
}

std::vector<PropertyInfo const*> touched(ComponentInfo const& info) {
    std::vector<PropertyInfo const*> all = info.reads;
    all.insert(all.end(), info.writes.begin(), info.writes.end());
    return all;
}

// The automatic settings of the solver are for display only.
TEST(EffectsApart, NoComponentReadsTheSolverChoice) {
    bool offered = false;
    for (Registration const& registration : everything().components()) {
        ComponentInfo const& info = *registration.info;
        auto const named = [](PropertyInfo const* property) { return property->text.key == "solver_choice"; };
        EXPECT_TRUE(std::none_of(info.reads.begin(), info.reads.end(), named)) << title(info);
        offered = offered || std::any_of(info.offers.begin(), info.offers.end(), named);
    }
    EXPECT_TRUE(offered);
}

// Each property of the world is read by one effect. Others receive gravity through interactions, and never
// receive settings.
TEST(EffectsApart, APropertyOfTheWorldIsReadByOneEffect) {
    std::map<std::string_view, std::set<std::string_view>> readers;
    for (Registration const& registration : everything().components()) {
        ComponentInfo const& info = *registration.info;
        for (PropertyInfo const* property : touched(info)) {
            bool const passesOn = info.kind == ComponentKind::interaction && property->text.key == "gravity";
            if (property->text.place == PropertyPlace::world && !passesOn) {
                readers[property->text.key].insert(info.text.effect);
            }
        }
    }
    EXPECT_EQ(readers.at("gravity"), (std::set<std::string_view>{"gravity"}));
    for (auto const& [key, effects] : readers) {
        EXPECT_EQ(effects.size(), 1U) << key;
    }
}

} // namespace
} // namespace trembler

#include "audio/effect/properties/sounds.hpp"
#include "game/ui/panels/cost_rows.hpp"
#include "game/ui/shared/words.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>
#include <stdexcept>

namespace trembler::ui::test {
namespace {

EffectCost costOf(World const& world, std::string const& effect) {
    auto const costs = effectCosts(world, budget::BudgetMode(gameData().registry));
    auto const found = std::find_if(costs.begin(), costs.end(),
                                    [&](EffectCost const& cost) { return cost.effect == effect; });
    return found != costs.end() ? *found : throw std::invalid_argument("there is no effect " + effect);
}

TEST(EffectCosts, NameThePropertyThatNoObjectHas) {
    Session session(gameData().registry, gameData().parts,
                    loadLevel(gameData().registry, levelsFolder() / "experiments/2-doorbell.json"));
    session.step();
    EffectCost const buoyancy = costOf(session.world(), "buoyancy");
    EXPECT_EQ(buoyancy.activity, Activity::absent);
    EXPECT_EQ(buoyancy.reason, words::nothingHas("Liquid"));
}

TEST(EffectCosts, DistinguishMissingReadersFromMissingObjects) {
    Session session(gameData().registry, gameData().parts,
                    loadLevel(gameData().registry, levelsFolder() / "experiments/2-doorbell.json"));
    session.step();
    // Its bodies could sound, but nothing reads their sounds.
    EXPECT_EQ(costOf(session.world(), "sound").activity, Activity::absent);
    EXPECT_EQ(costOf(session.world(), "sound").reason, words::notRead);
    Subscription const listening = session.world().want<Sounds>();
    session.step();
    EXPECT_NE(costOf(session.world(), "sound").activity, Activity::absent);
    EXPECT_EQ(costOf(session.world(), "sound").reason, "");
}

} // namespace
} // namespace trembler::ui::test

// Sparks appear where a contact opens through which current flowed, and only there.
#include "game/ui/play/view/spark_view.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

/// A steel bar lies across two contacts and closes the circuit; the player lifts it.
TEST(SparkView, FlyWhereALiveContactOpens) {
    Session session(gameData().registry, gameData().parts,
                    loadLevel(gameData().registry, levelsFolder() / "first/1-first-contact.json"));
    session.load(session.level().solutions.front());
    session.start();
    Subscription const patches = session.world().want<ContactPatches>();
    SparkView sparks;
    auto const run = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            session.step();
            sparks.afterStep(session.world());
        }
    };
    run(90);
    EXPECT_TRUE(sparks.sparks().empty()) << "the circuit is closed";
    ObjectId const bar = session.world().store().find("steel bar 1");
    Vec2 const at = session.world().find<Position>(bar)->value;
    session.feed({PlayerInput::Kind::grab, bar, {}, at});
    session.feed({PlayerInput::Kind::move, bar, {}, at + Vec2{0, 1}});
    run(30);
    ASSERT_FALSE(sparks.sparks().empty());
    EXPECT_LT(std::abs(sparks.sparks().front().at.y - at.y), 0.3);
    sparks.pass(1);
    EXPECT_TRUE(sparks.sparks().empty()) << "they last a moment";
    run(30);
    EXPECT_TRUE(sparks.sparks().empty());
}

} // namespace
} // namespace trembler::ui::test

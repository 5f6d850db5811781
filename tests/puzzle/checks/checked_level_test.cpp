#include "puzzle/checks/checked_level.hpp"
#include "puzzle/session/session.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

// Nothing is built twice: the world that was checked is the one that runs, and it runs like any other.
TEST(CheckedLevel, HandsItsWorldOnToTheSession) {
    GameData const& data = gameData();
    for (char const* const name :
         {"first/1-first-contact.json", "experiments/1-switched-electromagnet.json"}) {
        SCOPED_TRACE(name);
        auto const file = data.home / "levels" / name;
        WorldOptions options;
        options.threads = 2;
        ReadyLevel ready = loadPlayable(data.registry, data.parts, file, options);
        World const* const checked = ready.built.world.get();
        LevelFile const level = ready.level;
        Session session(data.registry, data.parts, std::move(ready));
        EXPECT_EQ(&session.world(), checked);
        EXPECT_EQ(session.world().options().threads, 2);

        Session other(data.registry, data.parts, level, options);
        for (Session* const one : {&session, &other}) {
            if (!level.solutions.empty()) {
                one->load(level.solutions.front());
            }
        }
        for (int round = 0; round < 2; ++round) { // stop() builds the next run, with the same options
            for (int frame = 0; frame < 60; ++frame) {
                session.step();
                other.step();
            }
            EXPECT_EQ(session.world().stateHash(), other.world().stateHash());
            session.stop();
            other.stop();
            EXPECT_EQ(session.world().options().threads, 2);
        }
    }
}

TEST(CheckedLevel, HandsItsObjectsOnToTheSession) {
    GameData const& data = gameData();
    auto const file = data.home / "levels" / "first/1-first-contact.json";
    Session const session(data.registry, data.parts, loadPlayable(data.registry, data.parts, file));
    Session const other(data.registry, data.parts, session.level());
    ASSERT_FALSE(session.level().objects.empty());
    for (LevelObject const& object : session.level().objects) {
        ObjectId const id = session.world().store().find(object.name);
        EXPECT_EQ(session.lasting(id), other.lasting(other.world().store().find(object.name))) << object.name;
        EXPECT_EQ(session.find(session.lasting(id)), id) << object.name;
    }
}

} // namespace
} // namespace trembler

// A sound sensor beside other interactions on electricity: none removes the connections of another.
#include "physics/motor/properties.hpp"
#include "runtime/population/population_resolver.hpp"
#include "tests/audio/effect/listening_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace trembler {
namespace {

using test::ListeningRoom;

/// A ball falls beside a sensor between a dynamo at rest and its source.
struct Doorbell {
    explicit Doorbell(bool generator) {
        room.fixed("floor", Material::stone, boxPiece(20, 0.4), {0, -0.2});
        sensor = room.fixed("sensor", Material::plastic, boxPiece(0.4, 0.4), {3, 0.2});
        source = room.fixed("source", Material::copper, boxPiece(0.2, 0.2), {2, 0.1});
        room.give(source, Conductor{});
        room.give(source, ElectricalSource{});
        dynamo = room.body("dynamo", Material::copper, boxPiece(0.2, 0.2), {4, 0.1});
        room.give(dynamo, Conductor{});
        if (generator) {
            room.give(dynamo, Generator{source, 5, 0});
        }
        SoundSensor property;
        property.threshold = 85;
        property.a = source;
        property.b = dynamo;
        room.give(sensor, property);
        room.body("ball", Material::steel, circlePiece(0.1), {-1, 2.1});
    }
    [[nodiscard]] bool on() const { return room.world->find<ElectricalState>()->isOn(dynamo); }
    [[nodiscard]] CallerCounts connection() const {
        return connectionBetween(room.world->store(), source, dynamo);
    }
    /// For each of the first frames, whether the dynamo is on.
    std::vector<bool> onIn(int frames) {
        std::vector<bool> found;
        for (int i = 0; i < frames; ++i) {
            room.run(1);
            found.push_back(on());
        }
        return found;
    }
    void runUntilOn() {
        for (int i = 0; i < 240 && (i == 0 || !on()); ++i) {
            room.run(1);
        }
        ASSERT_TRUE(on());
    }
    ListeningRoom room;
    ObjectId sensor;
    ObjectId source;
    ObjectId dynamo;
};

TEST(ElectricityFromSound, IsNotUndoneByAGeneratorAtRestBetweenTheSameObjects) {
    std::vector<bool> const without = Doorbell(false).onIn(240);
    auto const frames = std::count(without.begin(), without.end(), true);
    EXPECT_GT(frames, 3);
    EXPECT_FALSE(without.back());
    EXPECT_EQ(Doorbell(true).onIn(240), without);
}

TEST(ElectricityFromSound, IsNamedByTheGraphAsTheConnectionsOwner) {
    Doorbell bell(true);
    bell.runUntilOn();
    EXPECT_EQ(bell.connection().names(), "Electricity <- Sound");
}

TEST(ElectricityFromSound, RemovesItsConnectionsWithItsLastSensor) {
    Doorbell bell(false);
    bell.runUntilOn();
    bell.room.world->feed({.kind = PlayerInput::Kind::remove, .object = bell.sensor, .other = {}, .at = {}});
    bell.room.run(3);
    ASSERT_FALSE(bell.room.world->store().alive(bell.sensor));
    EXPECT_EQ(bell.room.of("Electricity <- Sound"), Activity::absent);
    EXPECT_FALSE(bell.connection().any());
    EXPECT_FALSE(bell.on());
}

} // namespace
} // namespace trembler

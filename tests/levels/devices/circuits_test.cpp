// Parts that belong in circuits: fuse, battery, wire, socket and plug, relay.
#include "physics/electricity/properties/quantities.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "tests/levels/devices/device_bench.hpp"

namespace trembler {
namespace {

using CircuitParts = DeviceBench;

// A lamp of 24 ohm at 12 V takes half an ampere.
TEST_F(CircuitParts, AFuseBlowsAboveItsCurrentAndNotBelow) {
    for (int lamps = 1; lamps <= 5; ++lamps) {
        put("left", "copper contact", {-0.25, 1});
        put("right", "copper contact", {0.25, 1});
        put("fuse", "fuse", {0, 1.2});
        wire("plus", "left");
        for (int i = 0; i < lamps; ++i) {
            lampAfter("lamp " + std::to_string(i), "right");
        }
        start();
        runTo(200);
        double const rating = world().find<Fuse>(id("fuse"))->current;
        EXPECT_EQ(world().find<Fuse>(id("fuse"))->blown, 0.5 * lamps > rating) << lamps;
        EXPECT_EQ(on("lamp 0"), 0.5 * lamps <= rating) << lamps;
    }
}

TEST_F(CircuitParts, ABatteryDrivesACurrentThroughWhatTouchesItsEnds) {
    put("battery", "battery", {0, 0.125});
    put("bulb", "bulb", {2, 0.3});
    wire("battery plus", "bulb left");
    wire("bulb right", "battery minus");
    start();
    runTo(60);
    EXPECT_TRUE(on("bulb"));
}

TEST_F(CircuitParts, ABulbShinesWhenItStandsOnABattery) {
    for (SlightlyOff const& off : slightlyOff()) {
        put("battery", "battery", {0, 0.13});
        put("bulb", "bulb", {off.x, 0.55}, off.angleDeg);
        start();
        runTo(200);
        EXPECT_TRUE(on("bulb")) << off.x << " " << off.angleDeg;
    }
}

TEST_F(CircuitParts, AFuseAcrossABatteryBlows) {
    put("battery", "battery", {0, 0.13});
    put("fuse", "fuse", {0, 0.4});
    start();
    runTo(100);
    EXPECT_TRUE(world().find<Fuse>(id("fuse"))->blown);
}

TEST_F(CircuitParts, ABulbStandsOnTwoContacts) {
    for (SlightlyOff const& off : slightlyOff()) {
        put("left", "copper contact", {-0.3, 1});
        put("right", "copper contact", {0.3, 1});
        put("bulb", "bulb", {off.x, 1.4}, off.angleDeg);
        wire("plus", "left");
        wire("right", "minus");
        start();
        runTo(200);
        EXPECT_TRUE(on("bulb")) << off.x << " " << off.angleDeg;
    }
}

TEST_F(CircuitParts, AWireJoinsWhatItsEndsLieOn) {
    for (auto const& [cable, reach] : {std::pair{"wire", 0.6}, {"short wire", 0.3}}) {
        for (SlightlyOff const& off : slightlyOff()) {
            put("left", "copper contact", {-reach, 1});
            put("right", "copper contact", {reach, 1});
            put("wire", cable, {off.x, 1.2}, off.angleDeg);
            wire("plus", "left");
            lampAfter("lamp", "right");
            start();
            runTo(5);
            EXPECT_FALSE(on("lamp"));
            runTo(300);
            EXPECT_TRUE(on("lamp")) << cable << " " << off.x << " " << off.angleDeg;
        }
    }
}

TEST_F(CircuitParts, AnEndOfAWireCanBeLaidElsewhere) {
    put("left", "copper contact", {-0.6, 1});
    put("right", "copper contact", {0.6, 1});
    put("far", "copper contact", {1.2, 1});
    put("wire", "wire", {0, 1.2});
    wire("plus", "left");
    lampAfter("lamp", "far");
    input(60, R"("grab": "wire right end", "at": [0.6, 1.12])");
    input(70, R"("move": [0.7, 1.6])");
    input(100, R"("move": [1.15, 1.6])");
    input(150, R"("move": [1.15, 1.14])");
    input(180, R"("release": true)");
    start();
    runTo(60);
    EXPECT_FALSE(on("lamp"));
    runTo(400);
    EXPECT_TRUE(on("lamp"));
}

TEST_F(CircuitParts, APlugFindsItsSocket) {
    for (SlightlyOff const& off : slightlyOff()) {
        put("socket", "socket", {0, 1});
        put("plug", "plug", {off.x, 1.45}, off.angleDeg);
        wire("plus", "socket left");
        wire("socket right", "minus");
        put("bulb", "bulb", {2, 0.3});
        wire("plug left", "bulb left");
        wire("bulb right", "plug right");
        start();
        runTo(2);
        EXPECT_FALSE(on("bulb"));
        runTo(240);
        EXPECT_TRUE(on("bulb")) << off.x << " " << off.angleDeg;
    }
}

TEST_F(CircuitParts, TheMainsAreAnotherNetworkThanABattery) {
    put("mains", "mains", {0, 2});
    put("battery", "battery", {1, 0.125});
    put("one", "bulb", {-1, 0.3});
    put("two", "bulb", {-2, 0.3});
    wire("mains live", "one left");
    wire("one right", "mains earth");
    wire("battery plus", "two left");
    wire("two right", "mains earth");
    start();
    runTo(60);
    EXPECT_TRUE(on("one"));
    EXPECT_FALSE(on("two"));
}

TEST_F(CircuitParts, ARelayChangesOverWhileCurrentFlowsThroughItsCoil) {
    put("relay", "relay", {0, 2});
    put("switch", "push switch", {-2, 1});
    weigh("weight", {-2, 1.4}, 1);
    wire("plus", "switch left");
    wire("switch right", "relay coil left");
    wire("relay coil right", "minus");
    wire("plus", "relay common");
    lampAfter("upper lamp", "relay upper");
    lampAfter("lower lamp", "relay lower");
    input(240, R"("grab": "weight", "at": [-2, 1.3])");
    input(241, R"("move": [-2, 2.4])");
    start();
    runTo(10);
    EXPECT_TRUE(on("upper lamp") && !on("lower lamp"));
    while (world().frame() < 500) { // the armature never joins both contacts
        step();
        ASSERT_FALSE(touching("relay armature", "relay upper") && touching("relay armature", "relay lower"));
        if (world().frame() == 230) {
            EXPECT_TRUE(!on("upper lamp") && on("lower lamp"));
        }
    }
    EXPECT_TRUE(on("upper lamp") && !on("lower lamp"));
}

} // namespace
} // namespace trembler

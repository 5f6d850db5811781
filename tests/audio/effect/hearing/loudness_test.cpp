// Loudness at each listener, and the sound sensor that it switches.
#include "tests/audio/effect/listening_room.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace trembler {
namespace {

using test::ListeningRoom;

// A recording that plays as long as its object is on: a source whose level is known.
ObjectId addSiren(ListeningRoom& room, Vec2 at, double level) {
    ObjectId const siren = room.world->store().create("siren");
    room.give(siren, Position{at});
    room.give(siren, Conductor{});
    room.give(siren, ElectricalSource{});
    Sample sample;
    sample.file = "siren.ogg";
    sample.cue = SampleCue::powered;
    sample.level = level;
    room.give(siren, sample);
    return siren;
}

TEST(Loudness, FallsByTwentyDecibelsPerTenfoldDistance) {
    ListeningRoom room;
    addSiren(room, {0, 0}, 90);
    ObjectId const near = room.ear("near", {1, 0});
    ObjectId const far = room.ear("far", {0, 10});
    room.run(120); // sixteen time constants
    EXPECT_NEAR(room.levelAt(near), 90, 0.01);
    EXPECT_NEAR(room.levelAt(far), 70, 0.01);
}

TEST(Loudness, RisesAndFallsAsFastAsAMeter) {
    ListeningRoom room;
    ObjectId const siren = addSiren(room, {0, 0}, 90);
    ObjectId const ear = room.ear("ear", {1, 0});
    room.run(120);
    room.world->store().column<ElectricalSource>().remove(siren);
    double const before = room.levelAt(ear);
    while (room.levelAt(ear) == before) {
        room.run(1);
    }
    double const start = room.levelAt(ear);
    room.run(30);
    EXPECT_NEAR(start - room.levelAt(ear), 34.7 / 2, 0.2) << "IEC 61672-1: fast falls by 34.7 dB/s";
    room.run(300);
    EXPECT_EQ(room.levelAt(ear), silentLevel);
}

// Too many paths from sounds to ears to store them all at once: each ear must still hear the same as alone.
TEST(Loudness, OfManySoundsAtManyEarsIsThatOfEachEarAlone) {
    constexpr std::uint32_t sources = 900;
    constexpr std::uint32_t ears = 700;
    Sounds sounds;
    for (std::uint32_t i = 0; i < sources; ++i) {
        Sounds::Body body;
        body.object = {i, 0};
        body.at = {0.5 * i, 0};
        body.loudness = meanSquareOf(i % 2 == 0 ? 60 : 0); // half of them are too quiet to reach all ears
        body.brightness = 1000;
        sounds.bodies.push_back(body);
    }
    Column<SoundSensor> const sensors;
    Column<Shape> const shapes;
    Column<Mass> const masses;
    Column<Density> const densities;
    Column<Rotation> const rotations;
    auto const heardAt = [&](std::uint32_t first, std::uint32_t end) {
        Column<Ear> listening;
        Column<Position> positions;
        for (std::uint32_t i = first; i < end; ++i) {
            listening.set({sources + i, 0}, {});
            if (i % 7 != 0) { // each seventh ear has no position
                positions.set({sources + i, 0}, {{0.7 * i, 3}});
            }
        }
        return loudnessOf(sounds, {listening, sensors, shapes, masses, densities, positions, rotations},
                          PathDetail::straight, [](std::size_t count, auto const& f) { f(0, count); });
    };
    auto const together = heardAt(0, ears);
    ASSERT_EQ(together.size(), ears);
    for (std::uint32_t i = 0; i < ears; ++i) {
        auto const alone = heardAt(i, i + 1);
        ASSERT_EQ(alone.size(), 1U);
        EXPECT_EQ(together[i].ear, alone[0].ear);
        EXPECT_EQ(together[i].level, alone[0].level);
        EXPECT_EQ(together[i].loudest, alone[0].loudest);
        EXPECT_EQ(together[i].level > 0, i % 7 != 0);
    }
}

TEST(Loudness, TwoEqualSourcesAreThreeDecibelsMore) {
    ListeningRoom room;
    addSiren(room, {-2, 0}, 80);
    ObjectId const second = room.world->store().create("second siren");
    room.give(second, Position{{2, 0}});
    room.give(second, Conductor{});
    room.give(second, ElectricalSource{});
    room.give(second, *room.world->find<Sample>(room.world->store().find("siren")));
    ObjectId const ear = room.ear("ear", {0, 0});
    room.run(120);
    EXPECT_NEAR(room.levelAt(ear), 80 - 6.02 + 3.01, 0.01);
}

double behindWalls(std::string const& detail, bool wall, bool roof) {
    WorldOptions options;
    options.detail = {{"loudness", detail}};
    ListeningRoom room(options);
    addSiren(room, {0, 1}, 90);
    ObjectId const ear = room.ear("ear", {4, 1});
    room.fixed("floor", Material::stone, boxPiece(20, 0.4), {0, -0.2});
    if (wall) {
        room.fixed("wall", Material::brick, boxPiece(0.2, 2), {2, 1});
    }
    if (roof) {
        room.fixed("roof", Material::stone, boxPiece(20, 0.4), {0, 2.2});
    }
    room.run(120);
    return room.levelAt(ear);
}

/// The level behind a wall without a gap, through which all of the sound passes.
double throughWall(std::optional<Material> material, std::optional<double> density,
                   std::optional<double> mass) {
    WorldOptions options;
    options.detail = {{"loudness", "around"}};
    ListeningRoom room(options);
    addSiren(room, {0, 1}, 90);
    ObjectId const ear = room.ear("ear", {4, 1});
    ObjectId const wall = room.world->store().create("wall");
    room.give(wall, Shape{{boxPiece(0.02, 4000)}});
    room.give(wall, Position{{2, 1}});
    room.give(wall, Rotation{});
    room.give(wall, Fixed{});
    if (material) {
        room.give(wall, MadeOf{*material});
    }
    if (density) {
        room.give(wall, Density{*density});
    }
    if (mass) {
        room.give(wall, Mass{*mass});
    }
    room.run(120);
    return room.levelAt(ear);
}

// The mass law: the sound that passes a wall depends on its mass alone, however the mass is stated.
TEST(Loudness, AWallMutesByItsOwnMassHoweverThatIsStated) {
    constexpr double volume = 0.02 * 4000 * 0.1; // m³: the world is 0.1 m deep
    double const brick = throughWall(Material::brick, {}, {});
    EXPECT_NEAR(throughWall({}, 1900, {}), brick, 1e-9);
    EXPECT_NEAR(throughWall({}, {}, 1900 * volume), brick, 1e-9);
    EXPECT_NEAR(throughWall(Material::wood, {}, 1900 * volume), brick, 1e-9) << "a stated mass comes first";
    EXPECT_NEAR(throughWall(Material::wood, 20, 1900 * volume), brick, 1e-9);
    // Twice the mass lets a quarter of the energy through: 6 dB.
    EXPECT_NEAR(throughWall({}, {}, 3800 * volume), brick - 6.02, 0.1);
    EXPECT_NEAR(throughWall({}, {}, {}), throughWall({}, 1000, {}), 1e-9) << "as its mass for gravity";
}

TEST(Loudness, AWallInBetweenMutesAndAGapLetsSoundAround) {
    for (std::string const detail : {"straight", "around"}) {
        double const open = behindWalls(detail, false, false);
        double const overTheWall = behindWalls(detail, true, false);
        EXPECT_NEAR(open, 90 - 20 * std::log10(4.0), 0.02) << detail;
        EXPECT_LT(overTheWall, open - 10) << detail;
        EXPECT_GT(overTheWall, open - 27) << detail;
    }
    // Closed up to the roof: sound passes only through the wall, which only the expensive level computes.
    EXPECT_LT(behindWalls("around", true, true), behindWalls("around", true, false) - 15);
    EXPECT_NEAR(behindWalls("straight", true, true), behindWalls("straight", true, false), 1e-9);
}

TEST(Loudness, IsAbsentWithoutListeners) {
    ListeningRoom room;
    addSiren(room, {0, 0}, 90);
    room.run(10);
    EXPECT_EQ(room.of("Loudness around Corners"), Activity::absent);
    EXPECT_EQ(room.of("Sound <- Electricity"), Activity::absent);
}

// A ball is dropped beside a sensor between two contacts.
struct Alarm {
    explicit Alarm(double threshold, double height, bool wall = false, bool named = false,
                   WorldOptions options = {})
        : room(std::move(options)) {
        room.fixed("floor", Material::stone, boxPiece(20, 0.4), {0, -0.2});
        sensor = room.fixed("sensor", Material::plastic, boxPiece(0.4, 0.4), {3, 0.2});
        left = room.body("left contact", Material::copper, boxPiece(0.2, 0.2), {2.7, 0.1});
        right = room.body("right contact", Material::copper, boxPiece(0.2, 0.2), {3.3, 0.1});
        for (ObjectId const contact : {left, right}) {
            room.give(contact, Conductor{});
            room.give(contact, Fixed{});
        }
        room.give(left, ElectricalSource{});
        // Fixed objects do not collide with one another, so one of two that are to touch must be movable.
        if (!named) {
            for (ObjectId const contact : {left, right}) {
                room.world->store().column<Fixed>().remove(contact);
            }
            room.world->store().column<Position>()[left].value.x = 2.705;
            room.world->store().column<Position>()[right].value.x = 3.295;
        }
        SoundSensor property;
        property.threshold = threshold;
        if (named) {
            property.a = left;
            property.b = right;
        }
        room.give(sensor, property);
        if (wall) {
            room.fixed("wall", Material::brick, boxPiece(0.3, 4), {1, 2});
        }
        ball = room.body("ball", Material::steel, circlePiece(0.1), {-1, height + 0.1});
    }
    /// The number of the next frames in which the right contact is on.
    int framesOn(int frames) {
        int on = 0;
        for (int i = 0; i < frames; ++i) {
            room.run(1);
            on += room.world->find<ElectricalState>()->isOn(right) ? 1 : 0;
        }
        return on;
    }
    ListeningRoom room;
    ObjectId sensor;
    ObjectId left;
    ObjectId right;
    ObjectId ball;
};

TEST(SoundSensor, ConductsOnlyWhenItIsLoudEnough) {
    for (bool const named : {true, false}) {
        Alarm loud(85, 2, false, named);
        int const on = loud.framesOn(240);
        EXPECT_GT(on, 3) << named;
        EXPECT_LT(on, 200) << "it stops when it is quiet again";
        EXPECT_EQ(loud.framesOn(120), 0);
        EXPECT_FALSE(connectionBetween(loud.room.world->store(), loud.left, loud.right).any());
        Alarm soft(85, 0.002, false, named);
        EXPECT_EQ(soft.framesOn(240), 0) << named;
        Alarm deaf(139, 2, false, named);
        EXPECT_EQ(deaf.framesOn(240), 0) << named;
    }
}

TEST(SoundSensor, HearsLessBehindAWall) {
    // Set the threshold slightly below the level without the wall: with the wall it is not reached.
    auto const loudest = [](bool wall) {
        Alarm alarm(85, 2, wall, true);
        double most = silentLevel;
        for (int i = 0; i < 240; ++i) {
            alarm.room.run(1);
            most = std::max(most, alarm.room.levelAt(alarm.sensor));
        }
        return most;
    };
    double const open = loudest(false);
    double const muted = loudest(true);
    EXPECT_LT(muted, open - 10);
    EXPECT_GT(Alarm(open - 3, 2, false, true).framesOn(240), 0);
    EXPECT_EQ(Alarm(open - 3, 2, true, true).framesOn(240), 0);
}

TEST(SoundSensor, TheTraceLeadsFromTheConnectionToTheStroke) {
    Alarm alarm(85, 2, false, true, {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    alarm.framesOn(240);
    Tracer const& tracer = *alarm.room.world->tracer();
    bool found = false;
    for (Event const& event : tracer.events()) {
        if (event.event != "on" || event.objects != std::vector<std::string>{"right contact"}) {
            continue;
        }
        bool struck = false;
        bool touched = false;
        for (EventId const cause : tracer.chain(event.id)) {
            struck = struck || tracer.find(cause)->event == "strike";
            touched = touched || tracer.find(cause)->event == "contact begun";
        }
        EXPECT_TRUE(struck && touched);
        found = true;
    }
    EXPECT_TRUE(found);
}

TEST(SoundSensor, KeepsItsStateWhenTheDetailLevelIsSwapped) {
    Alarm alarm(60, 2, false, true);
    for (int i = 0; i < 300; ++i) {
        alarm.room.run(1);
        if (i % 7 == 3) {
            alarm.room.world->setDetail("loudness", i % 2 == 0 ? "straight" : "around");
            alarm.room.world->setDetail("sound", i % 2 == 0 ? "4-modes" : "8-modes");
        }
        for (CallerCounts::Entry const& entry :
             connectionBetween(alarm.room.world->store(), alarm.left, alarm.right).entries()) {
            EXPECT_EQ(entry.caller.name(), "Electricity <- Sound");
            EXPECT_EQ(entry.count, 1);
        }
    }
    alarm.room.run(600);
    EXPECT_FALSE(connectionBetween(alarm.room.world->store(), alarm.left, alarm.right).any());
}

TEST(Recordings, AStruckObjectPlaysItsOwnOncePerImpact) {
    ListeningRoom room;
    Subscription const wantedSounds = room.world->want<Sounds>();
    room.fixed("floor", Material::stone, boxPiece(20, 0.4), {0, -0.2});
    ObjectId const duck = room.body("duck", Material::rubber, boxPiece(0.2, 0.2), {0, 0.6});
    Sample sample;
    sample.file = "quack.ogg";
    sample.level = 70;
    sample.duration = 0.5;
    sample.fullImpulse = 1e-3;
    room.give(duck, sample);
    ASSERT_TRUE(room.runToImpact());
    ASSERT_EQ(room.sounds().recordings.size(), 1U);
    EXPECT_EQ(room.sounds().recordings[0].file, "quack.ogg");
    EXPECT_NEAR(room.sounds().recordings[0].meanSquare, meanSquareOf(70), 1e-9);
    room.run(600);
    EXPECT_TRUE(room.sounds().recordings.empty());
}

} // namespace
} // namespace trembler

// Sound in a running world: which objects sound, and that listening changes nothing else.
#include "audio/effect/properties/acoustic_material.hpp"
#include "tests/audio/effect/listening_room.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace trembler {
namespace world_sound_test {
namespace {

using test::ListeningRoom;

ObjectId addFloor(ListeningRoom& room, Material material = Material::stone) {
    return room.fixed("floor", material, boxPiece(10, 0.4), {0, -0.2});
}

double total(Sounds::Body const& body) {
    return std::accumulate(body.rings.begin(), body.rings.end(), 0.0,
                           [](double sum, Sounds::Ring const& ring) { return sum + ring.meanSquare; });
}

TEST(WorldSound, IsAbsentWithoutListeners) {
    ListeningRoom room;
    addFloor(room);
    room.body("ball", Material::steel, circlePiece(0.1), {0, 1});
    room.run(90);
    for (char const* name :
         {"Sound, 8 modes", "Sound <- Dynamics", "Straight Loudness", "Electricity <- Sound"}) {
        EXPECT_EQ(room.of(name), Activity::absent) << name;
    }
    EXPECT_TRUE(room.world->find<Impacts>()->impacts.empty()) << "impacts are not computed either";
}

TEST(WorldSound, AnImpactIsHeardInTheNextFrameAndDiesAway) {
    ListeningRoom room;
    ObjectId const floor = addFloor(room);
    ObjectId const bar = room.body("bar", Material::steel, boxPiece(1, 0.05), {0, 0.5}, 0.1);
    Subscription const wantedSounds = room.world->want<Sounds>();
    Subscription const wantedImpacts = room.world->want<Impacts>();
    std::uint64_t struckIn = 0;
    for (int i = 0; i < 120 && struckIn == 0; ++i) {
        room.run(1);
        EXPECT_TRUE(room.sounds().silent());
        struckIn = room.world->find<Impacts>()->impacts.empty() ? 0 : room.world->frame();
    }
    ASSERT_NE(struckIn, 0U);
    room.run(1);
    ASSERT_EQ(room.sounds().impacts.size(), 2U) << "one for each body";
    ASSERT_NE(room.sounding(bar), nullptr);
    ASSERT_NE(room.sounding(floor), nullptr);
    EXPECT_GT(room.sounding(bar)->loudness, meanSquareOf(60));
    room.run(180);
    ASSERT_NE(room.sounding(bar), nullptr);
    double const before = total(*room.sounding(bar));
    room.run(30);
    ASSERT_NE(room.sounding(bar), nullptr);
    EXPECT_LT(total(*room.sounding(bar)), before);
    room.run(3600);
    EXPECT_TRUE(room.sounds().silent()) << "steel has died away after a minute";
    EXPECT_EQ(room.of("Sound, 8 modes"), Activity::asleep);
}

TEST(WorldSound, DecaysAtTheRatesOfItsModes) {
    ListeningRoom room;
    Subscription const wantedSounds = room.world->want<Sounds>();
    addFloor(room);
    ObjectId const bar = room.body("bar", Material::copper, boxPiece(0.8, 0.04), {0, 0.3}, 0.3);
    ASSERT_TRUE(room.runToImpact());
    // Over every frame in which nothing excites it.
    int compared = 0;
    for (int frame = 0; frame < 240; ++frame) {
        ASSERT_NE(room.sounding(bar), nullptr);
        auto const before = room.sounding(bar)->rings;
        room.run(1);
        if (!room.sounds().impacts.empty() || !room.sounds().scrapes.empty()) {
            continue;
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (double const after = room.sounding(bar)->rings[i].meanSquare; after > 0) {
                EXPECT_NEAR(std::log(before[i].meanSquare / after), 2 * before[i].decay / 60, 1e-6);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 100);
}

struct Heard {
    double level = 0;
    double brightness = 0;
};
// A ball thrown down onto a plate.
Heard thrown(double speed, Material ballMaterial = Material::steel,
             Material plateMaterial = Material::steel) {
    ListeningRoom room;
    Subscription const wantedSounds = room.world->want<Sounds>();
    room.give(room.world->store().find("world"), GravityField{{0, 0}});
    ObjectId const plate = room.fixed("plate", plateMaterial, boxPiece(1, 0.25), {0, 0});
    Acoustics hung;
    hung.form = SoundingForm::plate;
    room.give(plate, hung);
    ObjectId const ball = room.body("ball", ballMaterial, circlePiece(0.05), {0.37, 0.5});
    room.give(ball, Velocity{{0, -speed}});
    if (!room.runToImpact()) {
        return {};
    }
    return {levelOf(room.sounding(plate)->loudness), room.sounding(plate)->brightness};
}

TEST(WorldSound, HarderIsLouderAndBrighter) {
    Heard const gentle = thrown(0.5);
    Heard const firm = thrown(2);
    Heard const hard = thrown(8);
    EXPECT_GT(firm.level, gentle.level + 10);
    EXPECT_GT(hard.level, firm.level + 10);
    EXPECT_GT(firm.brightness, gentle.brightness);
    EXPECT_GT(hard.brightness, firm.brightness);
}

TEST(WorldSound, SoftBodiesSoundDullerThanHardOnes) {
    EXPECT_LT(thrown(3, Material::rubber).brightness, 0.5 * thrown(3, Material::steel).brightness);
    EXPECT_LT(thrown(3, Material::rubber).level, thrown(3, Material::steel).level);
}

TEST(WorldSound, SlidingAndRollingAreHeardAndRestIsNot) {
    ListeningRoom room;
    Subscription const wantedSounds = room.world->want<Sounds>();
    ObjectId const floor = addFloor(room);
    ObjectId const box = room.body("box", Material::wood, boxPiece(0.4, 0.2), {-3, 0.1});
    room.give(box, Velocity{{4, 0}});
    ObjectId const ball = room.body("ball", Material::iron, circlePiece(0.15), {1, 0.15});
    room.give(ball, Velocity{{1.5, 0}});
    room.give(ball, AngularVelocity{-10});
    room.run(20);
    auto const scraped = [&](ObjectId id) {
        for (Sounds::Scrape const& scrape : room.sounds().scrapes) {
            if (scrape.object == id) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(scraped(box)) << "it slides";
    EXPECT_TRUE(scraped(floor));
    EXPECT_GT(room.sounding(box)->loudness, meanSquareOf(30));
    room.run(100);
    EXPECT_FALSE(scraped(box)) << "it has come to rest";
    EXPECT_TRUE(scraped(floor)) << "the ball still rolls";
    room.run(60 * 60);
    EXPECT_TRUE(room.sounds().silent());
}

// Objects with every kind of sound, and a sound sensor whose threshold is never reached.
void furnish(ListeningRoom& room) {
    addFloor(room);
    for (int i = 0; i < 8; ++i) {
        room.body("box " + std::to_string(i), static_cast<Material>(i), boxPiece(0.3, 0.2),
                  {-2 + 0.5 * i, 0.5 + 0.2 * i}, 0.3 * i);
        room.body("ball " + std::to_string(i), static_cast<Material>(i), circlePiece(0.1),
                  {-2.2 + 0.55 * i, 1.5 + 0.3 * i});
    }
    ObjectId const bell = room.fixed("bell", Material::gold, boxPiece(0.3, 0.3), {0.2, 0.4});
    Acoustics acoustics;
    acoustics.form = SoundingForm::bell;
    room.give(bell, acoustics);
}

TEST(WorldSound, ABodyThatFallsIntoWaterSplashesOnce) {
    auto const loudest = [](double height, double* later) {
        ListeningRoom room;
        Subscription const wantedSounds = room.world->want<Sounds>();
        ObjectId const pond = room.world->store().create("pond");
        room.give(pond, Shape{{boxPiece(6, 2)}});
        room.give(pond, Position{{0, -1}});
        room.give(pond, Liquid{});
        room.give(pond, Density{1000});
        ObjectId const raft = room.body("raft", Material::wood, boxPiece(0.6, 0.3), {0, height + 0.15});
        room.give(raft, Density{500});
        double most = silentLevel;
        for (int i = 0; i < 150; ++i) {
            room.run(1);
            Sounds::Body const* const heard = room.sounding(pond);
            most = std::max(most, heard == nullptr ? silentLevel : levelOf(heard->loudness));
        }
        room.run(60 * 30);
        Sounds::Body const* const heard = room.sounding(pond);
        *later = heard == nullptr ? silentLevel : levelOf(heard->loudness);
        return most;
    };
    double later = 0;
    double const gentle = loudest(0.1, &later);
    EXPECT_LT(later, 30) << "a floating body is silent";
    double const hard = loudest(2, &later);
    EXPECT_LT(later, 30);
    EXPECT_GT(gentle, 40);
    EXPECT_GT(hard, gentle + 6);
}

TEST(WorldSound, ListeningChangesNoState) {
    ListeningRoom deaf;
    ListeningRoom listening;
    ListeningRoom joining;
    furnish(deaf);
    furnish(listening);
    furnish(joining);
    Subscription const wantedSounds = listening.world->want<Sounds>();
    deaf.start();
    listening.start();
    joining.start();
    Subscription joined;
    for (int i = 0; i < 300; ++i) {
        if (i % 50 == 25) {
            joined = joining.world->want<Sounds>();
        } else if (i % 50 == 49) {
            joined.end();
        }
        if (i % 30 == 0) {
            for (ListeningRoom* room : {&deaf, &listening, &joining}) { // subscriptions are part of the state
                room->world->setDetail("sound", i % 60 == 0 ? "4-modes" : "32-modes");
            }
        }
        deaf.run(1);
        listening.run(1);
        joining.run(1);
        ASSERT_EQ(deaf.world->stateHash(), listening.world->stateHash()) << i;
        ASSERT_EQ(deaf.world->stateHash(), joining.world->stateHash()) << i;
    }
}

TEST(WorldSound, IsTheSameForAnyNumberOfThreads) {
    auto const heard = [](int threads) {
        ListeningRoom room(
            {.threads = threads, .detail = {}, .periods = {}, .trace = false, .rowsWorthThreads = 0});
        furnish(room);
        ObjectId const ear = room.ear("ear", {1, 2});
        std::vector<double> levels;
        for (int i = 0; i < 240; ++i) {
            room.run(1);
            levels.push_back(room.levelAt(ear));
            for (Sounds::Body const& body : room.sounds().bodies) {
                levels.push_back(total(body));
            }
        }
        return levels;
    };
    auto const one = heard(1);
    EXPECT_GT(*std::max_element(one.begin(), one.end()), 60);
    EXPECT_EQ(one, heard(2));
    EXPECT_EQ(one, heard(8));
}

TEST(WorldSound, RingingContinuesWhenTheNumberOfModesIsSwapped) {
    ListeningRoom room;
    Subscription const wantedSounds = room.world->want<Sounds>();
    addFloor(room);
    ObjectId const bar = room.body("bar", Material::steel, boxPiece(1, 0.05), {0, 0.4}, 0.2);
    ASSERT_TRUE(room.runToImpact());
    room.run(120);
    ASSERT_NE(room.sounding(bar), nullptr);
    auto const rings = room.sounding(bar)->rings;
    ASSERT_EQ(rings.size(), 8U);
    room.world->setDetail("sound", "4-modes");
    room.run(1);
    ASSERT_EQ(room.sounding(bar)->rings.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(room.sounding(bar)->rings[i].frequency, rings[i].frequency);
        EXPECT_LE(room.sounding(bar)->rings[i].meanSquare, rings[i].meanSquare);
    }
    EXPECT_GT(room.sounding(bar)->rings[0].meanSquare, 0.5 * rings[0].meanSquare) << "it rings on";
    room.world->setDetail("sound", "16-modes");
    room.run(1);
    EXPECT_GT(room.sounding(bar)->rings.size(), 8U);
}

TEST(WorldSound, ARemovedObjectIsSilent) {
    ListeningRoom room;
    Subscription const wantedSounds = room.world->want<Sounds>();
    addFloor(room);
    ObjectId const bar = room.body("bar", Material::steel, boxPiece(1, 0.05), {0, 0.4}, 0.2);
    ASSERT_TRUE(room.runToImpact());
    room.world->feed({.kind = PlayerInput::Kind::remove, .object = bar, .other = {}, .at = {}});
    room.run(4);
    EXPECT_EQ(room.sounding(bar), nullptr);
}

TEST(WorldSound, TheTraceLeadsFromTheTouchToTheStroke) {
    ListeningRoom room({.threads = 1, .detail = {}, .periods = {}, .trace = true});
    addFloor(room);
    room.body("ball", Material::steel, circlePiece(0.1), {0, 0.5});
    Subscription const wantedSounds = room.world->want<Sounds>();
    ASSERT_TRUE(room.runToImpact());
    bool found = false;
    for (Event const& event : room.world->tracer()->events()) {
        if (event.event == "strike") {
            ASSERT_EQ(event.causes.size(), 1U);
            EXPECT_EQ(room.world->tracer()->find(event.causes[0])->event, "contact begun");
            found = true;
        }
    }
    EXPECT_TRUE(found);
}

} // namespace
} // namespace world_sound_test
} // namespace trembler

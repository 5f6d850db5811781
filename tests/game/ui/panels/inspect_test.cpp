// The inspector's rows about sound. (play_screen_test tests other rows.)
#include "audio/effect/properties/acoustics.hpp"
#include "audio/effect/properties/decibel.hpp"
#include "audio/effect/properties/loudness.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "game/ui/panels/inspector.hpp"
#include "puzzle/session/session.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>
#include <optional>

namespace trembler::ui::test {
namespace {

std::optional<std::string> rowOf(World const& world, ObjectId object, std::string const& name) {
    for (InspectorSection const& section : inspect(world, object)) {
        for (InspectorRow const& row : section.rows) {
            if (section.title == "Right now" && row.name == name) {
                return row.value;
            }
        }
    }
    return std::nullopt;
}

struct SoundWorld {
    World world{gameData().registry};
    ObjectId bell = world.store().create("bell");
    ObjectId ear = world.store().create("ear");
    ObjectId sensor = world.store().create("sensor");

    SoundWorld() {
        world.store().column<Ear>().set(ear, {});
        world.store().column<SoundSensor>().set(sensor, {});
    }
};

TEST(Inspect, ShowsHowLoudAnObjectIs) {
    SoundWorld w;
    EXPECT_EQ(rowOf(w.world, w.bell, "sounds"), std::nullopt);
    Sounds& sounds = w.world.store().slot<Sounds>().value();
    Sounds::Body body;
    body.object = w.bell;
    body.loudness = 4e-10 * 1e7; // 70 dB above (20 µPa)²
    sounds.bodies = {body};
    EXPECT_EQ(rowOf(w.world, w.bell, "sounds"), "70.0 dB(A)");
    Sounds::Recording recording;
    recording.object = w.bell;
    recording.loudness = body.loudness;
    sounds.recordings = {recording};
    EXPECT_EQ(rowOf(w.world, w.bell, "sounds"), "73.0 dB(A)") << "twice the energy";
    EXPECT_EQ(rowOf(w.world, w.ear, "sounds"), std::nullopt);
}

TEST(Inspect, ShowsTheSoundLevelAtAnEar) {
    SoundWorld w;
    EXPECT_EQ(rowOf(w.world, w.ear, "hears"), std::nullopt) << "not known before the run";
    w.world.store().slot<Loudness>().value().entries = {{w.ear, 61.4, w.bell, {}},
                                                        {w.sensor, silentLevel, {}, {}}};
    EXPECT_EQ(rowOf(w.world, w.ear, "hears"), "61.4 dB(A)");
    EXPECT_EQ(rowOf(w.world, w.sensor, "hears"), "silence");
    EXPECT_EQ(rowOf(w.world, w.bell, "hears"), std::nullopt) << "it does not listen";
}

TEST(Inspect, TheSensorsCircuitClosesAtItsThreshold) {
    Session session(gameData().registry, gameData().parts,
                    loadLevel(gameData().registry, levelsFolder() / "sound/1-loud-enough.json"), {});
    session.load(findOrLoadSolution(gameData().registry, session.level(), "ring the bell"));
    World const* world = nullptr;
    int loud = 0;
    for (int i = 0; i < 300; ++i) {
        session.step();
        world = &session.world();
        auto const row = rowOf(*world, world->store().find("sound sensor 1"), "hears");
        ASSERT_TRUE(row) << i;
        loud += *row != "silence" && std::stod(*row) >= 85 ? 1 : 0; // the threshold of its part
    }
    EXPECT_GT(loud, 60);
    EXPECT_LT(loud, 240) << "it dies away";
}

TEST(Inspect, InTheWindowTheBellIsHeardWithoutALoudspeaker) {
    Player player({960, 540});
    player.open(levelsFolder() / "experiments/2-doorbell.json");
    player.clickItem("run");
    double loudest = 0;
    for (int i = 0; i < 30; ++i) {
        player.simulate(8);
        World const& world = player.session().world();
        if (auto const row = rowOf(world, world.store().find("bell"), "sounds")) {
            loudest = std::max(loudest, std::stod(*row));
        }
    }
    EXPECT_GT(loudest, 60) << "as loud as speech";
    EXPECT_LT(loudest, 140);
}

} // namespace
} // namespace trembler::ui::test

// Loudspeaker: from the Sounds of a world to the rendered samples.
#include "audio/device/loudspeaker.hpp"
#include "audio/device/openal_output.hpp"
#include "tests/audio/effect/listening_room.hpp"
#include "tests/audio/synth/spectrum.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace loudspeaker_test {
namespace {

using test::ListeningRoom;
using test::meanSquareIn;

/// A loudspeaker that plays into memory.
struct Speaker {
    Speaker() {
        std::string why;
        auto made = OpenAlOutput::loopback({}, why);
        EXPECT_NE(made, nullptr) << why;
        output = made.get();
        loudspeaker = std::make_unique<Loudspeaker>(LoudspeakerOptions{}, std::move(made));
    }
    /// Steps the world and stores the rendered samples.
    void run(ListeningRoom& room, int frames, Listener const& listener) {
        for (int i = 0; i < frames; ++i) {
            room.run(1);
            loudspeaker->frame(*room.world, listener);
            keep();
        }
    }
    void keep() {
        auto const block = output->rendered();
        for (std::size_t n = 0; n + 1 < block.size(); n += 2) {
            left.push_back(block[n]);
            right.push_back(block[n + 1]);
        }
    }
    OpenAlOutput* output = nullptr;
    std::unique_ptr<Loudspeaker> loudspeaker;
    std::vector<float> left;
    std::vector<float> right;
};

void addFloor(ListeningRoom& room) {
    room.fixed("floor", Material::stone, boxPiece(12, 0.4), {0, -0.2});
}

TEST(Loudspeaker, ABallThatFallsOnTheLeftIsHeardOnTheLeft) {
    ListeningRoom room;
    addFloor(room);
    room.body("ball", Material::wood, circlePiece(0.1), {-3, 1});
    Speaker speaker;
    speaker.loudspeaker->enter(*room.world);
    speaker.run(room, 90, {{0, 1}, 3, {}});
    EXPECT_GT(meanSquareIn(speaker.left), 1.5 * meanSquareIn(speaker.right));
    EXPECT_GT(meanSquareIn(speaker.left), 1e-8);
    std::span<float const> const falling = std::span(speaker.left).subspan(0, 20 * 800);
    EXPECT_EQ(meanSquareIn(falling), 0) << "silent before it lands";
}

TEST(Loudspeaker, ListeningChangesNoState) {
    auto const furnish = [](ListeningRoom& room) {
        addFloor(room);
        for (int i = 0; i < 6; ++i) {
            room.body("box " + std::to_string(i), Material::wood, boxPiece(0.3, 0.2),
                      {0.1 * i, 0.5 + 0.4 * i}, 0.2 * i);
        }
    };
    ListeningRoom heard;
    ListeningRoom deaf;
    furnish(heard);
    furnish(deaf);
    Speaker speaker;
    speaker.loudspeaker->enter(*heard.world);
    for (int i = 0; i < 200; ++i) {
        speaker.run(heard, 1, {{0, 1}, 3, {}});
        deaf.run(1);
        ASSERT_EQ(heard.world->stateHash(), deaf.world->stateHash());
    }
    EXPECT_GT(meanSquareIn(speaker.left), 0);
}

TEST(Loudspeaker, EqualRunsMakeEqualSamples) {
    auto const play = [] {
        ListeningRoom room;
        addFloor(room);
        room.body("bar", Material::steel, boxPiece(0.8, 0.05), {-1, 1}, 0.4);
        room.body("ball", Material::glass, circlePiece(0.1), {1, 1.4});
        Speaker speaker;
        speaker.loudspeaker->enter(*room.world);
        speaker.run(room, 120, {{0, 1}, 3, {}});
        return speaker.left;
    };
    EXPECT_EQ(play(), play());
}

TEST(Loudspeaker, SoundsDieAwayInAPause) {
    ListeningRoom room;
    addFloor(room);
    room.body("bar", Material::steel, boxPiece(0.8, 0.05), {0, 0.6}, 0.4);
    Speaker speaker;
    speaker.loudspeaker->enter(*room.world);
    speaker.run(room, 60, {{0, 1}, 3, {}});
    std::vector<double> levels;
    for (int second = 0; second < 4; ++second) {
        speaker.left.clear();
        for (int i = 0; i < 60; ++i) {
            speaker.loudspeaker->pause({{0, 1}, 3, {}});
            speaker.keep();
        }
        levels.push_back(meanSquareIn(speaker.left));
    }
    EXPECT_GT(levels[0], 0);
    EXPECT_LT(levels[1], levels[0]);
    EXPECT_LT(levels[3], 0.1 * levels[0]);
}

TEST(Loudspeaker, AnotherWorldBeginsInSilence) {
    Speaker speaker;
    ListeningRoom next;
    next.body("bar", Material::steel, boxPiece(0.8, 0.05), {0, 50});
    {
        ListeningRoom room;
        addFloor(room);
        room.body("bar", Material::steel, boxPiece(0.8, 0.05), {0, 0.6}, 0.4);
        speaker.loudspeaker->enter(*room.world);
        OutputSettings dry;
        dry.reverb = false;
        speaker.loudspeaker->set(dry);
        speaker.run(room, 60, {{0, 1}, 3, {}});
        EXPECT_GT(meanSquareIn(speaker.left), 0);
    } // the world is destroyed without a call of leave()
    speaker.loudspeaker->enter(*next.world);
    speaker.left.clear();
    speaker.run(next, 30, {{0, 1}, 3, {}});
    EXPECT_EQ(meanSquareIn(speaker.left), 0);
    EXPECT_NE(next.of("Sound, 8 modes"), Activity::absent);
    speaker.loudspeaker->leave();
    next.run(1);
    EXPECT_EQ(next.of("Sound, 8 modes"), Activity::absent);
}

TEST(Loudspeaker, ReportsAMissingDeviceOnceAndContinues) {
    std::vector<std::string> reports;
    Loudspeaker loudspeaker({}, [&](std::string const& what) { reports.push_back(what); });
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_NE(reports[0].find("no sound"), std::string::npos);
    EXPECT_FALSE(loudspeaker.output().audible());
    ListeningRoom room;
    addFloor(room);
    room.body("ball", Material::steel, circlePiece(0.1), {0, 1});
    loudspeaker.enter(*room.world);
    for (int i = 0; i < 90; ++i) {
        room.run(1);
        loudspeaker.frame(*room.world, {});
    }
    EXPECT_EQ(room.of("Sound, 8 modes"), Activity::absent) << "without a listener the sound is not computed";
    loudspeaker.leave();
}

} // namespace
} // namespace loudspeaker_test
} // namespace trembler

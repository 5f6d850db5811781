// Worlds written into sound files, read back with independent code.
#include "audio/device/openal_output.hpp"
#include "audio/device/sound_file.hpp"
#include "tests/audio/device/wav.hpp"
#include "tests/audio/effect/listening_room.hpp"
#include "tests/audio/synth/spectrum.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

class SoundFiles : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) / ("sound files " + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    static constexpr Listener listener{{0, 1}, 3, {}};

    /// A ball that falls to the left of the listener, or no ball.
    static std::unique_ptr<test::ListeningRoom> room(bool ball) {
        auto made = std::make_unique<test::ListeningRoom>();
        made->fixed("floor", Material::stone, boxPiece(12, 0.4), {0, -0.2});
        if (ball) {
            made->body("ball", Material::glass, circlePiece(0.1), {-2, 1});
        }
        return made;
    }
    test::Wav write(std::string const& name, bool ball, int frames) const {
        auto const heard = room(ball);
        SoundFile file(folder / name, {});
        file.enter(*heard->world);
        for (int i = 0; i < frames; ++i) {
            heard->run(1);
            file.frame(*heard->world, listener);
        }
        file.finish();
        return test::Wav(folder / name);
    }

    fs::path folder;
};

TEST_F(SoundFiles, ContainTheSamplesOfTheLoudspeaker) {
    constexpr int frames = 90;
    test::Wav const file = write("ball.wav", true, frames);
    EXPECT_EQ(file.rate, 48000U);
    EXPECT_EQ(file.channels, 2);
    EXPECT_EQ(file.bits, 16);
    ASSERT_EQ(file.left.size(), frames * 800U);
    EXPECT_GT(test::meanSquareIn(file.left), 1.5 * test::meanSquareIn(file.right)) << "it fell on the left";

    auto const heard = room(true);
    std::string why;
    auto output = OpenAlOutput::loopback({}, why);
    ASSERT_NE(output, nullptr) << why;
    OpenAlOutput& played = *output;
    Loudspeaker loudspeaker({}, std::move(output));
    loudspeaker.enter(*heard->world);
    double furthest = 0;
    for (int i = 0; i < frames; ++i) {
        heard->run(1);
        loudspeaker.frame(*heard->world, listener);
        for (std::size_t n = 0; n < 800; ++n) {
            auto const at = static_cast<std::size_t>(i) * 800 + n;
            furthest = std::max(furthest, std::abs(static_cast<double>(played.rendered()[2 * n]) -
                                                   static_cast<double>(file.left[at])));
        }
    }
    EXPECT_LT(furthest, 1.01 / 32768) << "equal up to rounding";
}

TEST_F(SoundFiles, AreTheSameBitForBit) {
    EXPECT_EQ(write("one.wav", true, 60).bytes, write("two.wav", true, 60).bytes);
}

TEST_F(SoundFiles, AreSilentWhereNothingHappens) {
    test::Wav const file = write("silence.wav", false, 60);
    ASSERT_EQ(file.left.size(), 60 * 800U);
    EXPECT_EQ(test::meanSquareIn(file.left), 0);
    EXPECT_EQ(test::meanSquareIn(file.right), 0);
}

TEST_F(SoundFiles, ReportErrors) {
    EXPECT_THROW(SoundFile(folder / "sound.mp3", {}), std::invalid_argument);
    EXPECT_THROW(SoundFile(folder / "nowhere" / "sound.wav", {}), OutputError);
    if (fs::exists("/dev/full")) { // a full disk
        fs::create_symlink("/dev/full", folder / "full.wav");
        auto const writing = [&] { write("full.wav", true, 60); };
        EXPECT_ANY_THROW(writing());
    }
}

TEST_F(SoundFiles, KnowForWhichRunTheyHaveRoom) {
    std::uint64_t const most = SoundFile::mostFrames(48000);
    EXPECT_LT(most * 800 * 4, std::uint64_t{1} << 32U) << "the lengths in the file have 32 bits";
    EXPECT_GT((most + 3) * 800 * 4, std::uint64_t{1} << 32U);
}

TEST_F(SoundFiles, ReplaceNothingUntilTheyAreComplete) {
    test::Wav const first = write("sound.wav", true, 30);
    {
        auto const heard = room(true);
        SoundFile file(folder / "sound.wav", {});
        file.enter(*heard->world);
        for (int i = 0; i < 60; ++i) {
            heard->run(1);
            file.frame(*heard->world, listener);
        }
    }
    test::Wav const second(folder / "sound.wav");
    EXPECT_EQ(second.left, first.left);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

} // namespace
} // namespace trembler

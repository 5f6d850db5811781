// Sound files written with one library interface and read with another.
#include "audio/device/sample_files.hpp"
#include "tests/audio/synth/spectrum.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sndfile.h>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

class SampleFilesTest : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) / ("samples " + std::to_string(getpid()));
        fs::create_directories(folder / "inner");
    }
    void TearDown() override { fs::remove_all(folder); }

    /// A tone of half a second, in the format of this name in libsndfile.
    void write(std::string const& name, int form, int rate, int channels) const {
        SF_INFO info{};
        info.samplerate = rate;
        info.channels = channels;
        info.format = form;
        SNDFILE* const file = sf_open((folder / name).c_str(), SFM_WRITE, &info);
        ASSERT_NE(file, nullptr) << sf_strerror(nullptr);
        std::vector<float> frames;
        for (int n = 0; n < rate / 2; ++n) {
            for (int c = 0; c < channels; ++c) {
                frames.push_back(static_cast<float>(0.5 * std::sin(2 * pi * 1000.0 * n / rate)));
            }
        }
        sf_writef_float(file, frames.data(), rate / 2);
        sf_close(file);
    }
    [[nodiscard]] SampleFiles files(SampleLimits const& limits = {}) {
        return SampleFiles(
            {"/nowhere at all", folder}, [this](std::string const& what) { reports.push_back(what); },
            limits);
    }
    /// A WAV file of 16 bits, mono, at 8 kHz: 8,000 samples take 32,000 bytes of memory for each second.
    void writePlain(std::string const& name) const { write(name, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 8000, 1); }
    static constexpr std::size_t plainBytes = 4000 * sizeof(float); ///< of half a second

    fs::path folder;
    std::vector<std::string> reports;
};

TEST_F(SampleFilesTest, ReadsOggWavAndFlac) {
    write("a.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS, 44100, 2);
    write("b.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 22050, 1);
    write("inner/c.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_24, 48000, 1);
    SampleFiles source = files();
    for (std::string const name : {"a.ogg", "b.wav", "inner/c.flac"}) {
        auto const data = source.find(name);
        ASSERT_NE(data, nullptr) << name;
        EXPECT_NEAR(static_cast<double>(data->samples.size()) / data->rate, 0.5, 0.01) << name;
        EXPECT_NEAR(data->rootMeanSquare, 0.5 / std::sqrt(2.0), 0.01) << name;
        EXPECT_NEAR(test::peakNear(data->samples, data->rate, 1000, 30), 1000, 1) << name;
        EXPECT_EQ(source.find(name), data) << "read once";
    }
    EXPECT_TRUE(reports.empty());
}

TEST_F(SampleFilesTest, ReportsOnceWhyARecordingCannotBePlayed) {
    std::ofstream(folder / "noise.ogg") << "this is not a recording";
    write("cut.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, 1);
    fs::resize_file(folder / "cut.wav", 20);
    write("empty.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, 1);
    fs::resize_file(folder / "empty.wav", 44);
    SampleFiles source = files();
    for (std::string const name : {"gone.ogg", "noise.ogg", "cut.wav", "empty.wav", "inner"}) {
        EXPECT_EQ(source.find(name), nullptr) << name;
        EXPECT_EQ(source.find(name), nullptr) << name;
        ASSERT_FALSE(reports.empty());
        EXPECT_NE(reports.back().find(name), std::string::npos) << reports.back();
    }
    EXPECT_EQ(reports.size(), 5U);
}

TEST_F(SampleFilesTest, ReadsNoFileOutsideItsFolders) {
    write("secret.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, 1);
    SampleFiles source({folder / "inner"});
    EXPECT_EQ(source.find("../secret.wav"), nullptr);
    EXPECT_EQ(source.find((folder / "secret.wav").string()), nullptr);
}

TEST_F(SampleFilesTest, KeepsAFileOnceHoweverItsPathIsSpelled) {
    write("a.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 8000, 1);
    fs::create_hard_link(folder / "a.flac", folder / "hard.flac");
    fs::create_symlink(folder / "a.flac", folder / "inner" / "soft.flac");
    fs::create_directory_symlink(folder, folder / "inner" / "again");
    SampleFiles source = files();
    auto const first = source.find("a.flac");
    ASSERT_NE(first, nullptr);
    std::string deep = "a.flac";
    for (int i = 0; i < 20; ++i) {
        deep = "inner/again/" + deep;
    }
    for (std::string const& name :
         {std::string("./a.flac"), std::string(".//./a.flac"), std::string("hard.flac"),
          std::string("inner/soft.flac"), std::string("inner/again/a.flac"), deep}) {
        EXPECT_EQ(source.find(name), first) << name;
    }
    EXPECT_EQ(source.bytes(), plainBytes);
    EXPECT_TRUE(reports.empty());
}

TEST_F(SampleFilesTest, RefusesOneThatIsTooLongByTheLengthThatItStates) {
    SampleLimits const seconds{.seconds = 0.4};
    SampleLimits const bytes{.bytes = plainBytes - 1};
    for (auto const& [limits, expected] :
         {std::pair(seconds, "it is 0.5 s long; expected at most 0.4 s"),
          std::pair(bytes, "its 4000 samples at 8000 Hz take 0.0 MB of memory; expected at most 0.0 MB: a "
                           "shorter recording, or a lower rate")}) {
        write("a.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 8000, 1);
        fs::resize_file(folder / "a.flac", 200); // nothing behind the header can be decoded
        reports.clear();
        SampleFiles source = files(limits);
        EXPECT_EQ(source.find("a.flac"), nullptr);
        EXPECT_EQ(reports, std::vector<std::string>{
                               std::string("the recording \"a.flac\" cannot be played: ") + expected});
        EXPECT_EQ(source.bytes(), 0U);
    }
    SampleFiles source = files(); // the same file within the limits
    reports.clear();
    EXPECT_EQ(source.find("a.flac"), nullptr);
    EXPECT_EQ(reports, std::vector<std::string>{"the recording \"a.flac\" cannot be played: there is nothing "
                                                "in it"});
}

TEST_F(SampleFilesTest, TheSumOfALevelIsLimitedAndTheOthersPlayOn) {
    for (std::string const name : {"a.wav", "b.wav", "c.wav", "d.wav"}) {
        writePlain(name);
    }
    SampleFiles source = files({.inAll = 2 * plainBytes});
    auto first = source.find("a.wav");
    auto second = source.find("b.wav");
    ASSERT_NE(first, nullptr);
    ASSERT_NE(second, nullptr);
    EXPECT_EQ(source.find("c.wav"), nullptr);
    EXPECT_EQ(source.find("c.wav"), nullptr);
    EXPECT_EQ(reports, std::vector<std::string>{"the recording \"c.wav\" cannot be played: with it the "
                                                "recordings of this level take 0.0 MB of memory; expected at "
                                                "most 0.0 MB together"});
    EXPECT_EQ(source.find("a.wav"), first);
    EXPECT_EQ(source.bytes(), 2 * plainBytes);
    // In the next level those that nobody plays make room, the one that is still played does not.
    source.newLevel();
    second.reset();
    EXPECT_NE(source.find("c.wav"), nullptr);
    EXPECT_EQ(source.find("d.wav"), nullptr) << "a.wav is played, c.wav is of this level";
    EXPECT_EQ(source.find("a.wav"), first);
    EXPECT_EQ(source.bytes(), 2 * plainBytes);
    EXPECT_EQ(reports.size(), 2U);
    source.newLevel();
    first.reset();
    EXPECT_NE(source.find("d.wav"), nullptr);
    EXPECT_NE(source.find("b.wav"), nullptr);
    EXPECT_EQ(source.bytes(), 2 * plainBytes);
}

TEST_F(SampleFilesTest, AFullStoreRefusesAFileBeforeItIsDecoded) {
    writePlain("a.wav");
    write("b.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 8000, 1);
    fs::resize_file(folder / "b.flac", 200);
    SampleFiles source = files({.inAll = plainBytes});
    auto const first = source.find("a.wav");
    EXPECT_EQ(source.find("b.flac"), nullptr);
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_NE(reports[0].find("recordings of this level take"), std::string::npos) << reports[0];
}

} // namespace
} // namespace trembler

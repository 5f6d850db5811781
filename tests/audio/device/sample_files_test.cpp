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
    [[nodiscard]] SampleFiles files() {
        return SampleFiles({"/nowhere at all", folder},
                           [this](std::string const& what) { reports.push_back(what); });
    }

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

} // namespace
} // namespace trembler

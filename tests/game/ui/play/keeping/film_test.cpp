// Clips and single pictures, without a screen: the pixels come from here.
#include "game/ui/play/keeping/film.hpp"
#include "tests/game/ui/player.hpp"

#include <fstream>
#include <iterator>

namespace trembler::ui::test {
namespace {

namespace fs = std::filesystem;

class Films : public testing::Test {
protected:
    Films() { fs::remove_all(folder); }

    void take(bool stepped) {
        film.take(
            [&] {
                ++read;
                return render::Image({4, 3});
            },
            stepped);
    }

    fs::path const folder = testFolder() / "films";
    Recorder recorder{folder};
    render::Toasts toasts;
    PendingWrites pending{toasts};
    Film film{recorder, toasts, pending};
    int read = 0; // pictures
};

TEST_F(Films, AreOneClipWithEverySecondFrame) {
    take(true);
    EXPECT_EQ(read, 0) << "no picture was requested";
    film.toggle();
    EXPECT_TRUE(film.recording());
    for (int i = 0; i < 7; ++i) {
        take(true);
        take(false); // the world is paused
    }
    EXPECT_EQ(read, 4);
    EXPECT_NEAR(film.seconds(), 7 / 60.0, 1e-12);
    film.toggle();
    take(true);
    EXPECT_EQ(read, 4);
    ASSERT_TRUE(fs::exists(folder / "clip-1.webp"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "nothing else is written";
    std::ifstream in(folder / "clip-1.webp", std::ios::binary);
    std::string const bytes(std::istreambuf_iterator<char>(in), {});
    EXPECT_EQ(bytes.substr(0, 4), "RIFF");
    EXPECT_EQ(bytes.substr(8, 4), "WEBP");
    EXPECT_EQ(toasts.count(), 2U) << "at the beginning, and the file's name at the end";
    film.end();
    EXPECT_EQ(toasts.count(), 2U) << "there is no clip to end";
}

TEST_F(Films, EndAfterAMinuteOfTheWorld) {
    film.toggle();
    for (int i = 0; i < 60 * 60 - 1; ++i) {
        take(true);
    }
    EXPECT_TRUE(film.recording());
    EXPECT_FALSE(fs::exists(folder / "clip-1.webp"));
    take(true);
    EXPECT_FALSE(film.recording());
    EXPECT_TRUE(fs::exists(folder / "clip-1.webp"));
    EXPECT_EQ(read, 60 * 30);
    take(true);
    EXPECT_EQ(read, 60 * 30);
}

TEST_F(Films, WithoutAnyFrameWriteNothing) {
    film.toggle();
    film.toggle();
    EXPECT_FALSE(film.recording());
    EXPECT_FALSE(fs::exists(folder / "clip-1.webp"));
}

TEST_F(Films, AreHalvedUntilTheyAreSmall) {
    render::Image image({6, 3});
    for (std::size_t i = 0; i < image.bytes().size(); ++i) {
        image.bytes()[i] = static_cast<std::uint8_t>(3 * i);
    }
    render::Image const half = halved(image);
    ASSERT_EQ(half.size(), (render::Size{3, 1}));
    for (int x = 0; x < 3; ++x) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            int const sum = image.at(2 * x, 0)[channel] + image.at(2 * x + 1, 0)[channel] +
                            image.at(2 * x, 1)[channel] + image.at(2 * x + 1, 1)[channel];
            EXPECT_NEAR(half.at(x, 0)[channel], sum / 4.0, 0.51);
        }
    }
}

TEST_F(Films, SinglePicturesAreTakenOnce) {
    film.wantPicture();
    take(false);
    take(false);
    EXPECT_EQ(read, 1);
    EXPECT_TRUE(fs::exists(folder / "picture-1.png"));
}

TEST_F(Films, EndIfTheyCannotBeWritten) {
    film.toggle();
    fs::remove_all(folder);
    std::ofstream(folder) << "not a folder";
    take(true);
    film.toggle();
    EXPECT_FALSE(film.recording());
    EXPECT_EQ(toasts.count(), 2U) << "that it begins, and the reason of the failure";
    EXPECT_NE(toasts.newest().find("The clip cannot be saved"), std::string::npos) << toasts.newest();
    film.toggle();
    EXPECT_FALSE(film.recording()) << "another one cannot begin either";
    fs::remove(folder);
    pending.pass(PendingWrites::patience);
    EXPECT_TRUE(fs::exists(folder / "clip-1.webp")) << "it was kept in memory";
    EXPECT_EQ(pending.waiting(), 0U);
}

TEST_F(Films, PicturesThatCannotBeWrittenAreTriedAgain) {
    std::ofstream(folder) << "not a folder";
    film.wantPicture();
    take(false);
    EXPECT_NE(toasts.newest().find("The picture cannot be saved"), std::string::npos) << toasts.newest();
    fs::remove(folder);
    pending.pass(PendingWrites::patience);
    EXPECT_TRUE(fs::exists(folder / "picture-1.png"));
    EXPECT_EQ(read, 1) << "it is the picture that was taken";
}

} // namespace
} // namespace trembler::ui::test

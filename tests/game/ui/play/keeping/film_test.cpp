// Films and single pictures, without a screen: the pixels come from here.
#include "game/ui/play/keeping/film.hpp"
#include "tests/game/ui/player.hpp"

#include <fstream>

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
    Film film{recorder, toasts};
    int read = 0; // pictures
};

TEST_F(Films, HaveAPictureForEachStep) {
    take(true);
    EXPECT_EQ(read, 0) << "no picture was requested";
    film.toggle();
    EXPECT_TRUE(film.recording());
    take(true);
    take(false); // the world is paused
    take(true);
    film.toggle();
    take(true);
    EXPECT_EQ(read, 2);
    EXPECT_TRUE(fs::exists(folder / "film-1" / "frame-00002.png"));
    EXPECT_FALSE(fs::exists(folder / "film-1" / "frame-00003.png"));
    EXPECT_EQ(toasts.count(), 2U) << "the file's name at the beginning and at the end";
    film.end();
    EXPECT_EQ(toasts.count(), 2U) << "there is no film to end";
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
    EXPECT_FALSE(film.recording());
    EXPECT_EQ(toasts.count(), 2U) << "the file's name, and the reason of the failure";
    film.toggle();
    EXPECT_FALSE(film.recording()) << "another one cannot begin either";
    fs::remove(folder);
}

} // namespace
} // namespace trembler::ui::test

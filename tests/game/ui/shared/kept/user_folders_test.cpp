// The folders for the player's pictures, and for files received from others.
#include "game/ui/shared/kept/user_folders.hpp"
#include "tests/support/variable.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <unistd.h>

namespace trembler::ui {
namespace {

TEST(PicturesFolder, IsThatOfTheDesktop) {
    EXPECT_EQ(userFolderIn("# comment\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n", "XDG_PICTURES_DIR", "/home/ada"),
              "/home/ada/Bilder");
    EXPECT_EQ(userFolderIn("XDG_PICTURES_DIR=\"/data/pictures\"", "XDG_PICTURES_DIR", "/home/ada"),
              "/data/pictures");
    EXPECT_EQ(userFolderIn("#XDG_PICTURES_DIR=\"/old\"\nXDG_PICTURES_DIR=\"/new\"", "XDG_PICTURES_DIR",
                           "/home/ada"),
              "/new");
    for (char const* text :
         {"", "XDG_MUSIC_DIR=\"$HOME/Music\"", "XDG_PICTURES_DIR=\"$HOME/\"", "XDG_PICTURES_DIR=\"$HOME\"",
          "XDG_PICTURES_DIR=\"pictures\"", "#XDG_PICTURES_DIR=\"/a\""}) {
        EXPECT_TRUE(userFolderIn(text, "XDG_PICTURES_DIR", "/home/ada").empty()) << text;
    }
}

TEST(PicturesFolder, IsReadFromAFileOfAMegabyteAtMost) {
    namespace fs = std::filesystem;
    fs::path const config = fs::path(testing::TempDir()) / ("user folders " + std::to_string(::getpid()));
    fs::create_directories(config);
    trembler::test::Variable const home("HOME", "/home/ada");
    trembler::test::Variable const place("XDG_CONFIG_HOME", config.c_str());
    std::string const stated = "XDG_PICTURES_DIR=\"/data/pictures\"\n#";
    for (std::size_t const size : {stated.size(), std::size_t{1} << 20U, (std::size_t{1} << 20U) + 1}) {
        std::ofstream(config / "user-dirs.dirs") << stated << std::string(size - stated.size(), 'x');
        bool const fits = size <= std::size_t{1} << 20U;
        EXPECT_EQ(usualPicturesFolder(), fits ? "/data/pictures/Trembler" : "/home/ada/Pictures/Trembler")
            << size;
    }
    fs::remove_all(config);
}

TEST(DownloadsFolder, IsThatOfTheDesktop) {
    std::string const both = "XDG_DOWNLOAD_DIR=\"$HOME/Geladenes\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
    EXPECT_EQ(userFolderIn(both, "XDG_DOWNLOAD_DIR", "/home/ada"), "/home/ada/Geladenes");
    EXPECT_EQ(userFolderIn(both, "XDG_PICTURES_DIR", "/home/ada"), "/home/ada/Bilder");
}

} // namespace
} // namespace trembler::ui

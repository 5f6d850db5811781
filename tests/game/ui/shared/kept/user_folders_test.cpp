// The folders for the player's pictures, and for files received from others.
#include "game/ui/shared/kept/user_folders.hpp"

#include <gtest/gtest.h>

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

TEST(DownloadsFolder, IsThatOfTheDesktop) {
    std::string const both = "XDG_DOWNLOAD_DIR=\"$HOME/Geladenes\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
    EXPECT_EQ(userFolderIn(both, "XDG_DOWNLOAD_DIR", "/home/ada"), "/home/ada/Geladenes");
    EXPECT_EQ(userFolderIn(both, "XDG_PICTURES_DIR", "/home/ada"), "/home/ada/Bilder");
}

} // namespace
} // namespace trembler::ui

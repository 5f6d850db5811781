// Where the player's pictures go.
#include "game/ui/shared/user_folders.hpp"

#include <gtest/gtest.h>

namespace trembler::ui {
namespace {

TEST(PicturesFolder, IsThatOfTheDesktop) {
    EXPECT_EQ(picturesFolderIn("# comment\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n", "/home/ada"),
              "/home/ada/Bilder");
    EXPECT_EQ(picturesFolderIn("XDG_PICTURES_DIR=\"/data/pictures\"", "/home/ada"), "/data/pictures");
    EXPECT_EQ(picturesFolderIn("#XDG_PICTURES_DIR=\"/old\"\nXDG_PICTURES_DIR=\"/new\"", "/home/ada"), "/new");
    for (char const* text :
         {"", "XDG_MUSIC_DIR=\"$HOME/Music\"", "XDG_PICTURES_DIR=\"$HOME/\"", "XDG_PICTURES_DIR=\"$HOME\"",
          "XDG_PICTURES_DIR=\"pictures\"", "#XDG_PICTURES_DIR=\"/a\""}) {
        EXPECT_TRUE(picturesFolderIn(text, "/home/ada").empty()) << text;
    }
}

} // namespace
} // namespace trembler::ui

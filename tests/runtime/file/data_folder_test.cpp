// The folder of the player's data, by the variables of the environment that may be set or not.
#include "runtime/file/data_folder.hpp"
#include "tests/support/variable.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

TEST(DataFolder, IsThatOfTheEnvironment) {
    struct Case {
        char const* data; ///< null: not set
        char const* home;
        char const* expected;
    };
    for (Case const& one :
         {Case{"/data", "/home/ada", "/data/trembler"},
          Case{"", "/home/ada", "/home/ada/.local/share/trembler"},
          Case{nullptr, "/home/ada", "/home/ada/.local/share/trembler"},
          Case{"/data", nullptr, "/data/trembler"}, Case{nullptr, nullptr, ""}, Case{"", "", ""}}) {
        Variable const data("XDG_DATA_HOME", one.data);
        Variable const home("HOME", one.home);
        EXPECT_EQ(dataFolder(), one.expected);
        EXPECT_EQ(inDataFolder("parts"),
                  *one.expected == '\0' ? std::string() : std::string(one.expected) + "/parts");
    }
}

} // namespace
} // namespace trembler::test

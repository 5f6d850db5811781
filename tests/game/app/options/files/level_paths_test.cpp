// The levels that the paths of a command name: each once, and none is left out in silence.
#include "game/app/options/files/level_paths.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "tests/game/app/program.hpp"
#include "tests/support/game_data.hpp"

#include <unistd.h>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

class LevelPaths : public InAFolder {
protected:
    void SetUp() override {
        InAFolder::SetUp();
        for (char const* const name : {"two/a.json", "two/b.json", "two/more/c.json"}) {
            fs::create_directories(fs::path(at(name)).parent_path());
            write(at(name), "{}");
        }
    }
    [[nodiscard]] static std::vector<fs::path> named(std::vector<std::string> const& paths) {
        return levelsNamed(gameData(), paths);
    }
};

TEST_F(LevelPaths, AreEachOnce) {
    std::vector<fs::path> const all{at("two/a.json"), at("two/b.json"), at("two/more/c.json")};
    EXPECT_EQ(named({at("two")}), all);
    EXPECT_EQ(named({at("two"), at("two/a.json"), at("two/more")}), all);
    fs::create_symlink(at("two/a.json"), at("link.json"));
    EXPECT_EQ(named({at("link.json"), at("two")}),
              (std::vector<fs::path>{at("link.json"), at("two/b.json"), at("two/more/c.json")}));
}

/// No rights of an administrator while it lives, who may read everything.
class WithoutRights {
public:
    WithoutRights() : user_(::geteuid()) {
        constexpr ::uid_t nobody = 65534;
        dropped_ = user_ != 0 || ::seteuid(nobody) == 0;
    }
    ~WithoutRights() {
        if (user_ == 0 && dropped_ && ::seteuid(user_) != 0) {
            ADD_FAILURE() << "the rights do not come back";
        }
    }
    WithoutRights(WithoutRights const&) = delete;
    WithoutRights& operator=(WithoutRights const&) = delete;

private:
    ::uid_t user_;
    bool dropped_ = false;
};

TEST_F(LevelPaths, SayWhichFolderCannotBeRead) {
    fs::permissions(folder, fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
    fs::permissions(at("two/more"), fs::perms::none);
    std::string said;
    {
        (void)gameData(); // is read with all rights
        WithoutRights const without;
        std::error_code error;
        if (fs::is_directory(at("two"), error)) {
            try {
                (void)named({at("two")});
            } catch (InputError const& wrong) {
                said = wrong.what();
            }
        } else {
            said = "skip";
        }
    }
    fs::permissions(at("two/more"), fs::perms::owner_all);
    if (said == "skip") {
        GTEST_SKIP() << "the folder for tests lies where others see nothing";
    }
    EXPECT_NE(said.find(at("two/more") + ": cannot be read: Permission denied"), std::string::npos) << said;
}

} // namespace
} // namespace trembler::test

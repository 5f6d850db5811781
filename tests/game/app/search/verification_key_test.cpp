// What `verify --resume` takes into account: every byte of the level and of its mods, up to a bound.
#include "game/app/search/verification_key.hpp"
#include "tests/game/app/program.hpp"

#include <fmt/format.h>

#include <set>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

class VerificationKey : public InAFolder {
protected:
    void SetUp() override {
        InAFolder::SetUp();
        write(at("level.json"), R"({"version": 2, "title": "t", "mods": ["many"], "objects": []})");
        fs::create_directories(folder / "mods/many/files");
        write(at("mods/many/mod.json"), R"({"name": "many", "version": "1", "author": "a", "licence": "l"})");
    }
    [[nodiscard]] std::string key() const {
        GameDataByMods data({});
        return verificationKey(data, at("level.json"), {});
    }
    [[nodiscard]] std::string file(int number) const {
        return at(fmt::format("mods/many/files/{:05}", number));
    }
};

TEST_F(VerificationKey, DependsOnEachPieceOfALargeFile) {
    std::string bytes(3'000'000, 'x');
    std::set<std::string> keys;
    for (std::size_t const place : {std::size_t{0}, std::size_t{1} << 20U, bytes.size() - 1}) {
        bytes[place] = 'y';
        write(file(1), bytes);
        keys.insert(key());
    }
    write(file(1), bytes + "z");
    keys.insert(key());
    EXPECT_EQ(keys.size(), 4U);
    EXPECT_EQ(key(), key());
}

TEST_F(VerificationKey, TakesTheFirstTenThousandFilesOfAModIntoAccount) {
    constexpr int most = 10'000;
    for (int i = 0; i < most; ++i) { // with mod.json one too many
        write(file(i), "");
    }
    std::string const before = key();
    write(file(most - 2), "another");
    EXPECT_NE(key(), before) << "the last but one by name";
    write(file(most - 2), "");
    ASSERT_EQ(key(), before);
    // files/ comes before mod.json by name, which is left out.
    write(at("mods/many/mod.json"), R"({"name": "many", "version": "2", "author": "a", "licence": "l"})");
    EXPECT_EQ(key(), before);
    fs::remove(file(0));
    EXPECT_NE(key(), before);
}

} // namespace
} // namespace trembler::test

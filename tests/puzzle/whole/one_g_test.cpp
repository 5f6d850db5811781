// New levels have the program's one g, and the words that state it agree.
#include "physics/gravity/properties.hpp"
#include "puzzle/campaign/free_play.hpp"
#include "puzzle/edit/document/level_document.hpp"
#include "tests/support/experiment.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trembler {
namespace {

class OneG : public Experiment {};

TEST_F(OneG, IsThatOfNewLevelsAndOfTheWords) {
    edit::LevelDocument const fresh = edit::LevelDocument::blank(gameData());
    EXPECT_EQ(fresh.json()->root()["world"]["gravity"], nlohmann::json::array({0, -earthGravity}));
    auto const free = nlohmann::json::parse(freePlayLevel(gameData().parts, "title", "text"));
    EXPECT_EQ(free["world"]["gravity"], nlohmann::json::array({0, -earthGravity}));
    std::string const words = fmt::format("[0, {}] on Earth", -earthGravity);
    GravityField field;
    bool stated = false;
    GravityField::describe(field, [&](FieldInfo const& info, Vec2&) { stated = info.meaning == words; });
    EXPECT_TRUE(stated) << words;
}

} // namespace
} // namespace trembler

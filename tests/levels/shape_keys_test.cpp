// A piece of a shape has the measures of its form and no others.
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/levels/level_kit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace trembler {
namespace shape_keys_test {
namespace {

using Json = nlohmann::json;

// Some values of each measure: an arbitrary one, and the default.
ShapePiece const initial;
std::map<std::string, std::vector<Json>> const measures{
    {"radius", {0.3, initial.radius}},
    {"width", {0.7, initial.width}},
    {"height", {0.4, initial.height}},
    {"corners", {{{0, 0}, {1, 0}, {0, 1}}, Json::array()}}};
std::map<std::string, std::set<std::string>> const own{{"circle", {"radius"}},
                                                       {"box", {"width", "height"}},
                                                       {"capsule", {"radius", "width"}},
                                                       {"polygon", {"corners"}}};

std::string levelWith(Json const& piece) {
    return Json{{"version", levelVersion},
                {"title", "t"},
                {"objects", {{{"name", "x"}, {"at", {0, 0}}, {"properties", {{"shape", {piece}}}}}}}}
        .dump();
}

TEST(ShapeKeys, BelongToTheForm) {
    Registry const& registry = levelKit().registry;
    for (auto const& [form, keys] : own) {
        Json good{{"form", form}};
        for (std::string const& key : keys) {
            good[key] = measures.at(key).front();
        }
        LevelFile const level = readLevel(registry, JsonDocument::parse(levelWith(good), "l.json"));
        ASSERT_EQ(level.objects.at(0).properties.find<Shape>()->pieces.size(), 1U);
        EXPECT_NO_THROW((void)buildWorld(registry, level, levelKit().parts)) << form;
        for (auto const& [key, values] : measures) {
            if (keys.contains(key)) {
                continue;
            }
            for (Json const& value : values) {
                Json bad = good;
                bad[key] = value;
                SCOPED_TRACE(bad.dump());
                try {
                    (void)readLevel(registry, JsonDocument::parse(levelWith(bad), "l.json"));
                    ADD_FAILURE();
                } catch (InputError const& error) {
                    ASSERT_EQ(error.diagnostics().size(), 1U) << error.what();
                    EXPECT_EQ(error.diagnostics()[0].path, "/objects/0/properties/shape/0/" + key);
                    EXPECT_NE(error.diagnostics()[0].message.find(fmt::format("unknown key '{}'", key)),
                              std::string::npos)
                        << error.what();
                }
            }
        }
    }
}

} // namespace
} // namespace shape_keys_test
} // namespace trembler

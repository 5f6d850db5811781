// A piece of a shape states the measures of its form and no others.
#include "physics/dynamics/shape.hpp"
#include "runtime/level/build_world.hpp"
#include "runtime/level/read_level.hpp"
#include "tests/levels/shelf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace trembler {
namespace {

using Json = nlohmann::json;

std::map<std::string, Json> const measures{
    {"radius", 0.3}, {"width", 0.7}, {"height", 0.4}, {"corners", {{0, 0}, {1, 0}, {0, 1}}}};
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
    Registry const& registry = shelf().registry;
    for (auto const& [form, keys] : own) {
        Json good{{"form", form}};
        for (std::string const& key : keys) {
            good[key] = measures.at(key);
        }
        LevelFile const level = readLevel(registry, JsonDocument::parse(levelWith(good), "l.json"));
        ASSERT_EQ(level.objects.at(0).properties.find<Shape>()->pieces.size(), 1U);
        EXPECT_NO_THROW((void)buildWorld(registry, level, shelf().parts)) << form;
        for (auto const& [key, value] : measures) {
            if (keys.contains(key)) {
                continue;
            }
            Json bad = good;
            bad[key] = value;
            LevelFile const wrong =
                readLevel(shelf().registry, JsonDocument::parse(levelWith(bad), "l.json"));
            try {
                (void)buildWorld(shelf().registry, wrong, shelf().parts);
                ADD_FAILURE() << form << " with " << key;
            } catch (InputError const& error) {
                ASSERT_EQ(error.diagnostics().size(), 1U) << error.what();
                EXPECT_EQ(error.diagnostics()[0].path, "/objects/0/properties/shape");
                EXPECT_NE(error.diagnostics()[0].message.find(
                              fmt::format("states '{}' of a {}, where it does not count", key, form)),
                          std::string::npos)
                    << error.what();
            }
        }
    }
}

} // namespace
} // namespace trembler

#include "puzzle/campaign/free_play.hpp"

#include "physics/gravity/properties.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/read/read_texts.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

Json fixedBox(char const* name, char const* material, Vec2 at, Vec2 size) {
    Json const shape = Json::array({Json{{"form", "box"}, {"width", size.x}, {"height", size.y}}});
    return Json{
        {"name", name},
        {"at", Json::array({at.x, at.y})},
        {"properties", {{"material", material}, {"shape", shape}, {"fixed", true}, {"friction", 0.7}}}};
}

Json water(Vec2 at, Vec2 size) {
    Json const shape = Json::array({Json{{"form", "box"}, {"width", size.x}, {"height", size.y}}});
    Json const liquid{{"linear_drag", 1.5}, {"quadratic_drag", 1}};
    return Json{
        {"name", "water"},
        {"at", Json::array({at.x, at.y})},
        {"properties", {{"material", "water"}, {"shape", shape}, {"density", 1000}, {"liquid", liquid}}}};
}

/// A workshop: a long floor, a bench and a shelf at the left, and a basin in the floor at the right. Between
/// -5.8 and 5.8 m, above the floor, it is empty: there players of earlier versions have placed parts, and
/// recordings name "floor", "left wall" and "right wall".
Json workshop() {
    return Json::array({fixedBox("floor", "stone", {-1, -0.15}, {14, 0.3}),
                        fixedBox("left wall", "stone", {-7.9, 3.85}, {0.2, 8.3}),
                        fixedBox("right wall", "stone", {7.9, 3.25}, {0.2, 9.5}),
                        fixedBox("bench", "wood", {-7, 0.85}, {1.6, 0.1}),
                        fixedBox("left leg", "wood", {-7.55, 0.4}, {0.1, 0.8}),
                        fixedBox("right leg", "wood", {-6.45, 0.4}, {0.1, 0.8}),
                        fixedBox("shelf", "wood", {-7.2, 2.6}, {1.2, 0.08}),
                        fixedBox("basin wall", "stone", {5.85, -0.9}, {0.3, 1.2}),
                        fixedBox("basin floor", "stone", {6.75, -1.35}, {2.1, 0.3}),
                        water({6.9, -0.675}, {1.8, 1.05})});
}

} // namespace

std::string freePlayLevel(PartLibrary const& parts, std::string const& title, std::string const& text,
                          Translations const& texts, std::vector<std::string> const& mods) {
    Json toolbox = Json::array();
    auto names = parts.names();
    names.resize(std::min(names.size(), limits::toolboxEntries - 1));
    for (std::string const& name : names) {
        toolbox.push_back(Json{{"part", name}, {"count", unlimitedWord}});
    }
    toolbox.push_back(Json{{"wire", unlimitedWord}});
    Json level{
        {"version", levelVersion},
        {"title", title},
        {"text", text},
        {"world",
         {{"gravity", Json::array({0, -earthGravity})}, {"bounds", Json::array({-8, -1.5, 16, 9.5})}}},
        {"objects", workshop()},
        {"placing", Json::array({Json::array({-7.8, 0, 15.6, 7.8}), Json::array({6, -1.2, 1.8, 1.2})})},
        {"toolbox", std::move(toolbox)}};
    if (!mods.empty()) {
        level["mods"] = mods;
    }
    if (!texts.empty()) {
        level["texts"] = writeTexts(texts);
    }
    return level.dump(2) + "\n";
}

} // namespace trembler

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

Json slab(char const* name, Vec2 at, Vec2 size) {
    Json const shape = Json::array({Json{{"form", "box"}, {"width", size.x}, {"height", size.y}}});
    return Json{
        {"name", name},
        {"at", Json::array({at.x, at.y})},
        {"properties", {{"material", "stone"}, {"shape", shape}, {"fixed", true}, {"friction", 0.7}}}};
}

} // namespace

std::string freePlayLevel(PartLibrary const& parts, std::string const& title, std::string const& text,
                          Translations const& texts) {
    Json toolbox = Json::array();
    auto names = parts.names();
    names.resize(std::min(names.size(), limits::toolboxEntries));
    for (std::string const& name : names) {
        toolbox.push_back(Json{{"part", name}, {"count", limits::toolboxCount}});
    }
    Json level{{"version", levelVersion},
               {"title", title},
               {"text", text},
               {"world",
                {{"gravity", Json::array({0, -earthGravity})}, {"bounds", Json::array({-6, -0.5, 12, 6.5})}}},
               {"objects", Json::array({slab("floor", {0, -0.15}, {11.6, 0.3}),
                                        slab("left wall", {-5.9, 2.75}, {0.2, 6.1}),
                                        slab("right wall", {5.9, 2.75}, {0.2, 6.1})})},
               {"placing", Json::array({Json::array({-5.8, 0, 11.6, 5.8})})},
               {"toolbox", std::move(toolbox)}};
    if (!texts.empty()) {
        level["texts"] = writeTexts(texts);
    }
    return level.dump(2) + "\n";
}

} // namespace trembler

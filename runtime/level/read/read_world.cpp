#include "runtime/level/read/read_world.hpp"

#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/model/detail_levels.hpp"
#include "runtime/level/property/property_reader.hpp"
#include "runtime/level/read/read_area.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace trembler {
namespace {

void readDetail(Registry const& registry, JsonNode const& node, LevelFile& level) {
    if (!node.isObject("an object {effect: detail level}")) {
        return;
    }
    auto const levels = detailLevels(registry);
    std::vector<std::string> effects;
    effects.reserve(levels.size());
    for (auto const& [effect, of] : levels) {
        effects.push_back(effect);
    }
    for (auto const& [effect, value] : node.value().items()) {
        auto const known = levels.find(effect);
        if (known == levels.end()) {
            node.complainAboutKey(
                effect,
                fmt::format("no effect '{}' has detail levels{}", effect, didYouMean(effect, effects)),
                listed(effects));
            continue;
        }
        std::vector<std::string_view> const names(known->second.begin(), known->second.end());
        if (auto const index = node.member(effect).choice(names)) {
            level.detail[effect] = known->second[*index];
        }
    }
}

} // namespace

void readWorld(Registry const& registry, JsonNode const& node, LevelFile& level) {
    if (!node.isObject("an object with the properties of the world, \"bounds\" and \"detail\"")) {
        return;
    }
    auto known = keysOf(registry, PropertyPlace::world);
    known.insert(known.end(), {"bounds", "detail"});
    for (auto const& [key, value] : node.value().items()) {
        JsonNode const member = node.member(key);
        PropertyInfo const* const info = registry.objectProperty(key);
        if (key == "bounds") {
            level.bounds = readBox(member);
        } else if (key == "detail") {
            readDetail(registry, member, level);
        } else if (info != nullptr && info->text.place == PropertyPlace::world) {
            readPropertyInto(level.world, *info, member, &level.names);
        } else {
            node.complainAboutKey(key, fmt::format("unknown key '{}'{}", key, didYouMean(key, known)),
                                  listed(known));
        }
    }
}

} // namespace trembler

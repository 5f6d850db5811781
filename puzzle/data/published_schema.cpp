#include "puzzle/data/published_schema.hpp"

#include "lua/attach/register.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

nlohmann::ordered_json publishedSchema() {
    Registry registry;
    registerEffects(registry);
    lua::registerScripts(registry);
    return levelSchema(registry);
}

} // namespace trembler

#include "puzzle/data/published_schema.hpp"

#include "lua/attach/register.hpp"
#include "puzzle/campaign/chapter.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "runtime/level/write/schema.hpp"
#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

nlohmann::ordered_json publishedSchema(AuthoredFile of) {
    if (of == AuthoredFile::chapter) {
        return chapterSchema();
    }
    Registry registry;
    registerEffects(registry);
    lua::registerScripts(registry);
    return of == AuthoredFile::part ? partSchema(registry) : levelSchema(registry);
}

} // namespace trembler

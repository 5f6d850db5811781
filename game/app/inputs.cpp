#include "game/app/inputs.hpp"

#include "game/app/outputs.hpp"
#include "puzzle/data/game_data.hpp"

namespace trembler {

void readsAll(Outputs& outputs, GameData const& gameData) {
    for (PartDefinition const* const part : gameData.parts.all()) {
        if (part->document) {
            outputs.reads(part->document->file());
        }
    }
    for (std::filesystem::path const& level : gameData.levels()) {
        outputs.reads(level);
    }
}

} // namespace trembler

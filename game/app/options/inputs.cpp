#include "game/app/options/inputs.hpp"

#include "game/app/options/outputs.hpp"
#include "puzzle/data/game_data.hpp"

namespace trembler {
namespace {

namespace fs = std::filesystem;

void readsFolder(Outputs& outputs, fs::path const& folder) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        outputs.reads(at->path());
    }
}

} // namespace

void readsAll(Outputs& outputs, GameData const& gameData) {
    for (PartDefinition const* const part : gameData.parts.all()) {
        if (part->document) {
            outputs.reads(part->document->file());
        }
    }
    for (fs::path const& level : gameData.levels()) {
        outputs.reads(level);
    }
    readsAll(outputs, gameData.mods);
}

void readsAll(Outputs& outputs, std::vector<lua::Mod> const& mods) {
    for (lua::Mod const& mod : mods) {
        outputs.reads(mod.folder / "mod.json");
        for (lua::Manifest const& script : mod.interactions) {
            outputs.reads(script.file);
        }
        for (fs::path const& folder : {mod.partFolder(), mod.levelFolder(), mod.testFolder()}) {
            readsFolder(outputs, folder);
        }
    }
}

} // namespace trembler

#include "game/app/options/files/inputs.hpp"

#include "game/app/mods/mods.hpp"
#include "game/app/options/files/outputs.hpp"
#include "puzzle/data/game_data.hpp"

namespace trembler {
namespace {

namespace fs = std::filesystem;

/// More files than any mod has are left out, should the folder be that of a disk.
constexpr int mostFiles = 10'000;

void readsFolder(Outputs& outputs, fs::path const& folder) {
    std::error_code error;
    int left = mostFiles;
    for (fs::directory_iterator at(folder, error), end; !error && at != end && left > 0;
         at.increment(error), --left) {
        outputs.reads(at->path());
    }
}

/// Every file below the folder.
void readsTree(Outputs& outputs, fs::path const& folder) {
    std::error_code error;
    int left = mostFiles;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end && left > 0;
         at.increment(error), --left) {
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
    readsTree(outputs, gameData.home / "assets"); // texts, too
    readsAll(outputs, gameData.mods);
}

void readsLevel(Outputs& outputs, GameDataByMods& data, fs::path const& level) {
    outputs.reads(level);
    try {
        readsAll(outputs, data.dataFor(level).mods);
    } catch (InputError const&) { // reported when the level is read
        for (fs::path const& folder : data.modFoldersFor(level)) {
            readsTree(outputs, folder);
        }
    }
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

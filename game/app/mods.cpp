#include "game/app/mods.hpp"

#include "lua/attach/register.hpp"
#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <iostream>

namespace trembler {

void addModFolders(CLI::App& command, std::vector<std::string>& folders) {
    command.add_option("--mod", folders, "A folder of mods to look in, before those that are installed")
        ->type_name("DIR")
        ->allow_extra_args(false);
}

std::unique_ptr<GameData const> gameDataFor(std::filesystem::path const& level,
                                            std::vector<std::string> const& folders) {
    std::vector<std::string> const names = lua::modsNamedBy(level);
    if (names.empty()) {
        return std::make_unique<GameData const>();
    }
    Problems problems;
    std::vector<lua::Mod> mods =
        lua::findMods(names, lua::modFolders(folders, level, homeFolder()), level.string(), problems);
    problems.throwIfAny();
    return std::make_unique<GameData const>(std::move(mods));
}

void registerModsIn(Registry& registry, std::vector<std::string> const& folders) {
    std::vector<std::filesystem::path> const paths(folders.begin(), folders.end());
    std::vector<std::string> names;
    for (std::filesystem::path const& mod : lua::listMods(paths)) {
        names.push_back(mod.filename().string());
    }
    Problems problems;
    std::vector<lua::Mod> const mods = lua::findMods(names, paths, "--mod", problems);
    lua::registerMods(registry, mods, std::make_shared<lua::ScriptLog>(), problems);
    problems.throwIfAny();
}

void tellScriptMessages(GameData const& gameData) {
    for (lua::ScriptMessage const& message : gameData.scriptLog->take()) {
        std::cerr << visibleLines(fmt::format("{} in frame {}: {}{}", message.script, message.frame,
                                              message.error ? "switched off: " : "", message.text))
                  << "\n";
    }
}

} // namespace trembler

#include "game/app/mods.hpp"

#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <iostream>

namespace trembler {

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

void tellScriptMessages(GameData const& gameData) {
    for (lua::ScriptMessage const& message : gameData.scriptLog->take()) {
        std::cerr << visibleLines(fmt::format("{} in frame {}: {}{}", message.script, message.frame,
                                              message.error ? "switched off: " : "", message.text))
                  << "\n";
    }
}

} // namespace trembler

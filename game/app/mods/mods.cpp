#include "game/app/mods/mods.hpp"

#include "game/app/options/files/file_rules.hpp"
#include "lua/attach/register.hpp"
#include "lua/interaction/allowed_limits.hpp"
#include "lua/mods/trust.hpp"
#include "puzzle/solutions/verify.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <system_error>
#include <utility>

namespace trembler {

namespace {

/// A level in each place where the command looks for levels, whether it exists or not.
std::vector<std::filesystem::path> levelsStated(CLI::App& command) {
    std::vector<std::filesystem::path> levels{{}};
    for (char const* const argument : {"LEVEL", "PATH"}) {
        if (CLI::Option const* const option = command.get_option_no_throw(argument)) {
            for (std::filesystem::path const path : option->results()) {
                std::error_code none;
                levels.push_back(std::filesystem::is_directory(path, none) ? path / "level.json" : path);
            }
        }
    }
    return levels;
}

Fault faultOfModName(CLI::App& command, std::vector<std::string> const& folders, std::string const& name) {
    std::vector<std::string> known;
    for (std::filesystem::path const& level : levelsStated(command)) {
        for (std::filesystem::path const& mod :
             lua::listMods(lua::modFolders(folders, level, homeFolder()))) {
            known.push_back(mod.filename().string());
        }
    }
    return std::find(known.begin(), known.end(), name) != known.end()
               ? std::nullopt
               : Fault("there is no such mod" + didYouMean(name, known));
}

} // namespace

void addModFolders(CLI::App& command, std::vector<std::string>& folders) {
    addModFolderOption(command, folders,
                       "A mod's folder, or a folder of mods, to look in before the installed ones");
    auto* const trust = command.add_option_function<std::vector<std::string>>(
        "--trust", [](std::vector<std::string> const& names) { lua::trustForThisRun(names); },
        "A mod whose scripts are compiled, which makes them about ten times as fast; for mods whose "
        "author you trust");
    accepts(trust->type_name("MOD")->allow_extra_args(false),
            "the name of a mod that is installed, beside the level or in a folder of --mod",
            [&command, &folders](std::string const& name) { return faultOfModName(command, folders, name); });
}

void addModFolderOption(CLI::App& command, std::vector<std::string>& folders, std::string const& meaning) {
    CLI::Option* const option = command.add_option("--mod", folders, meaning);
    accepts(option->type_name("DIR")->allow_extra_args(false),
            "a mod's folder, with its mod.json, or a folder of mods", [](std::string const& folder) -> Fault {
                if (Fault const fault = faultOfInputFolder(folder)) {
                    return fault;
                }
                std::vector<std::filesystem::path> const place{lua::modsFolder(folder)};
                return lua::listMods(place).empty() ? Fault("holds no mod") : std::nullopt;
            });
    oncePerPath(option);
}

namespace {

/// `level` needs them; empty: the player has chosen them.
std::vector<lua::Mod> modsNamed(std::vector<std::string> const& names, std::filesystem::path const& level,
                                std::vector<std::string> const& folders) {
    if (names.empty()) {
        return {};
    }
    Problems problems;
    lua::ModSettings const settings = lua::readModSettings(lua::modSettingsFile(), problems);
    lua::allowLimits(settings.most);
    std::vector<lua::Mod> mods =
        lua::findMods(names, lua::modFolders(folders, level, homeFolder()), level.string(), problems);
    problems.throwIfAny();
    std::vector<std::filesystem::path> const installed = lua::modFolders(folders, {}, homeFolder());
    for (lua::Mod& mod : mods) {
        mod.besideLevel =
            std::none_of(installed.begin(), installed.end(), [&](std::filesystem::path const& folder) {
                std::error_code error;
                return std::filesystem::equivalent(folder, mod.folder.parent_path(), error);
            });
    }
    lua::applyTrust(mods, settings);
    return mods;
}

std::vector<lua::Mod> modsFor(std::filesystem::path const& level, std::vector<std::string> const& folders) {
    return modsNamed(lua::modsNamedBy(level), level, folders);
}

/// "push.lua:5: oh no" with the path of the script.
std::string withPath(GameData const& gameData, lua::ScriptMessage const& message) {
    lua::LiveScript const* const script = gameData.scripts->find(message.script);
    if (script != nullptr && message.text.starts_with(script->file().filename().string() + ":")) {
        return (script->file().parent_path() / message.text).string();
    }
    return message.script + ": " + message.text;
}

} // namespace

std::unique_ptr<GameData const> gameDataFor(std::filesystem::path const& level,
                                            std::vector<std::string> const& folders) {
    return std::make_unique<GameData const>(modsFor(level, folders));
}

std::unique_ptr<GameData const> gameDataWith(std::vector<std::string> const& mods,
                                             std::vector<std::string> const& folders) {
    return std::make_unique<GameData const>(modsNamed(mods, {}, folders));
}

GameData const& GameDataByMods::dataFor(std::filesystem::path const& level) {
    std::vector<lua::Mod> mods = modsFor(level, folders_);
    std::vector<std::filesystem::path> places;
    for (lua::Mod const& mod : mods) {
        std::error_code error;
        places.push_back(std::filesystem::absolute(mod.folder, error).lexically_normal());
    }
    auto& data = byMods_[places];
    if (data == nullptr) {
        data = std::make_unique<GameData const>(std::move(mods));
    }
    return *data;
}

std::vector<std::filesystem::path> GameDataByMods::modFoldersFor(std::filesystem::path const& level) const {
    std::vector<std::filesystem::path> found;
    for (std::filesystem::path const& folder : lua::modFolders(folders_, level, homeFolder())) {
        for (std::string const& name : lua::modsNamedBy(level)) {
            std::error_code error;
            if (std::filesystem::is_directory(folder / name, error)) {
                found.push_back(folder / name);
            }
        }
    }
    return found;
}

std::vector<lua::Mod> modsIn(std::vector<std::string> const& folders) {
    std::vector<std::string> names;
    for (std::filesystem::path const folder : folders) {
        std::filesystem::path const place = lua::modsFolder(folder);
        if (place != folder) { // it is that of one mod
            std::error_code error;
            std::filesystem::path const whole = std::filesystem::absolute(folder, error).lexically_normal();
            names.push_back((whole.has_filename() ? whole : whole.parent_path()).filename().string());
            continue;
        }
        for (std::filesystem::path const& mod : lua::listMods(std::vector<std::filesystem::path>{place})) {
            names.push_back(mod.filename().string());
        }
    }
    Problems problems;
    std::vector<lua::Mod> mods =
        lua::findMods(names, lua::modFolders(folders, {}, homeFolder()), "--mod", problems);
    problems.throwIfAny();
    return mods;
}

void registerModsIn(Registry& registry, std::vector<lua::Mod> const& mods) {
    if (mods.empty()) {
        return;
    }
    Problems problems;
    (void)lua::registerMods(registry, mods, std::make_shared<lua::ScriptLog>(), problems);
    problems.throwIfAny();
}

std::vector<std::string> verifyWithScripts(GameData const& gameData, std::filesystem::path const& level,
                                           std::map<std::string, std::string> const& detail) {
    (void)gameData.scriptLog->take(); // of levels before
    std::vector<std::string> failures = verifyLevel(gameData, level, detail);
    for (lua::ScriptMessage const& message : gameData.scriptLog->take()) {
        if (message.error) {
            std::string failure =
                fmt::format("{} ({} is switched off in frame {} of {})", withPath(gameData, message),
                            message.script, message.frame, gameData.shortName(level));
            // A level is run several times.
            if (std::find(failures.begin(), failures.end(), failure) == failures.end()) {
                failures.push_back(std::move(failure));
            }
        }
    }
    return failures;
}

void reportScriptMessages(GameData const& gameData) {
    for (lua::ScriptMessage const& message : gameData.scriptLog->take()) {
        std::cerr << visibleLines(fmt::format("{} in frame {}: {}{}", message.script, message.frame,
                                              message.error ? "switched off: " : "", message.text))
                  << "\n";
    }
}

} // namespace trembler

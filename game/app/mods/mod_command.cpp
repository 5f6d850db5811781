// trembler mod new, check, list.
#include "game/app/commands.hpp"
#include "game/app/mods/mod_reference_command.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/outputs.hpp"
#include "lua/component/never_applied.hpp"
#include "lua/mods/lint.hpp"
#include "lua/mods/mod_name.hpp"
#include "puzzle/campaign/chapter.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/file/lower_case.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/read/folder_limits.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/notation/boxes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

struct ModArguments {
    std::string name;
    std::vector<std::string> folders;
    std::string in = ".";
};

int newMod(ModArguments const& arguments) {
    fs::path const folder = fs::path(arguments.in) / arguments.name;
    std::error_code error;
    bool const there = fs::symlink_status(folder, error).type() != fs::file_type::not_found;
    try {
        lua::writeNewMod(folder, arguments.name);
        writeEditorFiles(folder);
    } catch (...) {
        if (!there) { // half a mod would be in the way of the next attempt
            fs::remove_all(folder, error);
        }
        throw;
    }
    std::cout << visible(folder.string()) << ": made. Next: trembler mod check " << visible(folder.string())
              << ", trembler run " << visible((folder / "levels/1-push.json").string()) << "\n";
    return exitSolved;
}

/// The level files directly in a folder, which need not exist. Adds a problem if it cannot be read.
std::vector<fs::path> levelsOf(fs::path const& folder, Problems& problems) {
    FolderFiles found = filesIn(folder, ".json", limits::levelFiles);
    if (found.error && found.error != std::errc::no_such_file_or_directory) {
        problems.add({.file = folder.string(),
                      .path = "",
                      .message = fmt::format("cannot be read: {}", found.error.message()),
                      .expected = ""});
    }
    return std::move(found.files);
}

/// What nothing looks at although its name says that something should.
struct Overlooked {
    std::vector<fs::path> scripts; ///< outside of interactions/, or with another ending
    std::vector<fs::path> levels;  ///< below levels/ and tests/, but not directly in them, or the same
};
Overlooked overlookedIn(lua::Mod const& mod, Problems& problems) {
    Overlooked found;
    std::error_code error;
    for (fs::recursive_directory_iterator at(mod.folder, error), end; !error && at != end;
         at.increment(error)) {
        fs::path const& path = at->path();
        std::error_code none;
        if (at->is_directory(none)) {
            // The editor's files that `mod new` writes, and hidden ones such as those of git.
            if (path == mod.folder / "annotations" || path.filename().string().starts_with(".") ||
                fs::exists(path / "mod.json", none)) {
                at.disable_recursion_pending();
            }
            continue;
        }
        std::string const ending = inLowerCase(path.extension().string());
        bool const asUsual = ending == path.extension();
        fs::path const folder = path.parent_path();
        if (ending == ".lua" && !(asUsual && folder == mod.folder / "interactions")) {
            found.scripts.push_back(path);
        }
        for (fs::path const& levels : {mod.levelFolder(), mod.testFolder()}) {
            fs::path const below = path.lexically_relative(levels);
            bool const inside = !below.empty() && *below.begin() != "..";
            if (ending == ".json" && inside && !(asUsual && folder == levels) && !isNotALevel(path)) {
                found.levels.push_back(path);
            }
        }
    }
    if (error) {
        problems.add({.file = mod.folder.string(),
                      .path = "",
                      .message = fmt::format("not all of its folders can be read: {}", error.message()),
                      .expected = ""});
    }
    std::sort(found.scripts.begin(), found.scripts.end());
    std::sort(found.levels.begin(), found.levels.end());
    return found;
}

/// The folder that is meant by a path or by the name of an installed mod; empty if there is none. Adds the
/// names of the installed mods to `known`; `error`: why it is not known whether there is a folder of that
/// path.
fs::path folderOf(std::string const& name, std::vector<std::string> const& folders,
                  std::vector<std::string>& known, std::error_code& error) {
    if (fs::exists(fs::path(name) / "mod.json", error)) {
        error.clear();
        fs::path const stated = fs::absolute(name, error).lexically_normal(); // "." has no name
        return stated.has_filename() ? stated : stated.parent_path();
    }
    for (fs::path const& mod : lua::listMods(lua::modFolders(folders, {}, homeFolder()))) {
        known.push_back(mod.filename().string());
        if (known.back() == name) {
            return mod;
        }
    }
    return {};
}

Fault faultOfMod(ModArguments const& arguments, std::string const& name) {
    std::vector<std::string> known;
    std::error_code error;
    if (!folderOf(name, arguments.folders, known, error).empty()) {
        return std::nullopt;
    }
    return error ? Fault("cannot be read: " + error.message())
                 : Fault("there is no such mod" + didYouMean(name, known));
}

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Prints probable mistakes as warnings; returns their number.
std::size_t printLint(lua::Mod const& mod, std::size_t levels, Overlooked const& overlooked) {
    std::size_t count = 0;
    auto const warn = [&](Diagnostic const& diagnostic) {
        std::cout << visible("warning: " + diagnostic.print()) << "\n";
        ++count;
    };
    for (lua::Manifest const& manifest : mod.interactions) {
        for (Diagnostic const& diagnostic : lua::lint(manifest)) {
            warn(diagnostic);
        }
    }
    for (fs::path const& script : overlooked.scripts) {
        warn({.file = script.string(),
              .path = "",
              .message = "is no interaction of the mod",
              .expected = "a file directly in interactions/ whose name ends in .lua"});
    }
    for (fs::path const& level : overlooked.levels) {
        warn({.file = level.string(),
              .path = "",
              .message = "is not checked",
              .expected = "a file directly in levels/ or tests/ whose name ends in .json"});
    }
    if (levels == 0) {
        warn({.file = mod.folder.string(),
              .path = "",
              .message = "no level shows that the mod works",
              .expected = "a level with a recorded solution in levels/ or tests/"});
    }
    return count;
}

/// Prints what each script of the mod is applied to.
void printTargets(GameData const& gameData, lua::Mod const& mod) {
    for (auto const& live : gameData.scripts->all()) {
        if (live->mod() == mod.name) {
            bool const once = live->script().manifest.application == lua::Application::once;
            std::cout << visible(fmt::format("    ({}) is applied {}", live->name(),
                                             once ? "once, to the world" : "to " + activation(live->info())))
                      << "\n";
        }
    }
}

/// Adds why a script is not applied in a level: of the level as it begins, and with each recorded solution,
/// the reason that comes nearest. Nothing for a level that cannot be built, which verifying it has reported.
void addWhyNeverApplied(std::vector<std::pair<std::string, std::string>>& reasons, GameData const& gameData,
                        lua::Script const& script, fs::path const& path) {
    std::optional<lua::NeverApplied> nearest;
    try {
        LevelFile const level = readLevel(gameData.registry, JsonDocument::load(path));
        WorldOptions options;
        options.detail = level.detail;
        for (std::size_t i = 0; i <= level.solutions.size(); ++i) {
            Session session(gameData.registry, gameData.parts, level, options);
            if (i > 0) {
                session.load(level.solutions[i - 1]);
            }
            lua::NeverApplied const one = lua::whyNeverApplied(script, session.world());
            if (!nearest || one.held > nearest->held) {
                nearest = one;
            }
        }
    } catch (std::exception const&) {
        nearest.reset();
    }
    if (nearest) {
        reasons.emplace_back(path.filename().string(), nearest->why);
    }
}

/// Prints a warning for each script of the mod that no level and no test has applied to anything, and why;
/// returns their number.
std::size_t printNeverApplied(GameData const& gameData, lua::Mod const& mod,
                              std::vector<fs::path> const& levels) {
    std::size_t count = 0;
    for (auto const& live : gameData.scripts->all()) {
        if (live->mod() != mod.name || levels.empty() || gameData.scriptLog->everApplied(live->name())) {
            continue;
        }
        std::vector<std::pair<std::string, std::string>> reasons;
        for (fs::path const& level : levels) {
            addWhyNeverApplied(reasons, gameData, live->script(), level);
        }
        constexpr std::size_t most = 3;
        bool const alike = std::all_of(reasons.begin(), reasons.end(),
                                       [&](auto const& one) { return one.second == reasons.front().second; });
        std::string why;
        for (std::size_t i = 0; i < reasons.size() && i < (alike ? 1 : most); ++i) {
            why += fmt::format("{}{}{}", why.empty() ? ": " : "; ",
                               alike ? std::string() : "in " + reasons[i].first + " ", reasons[i].second);
        }
        if (!alike && reasons.size() > most) {
            why += fmt::format("; and so on in {} more", reasons.size() - most);
        }
        std::cout << visible(
                         "warning: " +
                         live->script()
                             .manifest
                             .problem(
                                 "name",
                                 fmt::format(
                                     "'{}' never ran, as it is applied to nothing in {} levels and tests{}",
                                     live->name(), levels.size(), why),
                                 "a level or a test in which it is applied")
                             .print())
                  << "\n";
        ++count;
    }
    return count;
}

int checkMod(ModArguments const& arguments) {
    std::vector<std::string> known;
    std::error_code error;
    fs::path const named = folderOf(arguments.name, arguments.folders, known, error);
    fs::path const folder = fs::absolute(named, error).lexically_normal();
    std::string const name = folder.filename().string();
    std::vector<std::string> folders = arguments.folders;
    folders.insert(folders.begin(), folder.parent_path().string());
    Problems problems;
    std::vector<lua::Mod> mods = lua::findMods(std::vector<std::string>{name},
                                               lua::modFolders(folders, {}, homeFolder()), name, problems);
    problems.throwIfAny();
    GameData const gameData(std::move(mods));
    auto const mod = std::find_if(gameData.mods.begin(), gameData.mods.end(),
                                  [&](lua::Mod const& one) { return one.name == name; });
    std::vector<fs::path> levels;
    for (fs::path const& part : {mod->levelFolder(), mod->testFolder()}) {
        std::vector<fs::path> const found = levelsOf(part, problems);
        levels.insert(levels.end(), found.begin(), found.end());
    }
    Overlooked const overlooked = overlookedIn(*mod, problems);
    problems.throwIfAny();
    printTargets(gameData, *mod);
    std::size_t warnings = printLint(*mod, levels.size(), overlooked);
    bool good = true;
    for (fs::path const& level : levels) {
        std::vector<std::string> const failures = verifyWithScripts(gameData, level);
        for (std::string const& failure : failures) {
            std::cout << visible(failure) << "\n";
        }
        if (failures.empty()) {
            std::cout << visible(level.string()) << ": valid\n" << std::flush;
        }
        good = good && failures.empty();
    }
    warnings += printNeverApplied(gameData, *mod, levels);
    std::cout << visible(fmt::format("{}: {}, {} levels and tests, {}, {}", name,
                                     counted(mod->interactions.size(), "interaction"), levels.size(),
                                     counted(warnings, "warning"), good ? "all good" : "not good"))
              << "\n";
    return good ? exitSolved : exitNotSolved;
}

int listAll(ModArguments const& arguments) {
    for (fs::path const& folder : lua::listMods(lua::modFolders(arguments.folders, {}, homeFolder()))) {
        Problems problems;
        lua::Mod const mod = lua::readMod(folder, problems);
        std::cout << visible(fmt::format("{:20} {:8} {} ({}, {}){}", mod.name, mod.version, mod.text,
                                         mod.author, mod.licence,
                                         problems.empty() ? "" : "  [has problems: mod check]"))
                  << "\n";
        for (lua::Manifest const& manifest : mod.interactions) {
            std::cout << visible(fmt::format("    ({}) {}", manifest.name, manifest.text)) << "\n";
        }
    }
    return exitSolved;
}

} // namespace

void addModCommand(CLI::App& program, Work& work) {
    CLI::App* const command = program.add_subcommand(
        "mod", "Mods: interactions written in Lua, with parts and levels of their own");
    command->require_subcommand(1);
    auto const arguments = std::make_shared<ModArguments>();
    CLI::App* const made =
        command->add_subcommand("new", "Make the folder of a mod with an interaction that works");
    accepts(made->add_option("NAME", arguments->name, "Its name: small letters, digits and -")
                ->required()
                ->type_name(""),
            "a name of small letters, digits and -, at most 40",
            [](std::string const& name) { return lua::isModName(name) ? Fault() : Fault(""); });
    accepts(made->add_option("--in", arguments->in, "The folder to make it in")
                ->capture_default_str()
                ->type_name("DIR"),
            "a folder, which is made if it is missing", faultOfOutputFolder);
    made->callback([arguments, &work] { work = [arguments] { return newMod(*arguments); }; });
    CLI::App* const check = command->add_subcommand(
        "check",
        "Load a mod, warn of probable mistakes, and verify its levels and its tests, which are levels with "
        "recorded solutions. Exit status 1 if any fails, 2 if the mod cannot be loaded");
    accepts(check->add_option("MOD", arguments->name, "Its folder, or the name of one that is installed")
                ->required()
                ->type_name(""),
            "the folder of a mod, or the name of one that `trembler mod list` lists",
            [arguments](std::string const& name) { return faultOfMod(*arguments, name); });
    addModFolderOption(*check, arguments->folders, "A folder of mods to look in, too");
    check->callback([arguments, &work] { work = [arguments] { return checkMod(*arguments); }; });
    CLI::App* const list = command->add_subcommand("list", "The mods that are installed");
    addModFolderOption(*list, arguments->folders, "A folder of mods to look in, too");
    list->callback([arguments, &work] { work = [arguments] { return listAll(*arguments); }; });
    addModReferenceCommands(*command, work);
}

} // namespace trembler

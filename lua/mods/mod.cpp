#include "lua/mods/mod.hpp"

#include "lua/mods/mod_name.hpp"
#include "runtime/file/data_folder.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/level/json/json_node.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostInteractions = 50; // of one mod: a trace has room for 256 components
constexpr std::size_t mostNeeds = 50;
constexpr std::size_t mostMods = 100;    // of one level, with those that they need
constexpr std::size_t mostListed = 1000; // in all folders

std::string textOf(MemberReader& reader, std::string const& key, std::string_view expected) {
    auto const node = reader.required(key, expected);
    return node ? node->text(expected).value_or("") : std::string();
}

void readNeeds(JsonNode const& node, Mod& mod) {
    if (!node.isList("a list of names of mods", mostNeeds)) {
        return;
    }
    for (std::size_t i = 0; i < node.size(); ++i) {
        if (auto const name = node.element(i).name("the name of a mod")) {
            mod.needs.push_back(*name);
        }
    }
}

} // namespace

bool isModName(std::string_view name) {
    return !name.empty() && name.size() <= 40 && name.front() != '-' &&
           std::all_of(name.begin(), name.end(),
                       [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

Mod readMod(fs::path const& folder, Problems& problems) {
    Mod mod;
    mod.folder = folder;
    mod.name = folder.filename().string();
    std::shared_ptr<JsonDocument const> document;
    try {
        document = JsonDocument::load(folder / "mod.json");
    } catch (InputError const& bad) {
        for (Diagnostic const& diagnostic : bad.diagnostics()) {
            problems.add(diagnostic);
        }
        return mod;
    }
    MemberReader reader(
        JsonNode(*document, document->root(), "", problems),
        "a mod: an object {\"name\", \"version\", \"author\", \"licence\", \"text\", \"needs\"}");
    if (reader.valid()) {
        if (auto const name = reader.required("name", "the name of the mod's folder")) {
            auto const stated = name->name("the name of the mod");
            if (stated && (*stated != mod.name || !isModName(*stated))) {
                name->complain(fmt::format("'{}' is not the name of the folder, '{}'", *stated, mod.name),
                               "small letters, digits and -, like the folder");
            }
        }
        mod.version = textOf(reader, "version", "a text such as \"1.0\"");
        mod.author = textOf(reader, "author", "who made it");
        mod.licence = textOf(reader, "licence", "what others may do with it, for example \"CC0-1.0\"");
        if (auto const text = reader.optional("text")) {
            mod.text = text->text().value_or("");
        }
        if (auto const needs = reader.optional("needs")) {
            readNeeds(*needs, mod);
        }
        reader.finish();
    }
    FolderFiles const scripts = filesIn(folder / "interactions", ".lua", mostInteractions);
    if (scripts.error && scripts.error != std::errc::no_such_file_or_directory) {
        problems.add({.file = (folder / "interactions").string(),
                      .path = "",
                      .message = fmt::format("cannot be read: {}", scripts.error.message()),
                      .expected = ""});
    }
    if (scripts.leftOut > 0) {
        problems.add({.file = (folder / "interactions").string(),
                      .path = "",
                      .message = fmt::format("{} interactions", scripts.files.size() + scripts.leftOut),
                      .expected = fmt::format("at most {}", mostInteractions)});
        return mod;
    }
    for (fs::path const& script : scripts.files) {
        mod.interactions.push_back(loadManifest(script, problems));
    }
    return mod;
}

fs::path modsFolder(fs::path const& stated) {
    std::error_code error;
    if (!fs::exists(stated / "mod.json", error)) {
        return stated;
    }
    fs::path const whole = fs::absolute(stated, error).lexically_normal(); // "." has no name
    return (whole.has_filename() ? whole : whole.parent_path()).parent_path();
}

std::vector<fs::path> modFolders(std::span<std::string const> stated, fs::path const& level,
                                 fs::path const& home) {
    std::vector<fs::path> folders;
    for (std::string const& folder : stated) {
        folders.push_back(modsFolder(folder));
    }
    if (!level.empty()) {
        std::error_code error;
        fs::path const at = fs::absolute(level, error).parent_path();
        folders.push_back(at / "mods"); // beside the levels of a pack
        if (fs::exists(at.parent_path() / "mod.json", error)) {
            folders.push_back(at.parent_path().parent_path()); // the level is in a mod itself
        }
    }
    if (fs::path own = inDataFolder("mods"); !own.empty()) {
        folders.push_back(std::move(own));
    }
    folders.push_back(home / "mods");
    return folders;
}

std::vector<fs::path> listMods(std::span<fs::path const> folders) {
    std::map<std::string, fs::path> found;
    for (fs::path const& folder : folders) {
        std::error_code error;
        for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
            std::error_code none;
            if (fs::exists(at->path() / "mod.json", none)) {
                found.emplace(at->path().filename().string(), at->path());
            }
            if (found.size() > mostListed) { // the first by name, whatever their order in the folder is
                found.erase(std::prev(found.end()));
            }
        }
    }
    std::vector<fs::path> all;
    for (auto const& [name, path] : found) {
        all.push_back(path);
    }
    return all;
}

std::vector<Mod> findMods(std::span<std::string const> names, std::span<fs::path const> folders,
                          std::string const& by, Problems& problems) {
    std::map<std::string, Mod> found;
    std::vector<std::pair<std::string, std::string>> wanted; // a mod, and the level or mod that needs it
    for (std::string const& name : names) {
        wanted.emplace_back(name, "the level");
    }
    std::set<std::string> looked;
    while (!wanted.empty()) {
        std::string const name = wanted.back().first;
        std::string const who = wanted.back().second;
        wanted.pop_back();
        if (!looked.insert(name).second) {
            continue;
        }
        if (looked.size() > mostMods) {
            problems.add({.file = by,
                          .path = "",
                          .message = fmt::format("the level and its mods need more than {} mods", mostMods),
                          .expected = fmt::format("at most {}", mostMods)});
            break;
        }
        std::error_code error;
        auto const at = std::find_if(folders.begin(), folders.end(), [&](fs::path const& folder) {
            return isModName(name) && fs::exists(folder / name / "mod.json", error);
        });
        if (at == folders.end()) {
            std::vector<std::string> known;
            for (fs::path const& mod : listMods(folders)) {
                known.push_back(mod.filename().string());
            }
            // A folder of that name is there, but no mod may have it.
            if (std::erase(known, name) > 0) {
                problems.add({.file = by,
                              .path = "",
                              .message = fmt::format("'{}' cannot be the name of a mod", name),
                              .expected =
                                  "a folder, and the same \"name\" in mod.json, of at most 40 small letters, "
                                  "digits and -"});
                continue;
            }
            std::string places;
            for (fs::path const& folder : folders) {
                places += (places.empty() ? "" : ", ") + folder.string();
            }
            problems.add({.file = by,
                          .path = "",
                          .message = fmt::format("{} needs the mod '{}', which is not in {}{}", who, name,
                                                 places, didYouMean(name, known)),
                          .expected = known.empty() ? std::string() : listed(known)});
            continue;
        }
        Mod mod = readMod(*at / name, problems);
        for (std::string const& need : mod.needs) {
            wanted.emplace_back(need, fmt::format("the mod '{}'", name));
        }
        found.emplace(name, std::move(mod));
    }
    std::vector<Mod> all;
    for (auto& [name, mod] : found) {
        all.push_back(std::move(mod));
    }
    return all;
}

std::vector<std::string> modsNamedBy(fs::path const& level) {
    std::vector<std::string> names;
    try {
        auto const document = JsonDocument::load(level);
        auto const& root = document->root();
        if (root.is_object() && root.contains("mods") && root["mods"].is_array()) {
            for (auto const& name : root["mods"]) {
                if (name.is_string()) {
                    names.push_back(name.get<std::string>());
                }
            }
        }
    } catch (InputError const&) {
        names.clear(); // the reader of the level reports the error
    }
    return names;
}

} // namespace trembler::lua

#include "lua/mods/trust.hpp"

#include "runtime/level/json/json_node.hpp"

#include <cstdlib>
#include <fstream>
#include <mutex>
#include <type_traits>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostTrusted = 1000;

struct ForThisRun {
    std::mutex mutex;
    std::set<std::string, std::less<>> names;
};
ForThisRun& forThisRun() {
    static ForThisRun instance;
    return instance;
}

void readTrusted(JsonNode const& node, ModSettings& settings) {
    if (!node.isList("a list of names of mods", mostTrusted)) {
        return;
    }
    for (std::size_t i = 0; i < node.size(); ++i) {
        if (auto const name = node.element(i).name("the name of a mod")) {
            settings.trusted.insert(*name);
        }
    }
}

void readMost(JsonNode const& node, ScriptLimits& most) {
    MemberReader reader(node, "limits of scripts: an object such as {\"instructions\": 400000}");
    if (!reader.valid()) {
        return;
    }
    auto const limit = [&](char const* key, auto& value, double greatest) {
        if (auto const stated = reader.optional(key)) {
            if (auto const number = stated->number(0, greatest)) {
                value = static_cast<std::remove_reference_t<decltype(value)>>(*number);
            }
        }
    };
    constexpr double large = 1e9; // fits into all of them
    limit("instructions", most.instructions, large);
    limit("instructions_per_object", most.instructionsPerObject, large);
    limit("memory", most.memory, large);
    limit("calls", most.calls, large);
    limit("calls_per_object", most.callsPerObject, large);
    limit("creations", most.creations, large);
    limit("log_lines", most.logLines, large);
    reader.finish();
}

} // namespace

fs::path modSettingsFile() {
    if (char const* const config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0') {
        return fs::path(config) / "trembler" / "mods.json";
    }
    if (char const* const user = std::getenv("HOME"); user != nullptr && *user != '\0') {
        return fs::path(user) / ".config" / "trembler" / "mods.json";
    }
    return {};
}

ModSettings readModSettings(fs::path const& file, Problems& problems) {
    ModSettings settings;
    std::error_code error;
    if (file.empty() || !fs::exists(file, error)) {
        return settings;
    }
    std::shared_ptr<JsonDocument const> document;
    try {
        document = JsonDocument::load(file);
    } catch (InputError const& bad) {
        for (Diagnostic const& diagnostic : bad.diagnostics()) {
            problems.add(diagnostic);
        }
        return settings;
    }
    MemberReader reader(JsonNode(*document, document->root(), "", problems),
                        "settings of mods: an object {\"trusted\", \"most\"}");
    if (!reader.valid()) {
        return settings;
    }
    if (auto const trusted = reader.optional("trusted")) {
        readTrusted(*trusted, settings);
    }
    if (auto const most = reader.optional("most")) {
        readMost(*most, settings.most);
    }
    reader.finish();
    return settings;
}

void trustForThisRun(std::vector<std::string> const& names) {
    std::lock_guard const lock(forThisRun().mutex);
    forThisRun().names.insert(names.begin(), names.end());
}

void applyTrust(std::span<Mod> mods, ModSettings const& settings) {
    std::lock_guard const lock(forThisRun().mutex);
    for (Mod& mod : mods) {
        bool const allowed = !mod.besideLevel && settings.trusted.contains(mod.name);
        if (mod.bundled || allowed || forThisRun().names.contains(mod.name)) {
            for (Manifest& manifest : mod.interactions) {
                manifest.trust = Trust::trusted;
            }
        }
    }
}

} // namespace trembler::lua

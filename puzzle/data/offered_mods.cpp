#include "puzzle/data/offered_mods.hpp"

#include "runtime/file/folder_files.hpp"

#include <utility>

namespace trembler {
namespace {

/// As many as a level may name; a trace has no room for the components of more.
constexpr std::size_t mostOffered = 100;

std::vector<std::string> modsWithParts(std::span<std::filesystem::path const> installed) {
    std::vector<std::string> names;
    for (std::filesystem::path const& folder : installed) {
        if (names.size() < mostOffered && !filesIn(folder / "parts", ".json", 1).files.empty()) {
            names.push_back(folder.filename().string());
        }
    }
    return names;
}

Diagnostic faultOf(InputError const& error) {
    if (!error.diagnostics().empty()) {
        return error.diagnostics().front();
    }
    return {.file = {}, .path = {}, .message = error.what(), .expected = {}};
}

} // namespace

OfferedMods offeredMods(std::span<std::filesystem::path const> installed, ModData const& load) {
    OfferedMods offered;
    std::vector<std::string> const all = modsWithParts(installed);
    if (all.empty()) {
        return offered;
    }
    try { // as a rule none is wrong
        offered.data = load(all);
        offered.names = all;
        return offered;
    } catch (InputError const&) { // which one it is shows when they are added one by one
        offered.data = nullptr;
    }
    for (std::string const& name : all) {
        std::vector<std::string> with = offered.names;
        with.push_back(name);
        try {
            offered.data = load(with);
            offered.names = std::move(with);
        } catch (InputError const& error) {
            offered.leftOut.push_back({name, faultOf(error)});
        }
    }
    return offered;
}

} // namespace trembler

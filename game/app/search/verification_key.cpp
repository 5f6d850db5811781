#include "game/app/search/verification_key.hpp"

#include "insight/trial/text_hash.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

namespace trembler {
namespace {

namespace fs = std::filesystem;

/// A file's name and bytes; no bytes if it cannot be read.
void addFile(std::string& text, fs::path const& file) {
    std::ifstream in(file, std::ios::binary);
    std::string const bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    text += fmt::format("{}\n{}\n", file.string(), bytes.size()) + bytes;
}

void addFolder(std::string& text, fs::path const& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (at->is_regular_file(error)) {
            files.push_back(at->path());
        }
    }
    std::sort(files.begin(), files.end());
    for (fs::path const& file : files) {
        addFile(text, file);
    }
}

} // namespace

std::string verificationKey(GameDataByMods& data, fs::path const& level,
                            std::map<std::string, std::string> const& detail) {
    std::string text;
    addFile(text, level);
    try {
        for (lua::Mod const& mod : data.dataFor(level).mods) {
            addFolder(text, mod.folder);
        }
    } catch (InputError const& error) { // the mod's fault is the verdict on the level
        text += error.what();
    }
    for (auto const& [effect, name] : detail) {
        text += fmt::format("{}={}\n", effect, name);
    }
    return fmt::format("verify/{}/{}", insight::hashOf(text), level.string());
}

} // namespace trembler

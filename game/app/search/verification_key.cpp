#include "game/app/search/verification_key.hpp"

#include "insight/trial/text_hash.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace trembler {
namespace {

namespace fs = std::filesystem;

/// A file's name and the hash of its bytes; of none if it cannot be read. A mod may have files of any size,
/// so they are read in pieces, into `piece`, which is used again for each.
void addFile(std::string& text, fs::path const& file, std::string& piece) {
    std::ifstream in(file, std::ios::binary);
    piece.resize(std::size_t{1} << 20U);
    std::string hash;
    while (in) {
        in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        hash = insight::hashOf(hash + piece.substr(0, static_cast<std::size_t>(in.gcount())));
    }
    text += fmt::format("{}\n{}\n", file.string(), hash);
}

void addFolder(std::string& text, fs::path const& folder, std::string& piece) {
    constexpr std::size_t most = 10'000; // files of a mod
    FirstPaths files(most);
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (at->is_regular_file(error)) {
            files.add(at->path());
        }
    }
    for (fs::path const& file : files.sorted()) {
        addFile(text, file, piece);
    }
}

} // namespace

std::string verificationKey(GameDataByMods& data, fs::path const& level,
                            std::map<std::string, std::string> const& detail) {
    std::string text;
    std::string piece;
    addFile(text, level, piece);
    try {
        for (lua::Mod const& mod : data.dataFor(level).mods) {
            addFolder(text, mod.folder, piece);
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

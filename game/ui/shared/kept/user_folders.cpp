#include "game/ui/shared/kept/user_folders.hpp"

#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/read_text.hpp"

#include <cstdlib>
#include <string>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

fs::path fromEnvironment(char const* name) {
    char const* const value = std::getenv(name);
    return value == nullptr ? fs::path() : fs::path(value);
}

/// As the desktop states it; empty if it states none.
fs::path statedFolder(std::string_view name, fs::path const& home) {
    fs::path config = fromEnvironment("XDG_CONFIG_HOME");
    config = config.is_absolute() ? config : home / ".config";
    constexpr std::size_t most = std::size_t{1} << 20U; // bytes; such files have about a thousand
    try {
        return userFolderIn(readText(config / "user-dirs.dirs", most), name, home);
    } catch (InputError const&) {
        return {};
    }
}

} // namespace

fs::path userFolderIn(std::string_view text, std::string_view name, fs::path const& home) {
    std::string const key = std::string(name) + "=\"";
    std::size_t at = text.find(key);
    while (at != std::string_view::npos && at > 0 && text[at - 1] != '\n') { // in a comment
        at = text.find(key, at + 1);
    }
    if (at == std::string_view::npos) {
        return {};
    }
    std::string_view const rest = text.substr(at + key.size());
    std::string stated(rest.substr(0, rest.find('"')));
    constexpr std::string_view inHome = "$HOME";
    if (stated.starts_with(inHome)) {
        stated = home.string() + stated.substr(inHome.size());
    }
    fs::path folder = fs::path(stated).lexically_normal();
    bool const own = folder.is_absolute() && folder != home && folder != home / "";
    return own ? folder : fs::path();
}

fs::path usualPicturesFolder() {
    fs::path const home = fromEnvironment("HOME");
    if (!home.is_absolute()) {
        return ".";
    }
    fs::path const stated = statedFolder("XDG_PICTURES_DIR", home);
    return (stated.empty() ? home / "Pictures" : stated) / "Trembler";
}

fs::path usualDownloadsFolder() {
    fs::path const home = fromEnvironment("HOME");
    if (!home.is_absolute()) {
        return ".";
    }
    fs::path const stated = statedFolder("XDG_DOWNLOAD_DIR", home);
    fs::path const folder = stated.empty() ? home / "Downloads" : stated;
    std::error_code unknown;
    return fs::is_directory(folder, unknown) ? folder : home;
}

} // namespace trembler::ui

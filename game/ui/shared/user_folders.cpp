#include "game/ui/shared/user_folders.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

fs::path fromEnvironment(char const* name) {
    char const* const value = std::getenv(name);
    return value == nullptr ? fs::path() : fs::path(value);
}

} // namespace

fs::path picturesFolderIn(std::string_view text, fs::path const& home) {
    constexpr std::string_view key = "XDG_PICTURES_DIR=\"";
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
    fs::path config = fromEnvironment("XDG_CONFIG_HOME");
    config = config.is_absolute() ? config : home / ".config";
    std::ifstream in(config / "user-dirs.dirs");
    std::string const text(std::istreambuf_iterator<char>(in), {});
    fs::path const stated = picturesFolderIn(text, home);
    return (stated.empty() ? home / "Pictures" : stated) / "Trembler";
}

} // namespace trembler::ui

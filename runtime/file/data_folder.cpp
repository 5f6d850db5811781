#include "runtime/file/data_folder.hpp"

#include <cstdlib>

namespace trembler {

namespace fs = std::filesystem;

fs::path dataFolder() {
    if (char const* const data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
        return fs::path(data) / "trembler";
    }
    if (char const* const home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return fs::path(home) / ".local" / "share" / "trembler";
    }
    return {};
}

fs::path inDataFolder(fs::path const& name) {
    fs::path const folder = dataFolder();
    return folder.empty() ? fs::path() : folder / name;
}

} // namespace trembler

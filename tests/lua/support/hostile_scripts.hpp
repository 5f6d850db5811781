// The scripts of tests/lua/hostile: where they are, and the names of their tests.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace trembler::lua {

/// Its folders are `chunk`, with scripts that are run as a chunk of their own, `apply`, with scripts that use
/// the arguments of `apply`, and `manifest`, with scripts that are only read. In these, scripts are sorted by
/// their target.
inline std::filesystem::path hostileFolder() {
    return std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/lua/hostile";
}

/// The scripts of a folder and of all folders in it, ascending by path.
inline std::vector<std::filesystem::path> scriptsBelow(std::filesystem::path const& folder) {
    std::vector<std::filesystem::path> all;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".lua") {
            all.push_back(entry.path());
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// The path of a script in tests/lua/hostile, of letters that a test's name may have:
/// "chunk_tables_unpack_many".
inline std::string hostileTestName(std::filesystem::path const& script) {
    std::string name = script.lexically_relative(hostileFolder()).replace_extension().generic_string();
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

} // namespace trembler::lua

// Every interaction that is written in C++, and the same one in Lua.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trembler::lua::analysis {

struct Counterpart {
    std::string name;      ///< of the component: "Dynamics <- Gravity"
    std::string className; ///< in C++
    std::vector<std::filesystem::path>
        nativeFiles;              ///< relative to the repository, with its class and functions
    std::filesystem::path script; ///< the Lua file; empty: it cannot be written
    std::string remark;           ///< differences of the script; empty: none
};

/// All interactions that the game registers, in order of registration; a test compares the names.
[[nodiscard]] std::vector<Counterpart> counterparts();

/// Lines with code, comments and includes left out: of the class, of its member functions and of the
/// functions without a name outside their files. Throws std::runtime_error if a file cannot be read.
[[nodiscard]] int nativeLines(Counterpart const& counterpart);
/// Lines with code of the Lua file.
[[nodiscard]] int scriptLines(Counterpart const& counterpart);

} // namespace trembler::lua::analysis

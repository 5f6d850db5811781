// The manifest of a script: the notation of a scripted interaction.
#pragma once

#include "lua/interaction/value.hpp"
#include "lua/sandbox/limits.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trembler::lua {

/// A parameter that levels, parts and players may set.
struct Parameter {
    std::string name;
    Value initial;
    double minimum = -1e300; ///< of a number
    double maximum = 1e300;
    std::string unit;
    std::string text;                   ///< for people
    std::vector<std::string> choices{}; ///< of a text: the allowed values; empty: any
};

/// A field that lasts from turn to turn.
struct StoreField {
    std::string name;
    Value initial;
};

/// The targets to which a script is applied.
enum class Application : std::uint8_t {
    each,  ///< every object that has certain properties
    pairs, ///< every two objects, the one with certain properties and the other with certain others
    once,  ///< once in a turn, to the world
};

struct Manifest {
    std::string name;               ///< "Dynamics <- Wind"
    std::string text;               ///< its description for people
    std::string calls;              ///< the role of its one resolver
    std::vector<std::string> reads; ///< names of properties
    Application application = Application::each;
    std::vector<std::string> first;  ///< properties that an object has, or the first of a pair
    std::vector<std::string> second; ///< those of the second of a pair
    double within = 0;               ///< m, between the centres of a pair
    std::string withinParameter;     ///< the parameter that states it instead; empty: none
    bool touching = false;           ///< pairs that are in contact
    bool attached = false;           ///< the first, or only, object names the script in its property Scripts
    bool restless = false;           ///< applied in every turn, even if nothing that it reads has changed
    std::vector<Parameter> parameters; ///< ascending by name
    std::vector<StoreField> objectStore;
    std::vector<StoreField> scriptStore;
    ScriptLimits limits;
    Trust trust = Trust::untrusted; ///< how it is run; decided where it is registered, never by the script

    std::string file;   ///< for messages
    std::string source; ///< the text of the script

    [[nodiscard]] Parameter const* parameter(std::string_view name_) const;
    /// The line in which a word first stands in the script; 0: nowhere.
    [[nodiscard]] std::size_t lineOf(std::string_view word) const;
    /// A problem, at the line in which `word` stands; with `table`, first behind that word.
    [[nodiscard]] Diagnostic problem(std::string_view word, std::string message, std::string expected,
                                     std::string_view table = {}) const;
};

/// Reads a script's statements about itself. Adds all errors to `problems`, with file and line. Does not
/// check whether the properties and the resolver exist: see declare().
[[nodiscard]] Manifest readManifest(std::string source, std::string file, Problems& problems);
/// The same with a file.
[[nodiscard]] Manifest loadManifest(std::filesystem::path const& path, Problems& problems);

} // namespace trembler::lua

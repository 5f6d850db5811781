// Random levels, generated from the JSON Schema of level files: anything that the schema allows, including
// the extremes of every number, so that new fields and properties are tested automatically.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace trembler::worlds {

/// How wild a level is.
struct Manner {
    double extremes = 0.05; ///< share of all numbers that stand at an end of their range, 0 or tiny
    double anywhere = 0.05; ///< share of all numbers that lie anywhere in their range, by size or evenly
    int objects = 8;
    int joints = 4;
    double spread = 4;      ///< m; half the width of the room that objects are strewn in; 0: all in one place
    bool manyOfOne = false; ///< all objects are like the first but for their places
    double properties = 0.2; ///< share of all properties that an object has beside shape and mass
};

/// The manner of the level of a seed: all kinds come, the wild and the crowded ones more rarely.
[[nodiscard]] Manner mannerOf(std::uint64_t seed);

/// Makes levels. The same schema, parts, manner and seed make the same level on every machine.
class RandomLevels {
public:
    /// `schema` is levelSchema() of everything that the program knows; `parts` are the names of its parts.
    RandomLevels(nlohmann::json schema, std::vector<std::string> parts);

    [[nodiscard]] nlohmann::json make(std::uint64_t seed) const { return make(seed, mannerOf(seed)); }
    /// A level that the schema accepts. The reader may still refuse it, as not every rule is in the schema.
    [[nodiscard]] nlohmann::json make(std::uint64_t seed, Manner const& manner) const;

    /// Levels that state one property in one object each, with one number at an end of its range and all
    /// others ordinary: one level for each end of each number of each property.
    [[nodiscard]] std::vector<nlohmann::json> boundaries() const;

private:
    nlohmann::json schema_;
    std::vector<std::string> parts_;
};

/// Takes away what a problem at `path` (a JSON pointer) is about: the property of an object, the object's
/// part, a member of the world, an entry of a list. Returns false if there is nothing to take away.
bool takeAway(nlohmann::json& level, std::string const& path);

} // namespace trembler::worlds

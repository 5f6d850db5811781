// Random levels, generated from the JSON Schema of level files: anything that the schema allows, including
// the extremes of every number, so that new fields and properties are tested automatically.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace trembler::worlds {

/// Parameters of random levels.
struct Manner {
    double extremes = 0.05; ///< share of all numbers that are at an end of their range, 0 or tiny
    /// Share of all numbers that are anywhere in their range, uniformly or logarithmically.
    double anywhere = 0.05;
    int objects = 8;
    int joints = 4;
    double spread = 4; ///< m; half the width of the area in which objects are placed; 0: all in one place
    bool manyOfOne = false;  ///< all objects are like the first, except for their places
    double properties = 0.2; ///< share of all properties that an object has besides shape and mass
};

/// The parameters for a seed: all combinations occur, extreme and crowded ones more rarely.
[[nodiscard]] Manner mannerOf(std::uint64_t seed);

/// Makes levels. The same schema, parts, manner and seed make the same level on every machine.
class RandomLevels {
public:
    /// `schema` is levelSchema() of the whole program; `parts` are the names of its parts.
    RandomLevels(nlohmann::json schema, std::vector<std::string> parts);

    [[nodiscard]] nlohmann::json make(std::uint64_t seed) const { return make(seed, mannerOf(seed)); }
    /// A level that the schema accepts. The reader may still reject it, because not every rule is in the
    /// schema.
    [[nodiscard]] nlohmann::json make(std::uint64_t seed, Manner const& manner) const;

    /// Levels with one property in one object each, with one number at an end of its range and all others
    /// ordinary: one level for each end of each number of each property.
    [[nodiscard]] std::vector<nlohmann::json> boundaries() const;

private:
    nlohmann::json schema_;
    std::vector<std::string> parts_;
};

/// Removes the value that a problem at `path` (a JSON pointer) concerns: the property of an object, the
/// object's part, a member of the world, an entry of a list. Returns false if there is nothing to remove.
bool takeAway(nlohmann::json& level, std::string const& path);

} // namespace trembler::worlds

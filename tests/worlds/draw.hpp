// Draws a value that a schema accepts.
#pragma once

#include "tests/worlds/random_level.hpp"

#include <optional>
#include <random>

namespace trembler::worlds {

/// Draws from one stream of random numbers, without the standard library's distributions, whose results
/// differ between implementations.
class Draw {
public:
    Draw(nlohmann::json const& schema, std::vector<std::string> const& parts, Manner const& manner,
         std::uint64_t seed)
        : schema_(schema), parts_(parts), manner_(manner), random_(seed) {}

    /// The names that may be referred to: objects, and joints that gears can couple.
    std::vector<std::string> objects;
    std::vector<std::string> couplings;
    /// Makes every number ordinary except the n-th, from 0, which is at the low or the high end of its range.
    struct Spike {
        std::size_t number;
        bool high;
    };
    std::optional<Spike> spike;
    /// Number of values with two ends that have been drawn so far.
    [[nodiscard]] std::size_t numbers() const { return numbers_; }

    /// A value for a member `key`, which determines the meaning of names and places.
    [[nodiscard]] nlohmann::json value(nlohmann::json const& schema, std::string const& key);
    [[nodiscard]] nlohmann::json object(nlohmann::json const& schema, double share);
    [[nodiscard]] nlohmann::json shape();
    [[nodiscard]] nlohmann::json joint(nlohmann::json const& schema);
    /// A place [x, y] in the level's area.
    [[nodiscard]] nlohmann::json place();

    [[nodiscard]] std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
    [[nodiscard]] double unit() { return static_cast<double>(random_() >> 11U) * 0x1p-53; } ///< [0, 1)
    [[nodiscard]] bool chance(double share) { return unit() < share; }
    /// Between both, uniformly in the logarithm.
    [[nodiscard]] double bySize(double low, double high) {
        return std::exp(std::log(low) + unit() * (std::log(high) - std::log(low)));
    }
    template <class T>
    [[nodiscard]] T const& oneOf(std::vector<T> const& all) {
        return all[below(all.size())];
    }

private:
    [[nodiscard]] nlohmann::json const& resolved(nlohmann::json const& schema) const;
    [[nodiscard]] nlohmann::json number(nlohmann::json const& schema);
    [[nodiscard]] double ordinary(double low, double high);
    [[nodiscard]] double wild(double low, double high);
    [[nodiscard]] nlohmann::json list(nlohmann::json const& schema, std::string const& key);
    [[nodiscard]] nlohmann::json text(std::string const& key);
    [[nodiscard]] std::string name();

    nlohmann::json const& schema_;
    std::vector<std::string> const& parts_;
    Manner const& manner_;
    std::mt19937_64 random_;
    std::size_t numbers_ = 0;
    int depth_ = 0;
};

} // namespace trembler::worlds

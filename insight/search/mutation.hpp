// New attempts, made from attempts that nearly succeeded.
#pragma once

#include "insight/search/deeds.hpp"
#include "insight/search/places.hpp"
#include "insight/search/thing.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace trembler::insight {

/// An attempt from which others are made.
struct Parent {
    Solution solution;
    double miss = 1;
    std::uint64_t run = 0; ///< in which it was tried
};

/// The attempts that were tried, by identityOf().
using Tried = std::set<std::string>;

/// An attempt, and the one from which it was made.
struct Attempt {
    Solution solution;
    std::uint64_t parent = 0; ///< Parent::run; 0: none
};

/// Makes attempts for one level. A pure function of its arguments, for any number of threads.
class Mutator {
public:
    /// `hands`: whether it may drag and cut. The level must outlive it.
    Mutator(LevelUnderTest const& level, bool hands);

    [[nodiscard]] std::span<Place const> places() const { return places_; }
    /// 1 to 4 parts of the toolbox at once, half of them in places of interest, each kind of which is as
    /// likely as the others, and half of them in random places; and random wires. A trial of several parts
    /// tests the places of all of them, and what a solution does not need is left out of it later.
    [[nodiscard]] Solution combined(CounterRandom& random) const;
    /// One of the parents, the nearer the more often, changed once or more: a part is moved, turned,
    /// mirrored, added, exchanged for another one, taken from another parent or left out; a wire or a deed is
    /// added or left out. Its parts fit where they are, and it has not been tried; if none of 12 changes led
    /// to such an attempt, it is a combined one. `parents` must not be empty, and begin with the nearest.
    [[nodiscard]] Attempt changed(std::span<Parent const> parents, Tried const& tried,
                                  CounterRandom& random) const;

private:
    void changeOnce(Solution& solution, std::span<Parent const> parents, CounterRandom& random) const;
    void movePart(Solution& solution, CounterRandom& random) const;
    static void turnPart(Solution& solution, CounterRandom& random);
    void addPart(Solution& solution, CounterRandom& random) const;
    void exchangePart(Solution& solution, CounterRandom& random) const;
    void takeOver(Solution& solution, Parent const& other, CounterRandom& random) const;
    /// A place of interest, of each kind as often.
    [[nodiscard]] Place const& anyPlace(CounterRandom& random) const;
    [[nodiscard]] std::optional<Placement> placedSomewhere(Solution const& others, std::string const& part,
                                                           double byChance, CounterRandom& random) const;

    LevelUnderTest const& level_;
    bool hands_;
    std::vector<Place> places_;
    std::vector<std::vector<std::size_t>> byKind_; // places in places_; no kind without any
    std::vector<Thing> things_;
};

} // namespace trembler::insight

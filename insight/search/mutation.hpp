// New attempts, made from attempts that nearly succeeded.
#pragma once

#include "insight/search/deeds.hpp"
#include "insight/search/places.hpp"
#include "insight/search/thing.hpp"

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

/// Makes attempts for one level. A pure function of its arguments, for any number of threads.
class Mutator {
public:
    /// `hands`: whether it may drag and cut. The level must outlive it.
    Mutator(LevelUnderTest const& level, bool hands);

    [[nodiscard]] std::span<Place const> places() const { return places_; }
    /// One of the parents, the nearer the more often, changed once or more: a part is moved, turned,
    /// mirrored, added, exchanged for another one, taken from another parent or left out; a wire or a deed is
    /// added or left out. Its parts fit where they are, unless none of 12 changes did. `parents` must not be
    /// empty, and begin with the nearest.
    [[nodiscard]] Solution changed(std::span<Parent const> parents, CounterRandom& random) const;

private:
    void changeOnce(Solution& solution, std::span<Parent const> parents, CounterRandom& random) const;
    void movePart(Solution& solution, CounterRandom& random) const;
    static void turnPart(Solution& solution, CounterRandom& random);
    void addPart(Solution& solution, CounterRandom& random) const;
    void exchangePart(Solution& solution, CounterRandom& random) const;
    void takeOver(Solution& solution, Parent const& other, CounterRandom& random) const;

    LevelUnderTest const& level_;
    bool hands_;
    std::vector<Place> places_;
    std::vector<Thing> things_;
};

} // namespace trembler::insight

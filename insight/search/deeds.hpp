// Simple things that a player may do while a level runs: drag an object, cut a wire.
#pragma once

#include "insight/chance/counter_random.hpp"
#include "insight/search/places.hpp"
#include "insight/search/thing.hpp"
#include "insight/trial/level_under_test.hpp"

#include <span>

namespace trembler::insight {

/// Adds inputs that grab one of the level's movable things, drag it to one of the places in a second or two,
/// and let go; or that cut one of its wires. False if there is nothing of the kind. Inputs stay ascending by
/// frame.
bool addRandomDeed(LevelUnderTest const& level, std::span<Thing const> things, std::span<Place const> places,
                   Solution& solution, CounterRandom& random);
/// Takes one deed away, see deedsOf(). False if there is none.
bool removeRandomDeed(Solution& solution, CounterRandom& random);

} // namespace trembler::insight

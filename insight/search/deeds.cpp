#include "insight/search/deeds.hpp"

#include "insight/ablation/needs.hpp"

#include <algorithm>
#include <array>

namespace trembler::insight {
namespace {

constexpr std::array<std::uint64_t, 4> beginnings{1, 30, 60, 180}; // frames
constexpr std::uint64_t moves = 20;                                // of a drag
constexpr std::array<std::uint64_t, 2> pauses{3, 6};               // frames between them
constexpr std::array<std::uint64_t, 3> held{1, 60, 240};           // frames at the end of a drag

void sortByFrame(Solution& solution) {
    std::stable_sort(solution.inputs.begin(), solution.inputs.end(),
                     [](RecordedInput const& a, RecordedInput const& b) { return a.frame < b.frame; });
}

/// The first frame after all inputs, as a hand does one deed after another.
std::uint64_t firstFreeFrame(Solution const& solution) {
    std::uint64_t free = 1;
    for (RecordedInput const& input : solution.inputs) {
        free = std::max(free, input.frame + 2);
    }
    return free;
}

bool addCut(LevelUnderTest const& level, Solution& solution, CounterRandom& random) {
    std::vector<LevelConnection> const& wires = level.level().connections;
    if (wires.empty()) {
        return false;
    }
    LevelConnection const& wire = wires[random.below(wires.size())];
    for (RecordedInput const& input : solution.inputs) {
        if (input.kind == PlayerInput::Kind::cut && input.object == wire.a && input.other == wire.b) {
            return false;
        }
    }
    RecordedInput cut;
    cut.frame = beginnings[random.below(beginnings.size())];
    cut.kind = PlayerInput::Kind::cut;
    cut.object = wire.a;
    cut.other = wire.b;
    solution.inputs.push_back(cut);
    sortByFrame(solution);
    return true;
}

bool addDrag(std::span<Thing const> things, std::span<Place const> places, Solution& solution,
             CounterRandom& random) {
    std::vector<Thing const*> movable;
    for (Thing const& thing : things) {
        if (thing.movable) {
            movable.push_back(&thing);
        }
    }
    if (movable.empty() || places.empty()) {
        return false;
    }
    Thing const& thing = *movable[random.below(movable.size())];
    Vec2 target = places[random.below(places.size())].at;
    target += 0.1 * Vec2{random.bell(), random.bell()};
    std::uint64_t const pause = pauses[random.below(pauses.size())];
    RecordedInput input;
    input.frame = std::max(beginnings[random.below(beginnings.size())], firstFreeFrame(solution));
    input.kind = PlayerInput::Kind::grab;
    input.object = thing.name;
    input.at = thing.at;
    solution.inputs.push_back(input);
    input.object.clear();
    input.kind = PlayerInput::Kind::move;
    for (std::uint64_t n = 1; n <= moves; ++n) {
        input.frame += pause;
        input.at = thing.at + (static_cast<double>(n) / moves) * (target - thing.at);
        solution.inputs.push_back(input);
    }
    input.kind = PlayerInput::Kind::release;
    input.frame += held[random.below(held.size())];
    input.at = {};
    solution.inputs.push_back(input);
    sortByFrame(solution);
    return true;
}

} // namespace

bool addRandomDeed(LevelUnderTest const& level, std::span<Thing const> things, std::span<Place const> places,
                   Solution& solution, CounterRandom& random) {
    constexpr std::size_t mostInputs = 100;
    if (solution.inputs.size() > mostInputs) {
        return false;
    }
    return random.chance(0.35) ? addCut(level, solution, random) : addDrag(things, places, solution, random);
}

bool removeRandomDeed(Solution& solution, CounterRandom& random) {
    std::vector<Deed> const deeds = deedsOf(solution);
    if (deeds.empty()) {
        return false;
    }
    std::vector<std::size_t> gone = deeds[random.below(deeds.size())].inputs;
    std::sort(gone.rbegin(), gone.rend());
    for (std::size_t const index : gone) {
        solution.inputs.erase(solution.inputs.begin() + static_cast<std::ptrdiff_t>(index));
    }
    return true;
}

} // namespace trembler::insight

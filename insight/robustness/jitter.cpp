#include "insight/robustness/jitter.hpp"

#include "insight/ablation/needs.hpp"
#include "insight/trial/trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::insight {
namespace {

constexpr int mostDraws = 64;

/// Within a disc of radius 1, evenly.
Vec2 inDisc(CounterRandom& random) {
    while (true) {
        double const x = random.between(-1, 1);
        double const y = random.between(-1, 1);
        if (x * x + y * y <= 1) {
            return {x, y};
        }
    }
}

/// Whether an input uses a hand, so that two of one hand must stay in their order.
bool usesHand(RecordedInput const& input) {
    return input.kind != PlayerInput::Kind::cut && input.kind != PlayerInput::Kind::remove;
}

/// Does each deed a little earlier or later, and grips a little beside, as a whole.
void displaceDeeds(Solution& solution, Jitter const& jitter, CounterRandom& random) {
    std::array<std::int64_t, 2> free{1, 1}; // by hand, the first frame in which it may do something else
    for (Deed const& deed : deedsOf(solution)) {
        RecordedInput const& first = solution.inputs[deed.inputs.front()];
        auto const begin = static_cast<std::int64_t>(first.frame);
        std::int64_t const wanted =
            begin + std::llround(random.between(-1, 1) * jitter.seconds / frameDuration);
        std::size_t const hand = first.hand == 1 ? 1 : 0;
        bool const byHand = usesHand(first);
        std::int64_t const shift = std::max(wanted, byHand ? free[hand] : std::int64_t{1}) - begin;
        Vec2 const beside = jitter.distance * inDisc(random);
        for (std::size_t const i : deed.inputs) {
            RecordedInput& input = solution.inputs[i];
            input.frame = static_cast<std::uint64_t>(static_cast<std::int64_t>(input.frame) + shift);
            if (byHand) {
                input.at += beside;
                free[hand] = std::max(free[hand], static_cast<std::int64_t>(input.frame));
            }
        }
    }
    std::stable_sort(solution.inputs.begin(), solution.inputs.end(),
                     [](RecordedInput const& a, RecordedInput const& b) { return a.frame < b.frame; });
}

} // namespace

bool canBeDisplaced(Solution const& solution) {
    return !solution.placements.empty() || !solution.inputs.empty();
}

std::optional<Solution> jittered(LevelUnderTest const& level, Solution const& solution, Jitter const& jitter,
                                 CounterRandom& random, int& redrawn) {
    // Parts in a designer's recording may overlap by more than a player's can; then overlaps do not count.
    bool const fits = !whyNotPlaced(level, solution);
    for (int draw = 0; draw < mostDraws; ++draw) {
        Solution made = solution;
        for (Placement& placement : made.placements) {
            placement.at += jitter.distance * inDisc(random);
            placement.angle += jitter.angle * pi / 180 * random.between(-1, 1);
        }
        if (!fits || !whyNotPlaced(level, made)) {
            displaceDeeds(made, jitter, random);
            return made;
        }
        ++redrawn;
    }
    return std::nullopt;
}

} // namespace trembler::insight

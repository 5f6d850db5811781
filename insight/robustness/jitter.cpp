#include "insight/robustness/jitter.hpp"

#include "insight/trial/trial.hpp"

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

} // namespace

std::optional<Solution> jittered(LevelUnderTest const& level, Solution const& solution, Jitter const& jitter,
                                 CounterRandom& random, int& redrawn) {
    // What a designer recorded may overlap by more than a player's parts can; then overlaps do not count.
    bool const fits = !whyNotPlaced(level, solution);
    for (int draw = 0; draw < mostDraws; ++draw) {
        Solution made = solution;
        for (Placement& placement : made.placements) {
            placement.at += jitter.distance * inDisc(random);
            placement.angle += jitter.angle * pi / 180 * random.between(-1, 1);
        }
        if (!fits || !whyNotPlaced(level, made)) {
            return made;
        }
        ++redrawn;
    }
    return std::nullopt;
}

} // namespace trembler::insight

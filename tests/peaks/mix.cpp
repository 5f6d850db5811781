#include "tests/peaks/mix.hpp"

#include "audio/device/loudspeaker.hpp"
#include "audio/device/openal_output.hpp"
#include "game/ui/headless/run_sound.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "puzzle/run/runner.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/audio/synth/true_peak.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/worlds/trial.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trembler::peaks {
namespace {

double loudestTenth(std::span<float const> samples) {
    constexpr std::size_t tenth = 4800;
    constexpr std::size_t hop = 1200;
    double loudest = 0;
    for (std::size_t begin = 0; begin + tenth <= samples.size(); begin += hop) {
        double sum = 0;
        for (float const sample : samples.subspan(begin, tenth)) {
            sum += static_cast<double>(sample) * static_cast<double>(sample);
        }
        loudest = std::max(loudest, sum / tenth);
    }
    return loudest;
}

} // namespace

Mix mixOf(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
          std::string const& solution, std::uint64_t frames) {
    Session session(registry, parts, level);
    if (!solution.empty()) {
        session.load(*level.findSolution(solution));
    }
    std::string why;
    auto output = OpenAlOutput::loopback({}, why);
    if (output == nullptr) {
        throw std::runtime_error(why);
    }
    OpenAlOutput const& played = *output;
    OutputSettings loud;
    loud.volume = 1;
    Loudspeaker loudspeaker({.synthesiser = {}, .output = loud, .sampleFolders = {}}, std::move(output));
    Listener listener;
    std::vector<float> samples;
    RunOptions options;
    options.frames = frames;
    options.enter = [&](Session& begun) {
        listener = ui::listenerFor(begun.level(), begun.world());
        loudspeaker.enter(begun.world());
    };
    options.frame = [&](World const& world) {
        loudspeaker.frame(world, listener);
        samples.insert(samples.end(), played.rendered().begin(), played.rendered().end());
    };
    (void)run(session, "a level", options);
    Mix mix;
    mix.frames = session.world().frame();
    double peak = 0;
    double loudest = 0;
    for (std::size_t const channel : {0U, 1U}) {
        std::vector<float> const one = test::channelOf(samples, channel);
        peak = std::max(peak, test::truePeak(one));
        mix.step = std::max(mix.step, test::greatestStep(one));
        loudest = std::max(loudest, loudestTenth(one));
    }
    mix.truePeak = test::inDecibels(peak);
    mix.loudest = 0.5 * test::inDecibels(loudest);
    return mix;
}

RandomMixes::RandomMixes(std::uint64_t seed)
    : schema_(levelSchema(levelKit().registry)), levels_(schema_, levelKit().parts.names()), seed_(seed) {}

RandomMixes::Named RandomMixes::next(std::uint64_t frames, std::function<bool(std::uint64_t)> const& wanted) {
    for (;; ++seed_) {
        if ((wanted && !wanted(seed_)) || worlds::mannerOf(seed_).spread < 1) {
            continue;
        }
        // The trial removes what the reader refuses, and keeps worlds away that end the process.
        worlds::Outcome const outcome =
            worlds::tryOut(levels_.make(seed_), schema_, {.engines = {"box2d"}, .threads = {1}, .frames = 1});
        if (!outcome.played || !outcome.failures.empty()) {
            continue;
        }
        LevelFile const level =
            readLevel(levelKit().registry, JsonDocument::parse(outcome.level.dump(), "random.json"));
        return {seed_++, mixOf(levelKit().registry, levelKit().parts, level, "", frames)};
    }
}

std::string faultOf(Mix const& mix) {
    if (!(mix.truePeak <= -1)) {
        return fmt::format("a true peak of {:.2f} dB of full scale", mix.truePeak);
    }
    if (!(mix.step <= 0.5)) {
        return fmt::format("a step of {:.2f} of full scale", mix.step);
    }
    return {};
}

} // namespace trembler::peaks

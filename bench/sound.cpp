// The cost of sound: 200 bodies that hit the floor in one frame, computed in the world, synthesised and
// rendered into memory, compared with a tenth of a frame; and the savings and losses of fewer modes and of
// masking.
#include "audio/effect/properties/decibel.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "audio/effect/register.hpp"
#include "audio/synth/synthesiser.hpp"
#include "bench/measure.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/material.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"
#ifdef TREMBLER_BENCH_OPENAL
#include "audio/device/openal_output.hpp"
#endif

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace {

using namespace trembler;

constexpr int things = 200;
constexpr double frame = 1e6 / 60; // µs

struct Crash {
    Subscription heard;
    explicit Crash(std::string const& level) {
        registerEverything(registry);
        registerSound(registry);
        world = std::make_unique<World>(
            registry,
            WorldOptions{.threads = 1, .detail = {{"sound", level}}, .periods = {}, .trace = false});
        Store& store = world->store();
        store.column<GravityField>().set(store.create("world"), {{0, -9.81}});
        add("floor", Material::stone, boxPiece(200, 0.4), {0, -0.2});
        store.column<Fixed>().set(store.find("floor"), {});
        for (int i = 0; i < things; ++i) {
            // Plates, bars and crates of many sizes, so that few modes coincide.
            double const size = 0.2 + 0.0017 * i;
            double const height = i % 3 == 0 ? 0.05 : 0.6 * size;
            add("thing " + std::to_string(i), static_cast<Material>(i % 6), boxPiece(size, height),
                {-90 + 0.9 * i, 0.5 + height / 2});
        }
        heard = world->want<Sounds>();
        world->start();
    }
    void add(std::string const& name, Material material, ShapePiece piece, Vec2 at) {
        Store& store = world->store();
        ObjectId const id = store.create(name);
        store.column<Shape>().set(id, {{std::move(piece)}});
        store.column<Position>().set(id, {at});
        store.column<MadeOf>().set(id, {material});
    }
    /// Steps the world; returns the time of its sound components, µs.
    double step() {
        world->step();
        double sum = 0;
        for (ComponentStatus const& status : world->status()) {
            if (status.info->text.effect == "sound") {
                sum += status.lastMicroseconds;
            }
        }
        return sum;
    }
    [[nodiscard]] Sounds const& sounds() const { return *world->find<Sounds>(); }

    Registry registry;
    std::unique_ptr<World> world;
};

constexpr std::size_t before = 12; // frames; the impacts are in them
constexpr std::size_t after = 60;

/// The times of one frame, µs.
struct FrameCost {
    double world = 0;
    double synthesis = 0;
    double output = 0;
    [[nodiscard]] double sum() const { return world + synthesis + output; }
};
struct Run {
    std::vector<FrameCost> frames;
    std::size_t impacts = 0; // in the worst frame
    std::size_t modes = 0;
    std::size_t rendered = 0;
    std::vector<float> mix; // at the listener's place
};

double microsecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

Run runOnce(std::string const& level, bool masking) {
    constexpr Listener listener{{0, 1}, 5, {}};
    Crash crash(level);
    SynthesiserOptions options;
    options.masking = masking;
    Synthesiser synthesiser(options);
#ifdef TREMBLER_BENCH_OPENAL
    std::string why;
    auto const output = OpenAlOutput::loopback(options, why);
#endif
    Run run;
    for (std::size_t i = 0; i < before + after; ++i) {
        FrameCost cost;
        cost.world = crash.step();
        auto start = std::chrono::steady_clock::now();
        synthesiser.hear(crash.sounds(), listener);
        auto const voices = synthesiser.render();
        cost.synthesis = microsecondsSince(start);
        start = std::chrono::steady_clock::now();
#ifdef TREMBLER_BENCH_OPENAL
        if (output) {
            output->play(voices, listener);
        }
#endif
        cost.output = microsecondsSince(start);
        run.frames.push_back(cost);
        std::vector<float> mix(static_cast<std::size_t>(options.block), 0);
        for (Voice const& voice : voices) {
            auto const gain = static_cast<float>(
                1 / std::max(1.0, std::hypot(length(voice.at - listener.at), listener.height)));
            for (std::size_t n = 0; n < mix.size(); ++n) {
                mix[n] += gain * voice.samples[n];
            }
        }
        run.mix.insert(run.mix.end(), mix.begin(), mix.end());
        run.impacts = std::max(run.impacts, crash.sounds().impacts.size());
        run.modes = std::max(run.modes, synthesiser.counts().modes);
        run.rendered = std::max(run.rendered, synthesiser.counts().rendered);
    }
    return run;
}

/// The same run several times: the median of each frame, because the machine is shared and the scheduler
/// interrupts for several milliseconds.
Run medianRun(std::string const& level, bool masking) {
    constexpr std::size_t repetitions = 15;
    std::vector<Run> all;
    for (std::size_t i = 0; i < repetitions; ++i) {
        all.push_back(runOnce(level, masking));
    }
    Run result = all.front();
    for (std::size_t f = 0; f < result.frames.size(); ++f) {
        for (auto const part : {&FrameCost::world, &FrameCost::synthesis, &FrameCost::output}) {
            std::vector<double> values;
            for (Run const& run : all) {
                values.push_back(run.frames[f].*part);
            }
            auto const middle = values.begin() + repetitions / 2;
            std::nth_element(values.begin(), middle, values.end());
            result.frames[f].*part = *middle;
        }
    }
    return result;
}

FrameCost worstOf(Run const& run) {
    return *std::max_element(run.frames.begin(), run.frames.end(),
                             [](FrameCost const& a, FrameCost const& b) { return a.sum() < b.sum(); });
}
double meanOf(Run const& run) {
    double sum = 0;
    for (std::size_t f = before; f < run.frames.size(); ++f) {
        sum += run.frames[f].sum();
    }
    return sum / after;
}

/// The power of the difference of two renderings over that of the reference, in dB.
double errorOf(std::vector<float> const& mix, std::vector<float> const& reference) {
    double difference = 0;
    double power = 0;
    for (std::size_t n = 0; n < mix.size(); ++n) {
        auto const d = static_cast<double>(mix[n] - reference[n]);
        difference += d * d;
        power += static_cast<double>(reference[n]) * static_cast<double>(reference[n]);
    }
    return 10 * std::log10(std::max(1e-12, difference / power));
}

} // namespace

int main() {
    Run const reference = medianRun("32-modes", false);
    bench::Table table(
        fmt::format("{} bodies hit the floor at once: {} impacts in the worst of frames of {:.0f} µs", things,
                    reference.impacts, frame));
    for (std::string const level : {"1-mode", "4-modes", "8-modes", "16-modes", "32-modes"}) {
        for (bool const masking : {true, false}) {
            Run const run = level == "32-modes" && !masking ? reference : medianRun(level, masking);
            FrameCost const worst = worstOf(run);
            std::string const name = level + (masking ? "" : ", nothing masked") + ": worst frame";
            if (level == "8-modes" && masking) {
                table.row(name, worst.sum(), "µs", worst.sum() / frame, 0.1);
            } else {
                table.row(name, worst.sum(), "µs");
            }
            table.row("    of which in the world", worst.world, "µs");
            table.row("    of which synthesis", worst.synthesis, "µs");
            table.row("    of which OpenAL, 64 places and a rest", worst.output, "µs");
            table.row("    mean over the second after", meanOf(run), "µs");
            table.row("    modes rendered", static_cast<double>(run.rendered),
                      fmt::format("of {} that sound", run.modes));
            table.row("    difference from 32 modes", errorOf(run.mix, reference.mix), "dB");
        }
    }
    table.print();
    return 0;
}

#include "game/ui/headless/clip.hpp"

#include "game/ui/headless/scene_painter.hpp"
#include "game/ui/play/view/sound_view.hpp"
#include "game/ui/play/view/spark_view.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "render/gl/webp.hpp"

#include <cmath>

namespace trembler::ui {
namespace {

constexpr double worldRate = 60; // frames per second

std::uint64_t framesIn(double seconds) {
    return static_cast<std::uint64_t>(std::llround(seconds * worldRate));
}

} // namespace

void writeClip(Session& session, ClipOptions const& options, OutputFile& file) {
    render::AnimatedWebp clip(options.size); // refuses a size before any work
    SoundView sounds;
    SparkView sparks;
    std::uint64_t const before = framesIn(options.from);
    auto const pictures = static_cast<std::uint64_t>(std::ceil(options.seconds * options.rate));
    std::uint64_t const total = before + framesIn(options.seconds) + pictures;
    std::uint64_t done = 0;
    auto const tell = [&] {
        ++done;
        if (options.progress) {
            options.progress(done, total);
        }
    };
    std::uint64_t frame = 0;
    auto const stepTo = [&](std::uint64_t wanted) {
        for (; frame < wanted; ++frame) {
            sounds.beforeStep(session.world());
            session.step();
            sounds.afterStep(session.world());
            sparks.afterStep(session.world());
            sparks.pass(1 / worldRate);
            tell();
        }
    };
    Subscription const patches = session.world().want<ContactPatches>(); // for the sparks
    stepTo(before);
    render::Window window({.size = options.size, .mode = render::WindowMode::Offscreen});
    ScenePainter painter(window, session);
    auto const millisecondsOf = [&](std::uint64_t picture) {
        return std::llround(1000.0 * static_cast<double>(picture) / options.rate);
    };
    for (std::uint64_t i = 0; i < pictures; ++i) {
        stepTo(before + framesIn(static_cast<double>(i) / options.rate));
        clip.add(painter.draw(session, {.overlays = options.overlays, .ripples = sounds.ripples()},
                              sparks.sparks()),
                 millisecondsOf(i));
        tell();
    }
    clip.write(file, millisecondsOf(pictures));
    file.check();
}

} // namespace trembler::ui

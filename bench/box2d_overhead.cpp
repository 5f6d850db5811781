// The overhead of Trembler's architecture: two scenes of Box2D's own testbed in a Trembler world and on bare
// Box2D (see box2d_scenes.hpp). Both run in this process, alternating in blocks of frames, and their motion
// must be bit for bit the same. CPU time of this thread, medians over blocks.
#include "bench/measure.hpp"
#include "bench/scenes/box2d_scenes.hpp"
#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/register_physics.hpp"
#include "runtime/component/interaction.hpp"

#include <cstring>
#include <optional>

namespace {

using namespace trembler;
using bench::Bare;
using bench::SceneOf;
using bench::timeBlock;
using bench::Trembler;

constexpr int blockFrames = 10;
constexpr int warmUpFrames = 60;

// A component that reads touches: because of it, contacts are evaluated again at the end of a frame in which
// bodies moved far, see box2d_frame_end.cpp.
struct ReadsTouches final : Interaction<ReadsTouches, DynamicsRole, Reads<Contacts>> {
    static constexpr ComponentText text{
        .name = "Dynamics <- Touches", .effect = "bench", .level = "", .work = "Reads touches."};
    using Activation = NeedsAll<>;
    void apply(Access& access) { touches += access.read<Contacts>().current.size(); }
    static constexpr Coverage memory = leftOut("a count that keeps the reading from being optimised away");
    std::size_t touches = 0;
};

bool run(Registry const& registry, SceneOf const& scene, int repetitions, bool verbose,
         std::optional<double> limit) {
    bench::Series bare;
    bench::Series ours;
    bench::Series ratio;
    bool same = true;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        Bare a(scene);
        Trembler b(registry, scene);
        for (int frame = 0; frame < warmUpFrames; ++frame) {
            a.step();
            b.step();
        }
        for (int block = 0; block < scene.blocks; ++block) {
            double timeA = 0;
            double timeB = 0;
            if (block % 2 == 0) {
                timeA = timeBlock(a, blockFrames);
                timeB = timeBlock(b, blockFrames);
            } else {
                timeB = timeBlock(b, blockFrames);
                timeA = timeBlock(a, blockFrames);
            }
            bare.add(timeA);
            ours.add(timeB);
            ratio.add(timeB / timeA);
        }
        same = same && a.places() == b.places();
        if (verbose && repetition + 1 == repetitions) {
            for (ComponentStatus const& status : b.world().status()) {
                if (status.updates > 0) {
                    std::printf("    %-32s %9.2f us mean, %llu updates\n", status.info->text.name.data(),
                                status.totalMicroseconds / static_cast<double>(status.updates),
                                static_cast<unsigned long long>(status.updates));
                }
            }
        }
    }
    bench::Table table(scene.name + ": " + std::to_string(scene.items.size() - 1) + " boxes, " +
                       std::to_string(repetitions) + " x " + std::to_string(scene.blocks) + " blocks of " +
                       std::to_string(blockFrames) + " frames");
    double const overhead = 100 * (ratio.median() - 1);
    table.row("bare Box2D, per frame", 1e6 * bare.median(), "us");
    table.row("through Trembler, per frame", 1e6 * ours.median(), "us");
    if (limit) {
        table.row("overhead", overhead, "%", overhead, *limit);
    } else {
        table.row("overhead", overhead, "%");
    }
    table.print();
    std::printf("  motion is %s\n\n",
                same ? "the same, bit for bit" : "NOT THE SAME: the comparison is void");
    return same && overhead <= limit.value_or(overhead);
}

} // namespace

// bench_box2d_overhead [repetitions] [--verbose]; exit status 1 if a limit is exceeded.
int main(int argc, char** argv) {
    int repetitions = 5;
    bool verbose = false;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--verbose") == 0) {
            verbose = true;
        } else if (int const asked = std::atoi(argv[i]); asked > 0) {
            repetitions = asked;
        }
    }
    Registry registry;
    registerEverything(registry);
    Registry withReader;
    registerEverything(withReader);
    withReader.component<ReadsTouches>();
    bool held = true;
    for (SceneOf scene : {bench::largePyramid(), bench::tumbler()}) {
        held = run(registry, scene, repetitions, verbose, 5) && held;
        scene.name += ", with a component that reads touches";
        held = run(withReader, scene, repetitions, verbose, std::nullopt) && held;
    }
    return held ? 0 : 1;
}

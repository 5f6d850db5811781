// The cost and accuracy of each rigid-body engine in the same scenes through the same interface. Wall time
// per frame of 1/60 s with the world's four substeps and sleeping off, one thread, medians over frames;
// alternating, so that other load affects all engines equally.
#include "bench/measure.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace {

using namespace trembler;

struct Scene {
    Scene(Registry const& registry, std::string const& engine)
        : world(registry, WorldOptions{.threads = 1, .detail = {{"dynamics", engine}}, .periods = {}}) {
        ObjectId const self = world.store().create("world");
        give(self, GravityField{{0, -9.81}});
        DynamicsSettings settings;
        settings.sleeping = false;
        give(self, settings);
    }
    template <class P>
    void give(ObjectId id, P property) {
        world.store().column<P>().set(id, std::move(property));
    }
    ObjectId body(ShapePiece piece, Vec2 at, bool fixed = false) {
        ObjectId const id = world.store().create(fmt::format("body {}", count++));
        give(id, Shape{{std::move(piece)}});
        give(id, Position{at});
        if (fixed) {
            give(id, Fixed{});
        }
        return id;
    }
    void hinge(ObjectId a, ObjectId b, Vec2 at) {
        Joint joint;
        joint.a = a;
        joint.b = b;
        joint.at = at;
        give(world.store().create(fmt::format("hinge {}", count++)), joint);
        hinges.push_back({a, b, at - place(a), b.valid() ? at - place(b) : at});
    }
    [[nodiscard]] Vec2 place(ObjectId id) const {
        return world.store().findColumn<Position>()->find(id)->value;
    }
    [[nodiscard]] double worstGap() const {
        double worst = 0;
        auto const end = [&](ObjectId id, Vec2 local) {
            return id.valid()
                       ? world.find<Position>(id)->value + rotated(local, world.find<Rotation>(id)->angle)
                       : local;
        };
        for (Hinge const& h : hinges) {
            worst = std::max(worst, length(end(h.a, h.onA) - end(h.b, h.onB)));
        }
        return worst;
    }

    struct Hinge {
        ObjectId a;
        ObjectId b;
        Vec2 onA;
        Vec2 onB;
    };
    World world;
    std::vector<Hinge> hinges;
    int count = 0;
};

void pyramid(Scene& scene, int base) {
    scene.body(boxPiece(40, 1), {0, -0.5}, true);
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            scene.body(boxPiece(0.5, 0.5), {(i - 0.5 * (base - row - 1)) * 0.55, 0.26 + 0.51 * row});
        }
    }
}

void chain(Scene& scene, int links, double heavy) {
    ObjectId before;
    for (int i = 0; i < links; ++i) {
        ObjectId const link = scene.body(boxPiece(0.2, 0.05), {0.2 * i + 0.1, 0});
        scene.hinge(link, before, {0.2 * i, 0});
        before = link;
    }
    ObjectId const ball = scene.body(circlePiece(0.2), {0.2 * links + 0.2, 0});
    scene.give(ball, Mass{heavy});
    scene.hinge(ball, before, {0.2 * links, 0});
}

void heap(Scene& scene, int balls) {
    scene.body(boxPiece(8, 0.4), {0, -0.2}, true);
    scene.body(boxPiece(0.4, 10), {-2.2, 5}, true);
    scene.body(boxPiece(0.4, 10), {2.2, 5}, true);
    for (int i = 0; i < balls; ++i) {
        scene.body(i % 2 == 0 ? circlePiece(0.1) : boxPiece(0.18, 0.18),
                   {-1.8 + 0.25 * (i % 15), 0.3 + 0.25 * (i / 15)});
    }
}

struct Case {
    char const* name;
    void (*fill)(Scene&);
    int frames;
};

} // namespace

int main() {
    Registry registry;
    registerEffects(registry);
    std::vector<std::string> engines;
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        if (text.effect == "dynamics" && !text.level.empty() && registration.missing.empty()) {
            engines.emplace_back(text.level);
        }
    }
    constexpr Case cases[] = {
        {"pyramid of 55 boxes", [](Scene& s) { pyramid(s, 10); }, 300},
        {"chain of 30 links, a ball of ten links' mass swings", [](Scene& s) { chain(s, 30, 10); }, 600},
        {"heap of 200 balls and boxes", [](Scene& s) { heap(s, 200); }, 300},
    };
    for (Case const& one : cases) {
        fmt::print("{}\n", one.name);
        std::vector<std::unique_ptr<Scene>> scenes;
        std::vector<bench::Series> times(engines.size());
        std::vector<double> gaps(engines.size(), 0);
        for (std::string const& engine : engines) {
            scenes.push_back(std::make_unique<Scene>(registry, engine));
            one.fill(*scenes.back());
            scenes.back()->world.start();
        }
        for (int frame = 0; frame < one.frames; ++frame) {
            for (std::size_t i = 0; i < scenes.size(); ++i) {
                times[i].time([&] { scenes[i]->world.step(); });
                gaps[i] = std::max(gaps[i], scenes[i]->worstGap());
            }
        }
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            fmt::print("  {:<10} {:8.0f} us per frame", engines[i], 1e6 * times[i].median());
            if (!scenes[i]->hinges.empty()) {
                fmt::print(", joints open up to {:.1f} mm", 1e3 * gaps[i]);
            }
            fmt::print("\n");
        }
    }
    return 0;
}

#include "game/ui/play/view/spark_view.hpp"

#include "physics/dynamics/properties/contacts.hpp"
#include "render/draw/palette.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/objects/wires.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace trembler::ui {
namespace {

constexpr double sparkLife = 0.35; // s
constexpr std::size_t mostSparks = 24;
constexpr int raysPerSpark = 7;

/// From 0 to 1, the same in every run.
double scattered(unsigned spark, int ray) {
    unsigned mixed = spark * 2654435761U + static_cast<unsigned>(ray) * 40503U;
    mixed ^= mixed >> 15U;
    mixed *= 2246822519U;
    mixed ^= mixed >> 13U;
    return static_cast<double>(mixed & 0xffffU) / 65535.0;
}

} // namespace

void SparkView::afterStep(World const& world) {
    std::set<Pair> present;
    std::set<Pair> carrying;
    for (render::Link const& link : render::linksOf(world)) {
        if (link.counts.of(CallerId::level()) > 0) {
            continue; // a wire
        }
        present.insert({link.a, link.b});
        if (link.live) {
            carrying.insert({link.a, link.b});
        }
    }
    std::erase_if(live_, [&](auto const& contact) {
        if (present.contains(contact.first)) {
            return !carrying.contains(contact.first); // its current was switched off elsewhere
        }
        if (sparks_.size() < mostSparks) {
            sparks_.push_back({contact.second, 0, ++count_});
        }
        return true;
    });
    auto const* const patches = carrying.empty() ? nullptr : world.find<ContactPatches>();
    if (patches == nullptr) {
        return;
    }
    for (ContactPatch const& patch : patches->patches) {
        Pair const pair = std::minmax(patch.a, patch.b);
        if (patch.count > 0 && carrying.contains(pair)) {
            live_[pair] = patch.points[0];
        }
    }
}

void SparkView::pass(double seconds) {
    for (Spark& spark : sparks_) {
        spark.age += seconds;
    }
    std::erase_if(sparks_, [](Spark const& spark) { return spark.age > sparkLife; });
}

void SparkView::reset() {
    live_.clear();
    sparks_.clear();
    count_ = 0;
}

void drawSparks(render::Canvas& canvas, std::vector<SparkView::Spark> const& sparks) {
    using namespace render;
    for (SparkView::Spark const& spark : sparks) {
        double const t = std::clamp(spark.age / sparkLife, 0.0, 1.0);
        auto const alpha = static_cast<float>(1 - t);
        Point const at = toPoint(spark.at);
        for (int ray = 0; ray < raysPerSpark; ++ray) {
            double const angle = 2 * pi * (ray + 0.7 * scattered(spark.look, ray)) / raysPerSpark;
            double const reach = canvas.metres(14 + 22 * scattered(spark.look, ray + raysPerSpark));
            double const fall = canvas.metres(18) * t * t;
            Point const way{std::cos(angle), std::sin(angle)};
            Point const from = at + (0.2 + 0.8 * t) * reach * way - Point{0, fall};
            Point const to = at + (0.2 + 0.8 * std::min(t + 0.3, 1.0)) * reach * way - Point{0, fall};
            canvas.line(from, to,
                        {.colour = palette::liveCore,
                         .pixels = 2.2F,
                         .alpha = alpha,
                         .round = false,
                         .glow = {palette::live, canvas.metres(7), 0.8F * alpha}});
        }
    }
}

} // namespace trembler::ui

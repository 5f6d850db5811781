// Sparks where a contact opens through which current flowed.
#pragma once

#include "render/draw/canvas.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <utility>
#include <vector>

namespace trembler::ui {

/// Follows one world at a time, between frames. Only for the eye: it reads the electricity graph and the
/// contacts (World::want<ContactPatches>()) and changes no state of the world. Needs no window. One thread.
class SparkView {
public:
    struct Spark {
        Vec2 at;           ///< m
        double age = 0;    ///< s
        unsigned look = 0; ///< varies from spark to spark
    };

    /// To be called directly after each World::step.
    void afterStep(World const& world);
    /// Lets `seconds` of the player's time pass.
    void pass(double seconds);
    void reset();
    [[nodiscard]] std::vector<Spark> const& sparks() const { return sparks_; }

private:
    using Pair = std::pair<ObjectId, ObjectId>; // ascending

    std::map<Pair, Vec2> live_; // contacts that carry current, and where they touch
    std::vector<Spark> sparks_;
    unsigned count_ = 0;
};

/// Draws sparks as short rays that fly apart and fade.
void drawSparks(render::Canvas& canvas, std::vector<SparkView::Spark> const& sparks);

} // namespace trembler::ui

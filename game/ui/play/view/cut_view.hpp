// Wires that have just been cut: their halves fall and fade.
#pragma once

#include "render/draw/canvas.hpp"

#include <vector>

namespace trembler::ui {

/// Drawing only. Window thread only.
class CutView {
public:
    /// How long it takes, s.
    static constexpr double life = 0.9;

    /// A wire with this path, m, was cut in its middle.
    void add(std::vector<render::Point> path);
    /// Lets `seconds` pass.
    void pass(double seconds);
    void reset() { cuts_.clear(); }
    [[nodiscard]] bool moving() const { return !cuts_.empty(); }
    void draw(render::Canvas& canvas) const;

private:
    struct Cut {
        std::vector<render::Point> path;
        double age = 0; // s
    };
    std::vector<Cut> cuts_;
};

} // namespace trembler::ui

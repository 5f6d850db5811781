// Where a piece of a composite part lies, and whether it is mirrored.
#pragma once

#include "runtime/math/vec2.hpp"

namespace trembler {

/// A frame inside an outer one: an object in it is first mirrored about the object's own y axis, if the frame
/// is flipped, then turned, then shifted. A frame without any of these changes no bit.
struct PieceFrame {
    Vec2 at;          ///< m
    double angle = 0; ///< rad
    bool flipped = false;

    friend bool operator==(PieceFrame const&, PieceFrame const&) = default;

    /// -v, but 0 for 0: with the sign of -0 mirror images would differ in bits.
    [[nodiscard]] static double negative(double v) { return 0.0 - v; }
    [[nodiscard]] static Vec2 mirrored(Vec2 v) { return {negative(v.x), v.y}; }

    [[nodiscard]] Vec2 direction(Vec2 own) const {
        Vec2 const v = flipped ? mirrored(own) : own;
        return angle == 0 ? v : rotated(v, angle);
    }
    [[nodiscard]] Vec2 point(Vec2 own) const { return at == Vec2{} ? direction(own) : at + direction(own); }
    [[nodiscard]] double heading(double own) const { return angle + (flipped ? negative(own) : own); }
    /// The frame, in the outer frame of this one, of a frame that is stated inside this one.
    [[nodiscard]] PieceFrame of(PieceFrame const& inner) const {
        return {point(inner.at), heading(inner.angle), flipped != inner.flipped};
    }
};

} // namespace trembler

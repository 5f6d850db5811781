#include "puzzle/edit/tree/shape_change.hpp"

#include "physics/dynamics/properties/shape_rules.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::edit {
namespace {

constexpr double equalLength = 1e-9; // m, and rad
/// A placement property of other kinds of objects than these: whether an object is drawn and built mirrored.
constexpr std::string_view mirroredKey = "mirrored";

double roundedLength(double metres) {
    return std::round(metres * 1e9) / 1e9;
}

/// How many quarter turns an angle is; nothing if it is none.
std::optional<int> quarterTurns(double radiansValue) {
    double const quarters = radiansValue / (pi / 2);
    double const whole = std::round(quarters);
    if (std::abs(quarters - whole) > 1e-6) {
        return std::nullopt;
    }
    return static_cast<int>(std::fmod(std::fmod(whole, 4) + 4, 4));
}

[[noreturn]] void refuseScale(std::string_view what) {
    throw CommandError(fmt::format("{} cannot be stretched in one direction only", what));
}

void scalePiece(ShapePiece& piece, Vec2 factors) {
    bool const evenly = factors.x == factors.y;
    piece.at = {roundedLength(piece.at.x * factors.x), roundedLength(piece.at.y * factors.y)};
    switch (piece.form) {
    case ShapeForm::circle:
        if (!evenly) {
            refuseScale("a disc");
        }
        piece.radius = roundedLength(piece.radius * factors.x);
        break;
    case ShapeForm::capsule:
        if (!evenly) {
            refuseScale("a capsule");
        }
        piece.radius = roundedLength(piece.radius * factors.x);
        piece.width = roundedLength(piece.width * factors.x);
        break;
    case ShapeForm::box: {
        auto const turns = quarterTurns(piece.angle);
        if (!evenly && !turns) {
            refuseScale("a turned box");
        }
        bool const lies = turns.value_or(0) % 2 == 1;
        piece.width = roundedLength(piece.width * (lies ? factors.y : factors.x));
        piece.height = roundedLength(piece.height * (lies ? factors.x : factors.y));
        break;
    }
    case ShapeForm::polygon:
        for (Vec2& corner : piece.corners) {
            Vec2 const turned = evenly ? corner : rotated(corner, piece.angle);
            corner = {roundedLength(turned.x * factors.x), roundedLength(turned.y * factors.y)};
        }
        piece.angle = evenly ? piece.angle : 0;
        break;
    }
}

Vec2 mirroredPoint(Vec2 point, bool atVertical) {
    // Adding 0 makes 0 of -0, which files should not contain.
    return atVertical ? Vec2{-point.x + 0.0, point.y} : Vec2{point.x, -point.y + 0.0};
}

ShapePiece mirroredPiece(ShapePiece piece, bool atVertical) {
    piece.at = mirroredPoint(piece.at, atVertical);
    piece.angle = -piece.angle + 0.0;
    for (Vec2& corner : piece.corners) {
        corner = mirroredPoint(corner, atVertical);
    }
    std::reverse(piece.corners.begin(), piece.corners.end());
    return piece;
}

bool near(Vec2 a, Vec2 b) {
    return std::abs(a.x - b.x) < equalLength && std::abs(a.y - b.y) < equalLength;
}

/// Whether two pieces cover the same area, as far as one can see from their numbers.
bool samePiece(ShapePiece const& a, ShapePiece const& b) {
    if (a.form != b.form || !near(a.at, b.at) || std::abs(a.radius - b.radius) > equalLength ||
        std::abs(a.width - b.width) > equalLength || std::abs(a.height - b.height) > equalLength ||
        a.corners.size() != b.corners.size()) {
        return false;
    }
    if (a.form == ShapeForm::circle) {
        return true;
    }
    if (a.form != ShapeForm::polygon) { // half a turn changes nothing
        return std::abs(std::remainder(a.angle - b.angle, pi)) < equalLength;
    }
    return std::all_of(a.corners.begin(), a.corners.end(), [&](Vec2 corner) {
        return std::any_of(b.corners.begin(), b.corners.end(), [&](Vec2 other) {
            return near(rotated(corner, a.angle), rotated(other, b.angle));
        });
    });
}

bool sameArea(Shape const& a, Shape const& b) {
    return a.pieces.size() == b.pieces.size() &&
           std::all_of(a.pieces.begin(), a.pieces.end(), [&](ShapePiece const& piece) {
               return std::any_of(b.pieces.begin(), b.pieces.end(),
                                  [&](ShapePiece const& other) { return samePiece(piece, other); });
           });
}

void stateShape(Json& entry, Shape shape) {
    if (auto const fault = faultIn(shape)) {
        throw CommandError(fmt::format("{}: {}", textOf(entry, "name"), *fault));
    }
    setStatement(entry, propertyInfo<Shape>(), writeProperty(ValueOf<Shape>(std::move(shape))));
}

/// Changes members of a property, of the object's own or its part's.
template <class Change>
void changeMembers(GameData const& data, Json& entry, char const* property, Change const& change) {
    PropertyInfo const* const info = data.registry.objectProperty(property);
    if (info == nullptr) {
        return;
    }
    Json value = effectiveStatement(data, entry, *info);
    if (value.is_null()) {
        return;
    }
    Json const before = value;
    change(value);
    if (value != before) {
        setStatement(entry, *info, std::move(value));
    }
}

template <class Change>
void changePoint(Json& object, char const* key, Change const& change) {
    if (!object.is_object()) {
        return;
    }
    if (auto const found = object.find(key); found != object.end()) {
        if (auto const point = pointOf(*found)) {
            *found = pointJson(change(*point));
        }
    }
}

} // namespace

void scaleEntry(GameData const& data, Json& entry, Vec2 factors) {
    Vec2 local = factors;
    if (factors.x != factors.y) {
        auto const turns = quarterTurns(radians(angleOf(entry)));
        if (!turns) {
            refuseScale("a turned object");
        }
        if (*turns % 2 == 1) {
            std::swap(local.x, local.y);
        }
    }
    if (auto shape = shapeOf(data, entry)) {
        for (ShapePiece& piece : shape->pieces) {
            scalePiece(piece, local);
        }
        stateShape(entry, std::move(*shape));
    }
    changeMembers(data, entry, "magnetic_poles", [&](Json& poles) {
        for (char const* const pole : {"north", "south"}) {
            changePoint(poles, pole, [&](Vec2 at) { return Vec2{at.x * local.x, at.y * local.y}; });
        }
    });
}

void mirrorEntry(GameData const& data, Json& entry, bool atVertical) {
    PropertyInfo const* const mirrored = data.registry.objectProperty(mirroredKey);
    if (mirrored != nullptr && mirrored->text.place == PropertyPlace::placement) {
        // The world mirrors the object along its own x axis, before it is turned.
        Json const now = effectiveStatement(data, entry, *mirrored);
        setStatement(entry, *mirrored, now == true ? Json() : Json(true));
        setAngle(entry, std::remainder((atVertical ? 0 : 180) - angleOf(entry), 360));
        return;
    }
    if (auto const shape = shapeOf(data, entry)) {
        Shape made;
        for (ShapePiece const& piece : shape->pieces) {
            made.pieces.push_back(mirroredPiece(piece, atVertical));
        }
        if (!sameArea(made, *shape)) {
            stateShape(entry, std::move(made));
        }
    }
    setAngle(entry, -angleOf(entry));
    auto const flip = [&](Vec2 point) { return mirroredPoint(point, atVertical); };
    changeMembers(data, entry, "magnetic_poles", [&](Json& poles) {
        changePoint(poles, "north", flip);
        changePoint(poles, "south", flip);
    });
    changeMembers(data, entry, "liquid", [&](Json& liquid) { changePoint(liquid, "current", flip); });
    changeMembers(data, entry, "velocity", [&](Json& velocity) {
        if (auto const value = pointOf(velocity)) {
            velocity = pointJson(flip(*value));
        }
    });
    changeMembers(data, entry, "angular_velocity_deg", [](Json& speed) {
        if (speed.is_number()) {
            speed = numberJson(-numberOf(speed));
        }
    });
    changeMembers(data, entry, "electric_motor", [](Json& motor) {
        if (motor.is_object() && motor.contains("torque") && motor["torque"].is_number()) {
            motor["torque"] = numberJson(-numberOf(motor["torque"]));
        }
    });
}

} // namespace trembler::edit

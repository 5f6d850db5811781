#include "puzzle/edit/tree/shape_change.hpp"

#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "puzzle/edit/tree/entry_pieces.hpp"
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

/// Whether flipping an object, which is no composite, would change nothing.
bool isSymmetric(GameData const& data, Json entry) {
    entry.erase("flipped");
    std::vector<PropertySet> const plain = piecesOf(data, entry);
    entry["flipped"] = true;
    std::vector<PropertySet> const flipped = piecesOf(data, entry);
    if (plain.size() != 1 || flipped.size() != 1) {
        return false;
    }
    auto const& entries = plain.front().entries();
    return std::all_of(entries.begin(), entries.end(), [&](PropertySet::Entry const& one) {
        PropertyValue const* const other = flipped.front().find(*one.info);
        if (!one.value || other == nullptr) {
            return !one.value && other == nullptr;
        }
        if (one.info == &propertyInfo<Shape>()) {
            return sameArea(static_cast<ValueOf<Shape> const&>(*one.value).value,
                            static_cast<ValueOf<Shape> const&>(*other).value);
        }
        return writeProperty(*one.value) == writeProperty(*other);
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
    if (isComposite(data, entry)) {
        throw CommandError("a part made of several pieces has one size");
    }
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
    if (!isSymmetric(data, entry)) {
        if (entry.contains("flipped") && entry["flipped"] == true) {
            entry.erase("flipped");
        } else {
            setObjectMember(entry, "flipped", true);
        }
    }
    // A flipped object is mirrored left to right before it is turned. Not brought into a range, so that
    // mirroring twice gives the same number.
    setAngle(entry, (atVertical ? 0 : 180) - angleOf(entry));
    if (atVertical) {
        return;
    }
    // Directions in the world do not turn with the object.
    auto const back = [](Vec2 way) { return Vec2{-way.x + 0.0, -way.y + 0.0}; };
    changeMembers(data, entry, "liquid", [&](Json& liquid) { changePoint(liquid, "current", back); });
    changeMembers(data, entry, "velocity", [&](Json& velocity) {
        if (auto const value = pointOf(velocity)) {
            velocity = pointJson(back(*value));
        }
    });
}

} // namespace trembler::edit

// How a property describes itself, once: the inspector, the level file, the state hash, scripts and the
// notation all use the same description.
#pragma once

#include "runtime/level/json/limits.hpp"
#include "runtime/math/vec2.hpp"
#include "runtime/object/object_id.hpp"

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace trembler {

/// Where a property belongs, which decides which components may read and change it.
enum class PropertyKind {
    object,   ///< plain data of one object, one column each; changed by resolvers
    resolver, ///< data of one resolver as a whole (5.4), for example which objects touch; changed by that
              ///< resolver
    derived,  ///< computed by one derived property set (5.5) from object and resolver properties
};

/// Where a level file states an object property.
enum class PropertyPlace {
    properties, ///< under an object's or a part's "properties"
    placement,  ///< directly in the object's entry, like "at": differs for each placed object
    world,      ///< under the level's "world": a property of the one object named "world"
    hidden,     ///< nowhere: state that exists only while the world runs
};

/// The words of a property. `name` is the thesis's notation, `key` the key in files and scripts.
struct PropertyText {
    std::string_view name;
    std::string_view key;
    std::string_view meaning;
    PropertyPlace place = PropertyPlace::properties;
    /// The key of another property to which this one belongs, as a drawing belongs to a shape: an object that
    /// states the other property itself, but not this one, does not inherit this one from its part.
    std::string_view madeFor{};
};

/// The values of a number that a recorded solution, the components panel and a time budget may set: with all
/// of them the same physics is computed, more or less exactly. Empty unless stated.
struct AccuracyRange {
    double from = 1;
    double to = 0;
    bool orAutomatic = false; ///< 0 is allowed as well: the program then chooses the number

    [[nodiscard]] constexpr bool any() const { return from <= to; }
    [[nodiscard]] constexpr bool contains(double value) const {
        return any() && ((value >= from && value <= to) || (orAutomatic && value == 0));
    }
};

/// The geometric meaning of a field. With it an object can be moved, turned and mirrored by the descriptions
/// of its properties alone (runtime/level/property/move_property.hpp). Mirroring exchanges left and right in
/// the object's own frame.
enum class FieldGeometry : std::uint8_t {
    unstated,  ///< no geometric meaning; not allowed for vectors, angles and angular speeds
    invariant, ///< a direction or a sense that is the same at every place and in mirror images
    ownVector, ///< a point or a direction in the object's frame
    /// A list of points in the object's frame that runs anticlockwise, so that a mirror image reverses it.
    ownOutline,
    /// An angle, an angular speed or a torque, positive anticlockwise, in the object's frame or between two
    /// objects; also a displacement along a worldAxis: a mirror image has the other sign.
    turning,
    turningLower, ///< the lower limit of a `turning`: a mirror image has the upper one with the other sign
    turningUpper,
    worldPoint,  ///< a point in the world, or in the frame of the part that the object is a piece of
    worldVector, ///< a direction in the same frame
    /// A direction, in the same frame, along which a displacement is measured. A mirror image of it is
    /// reversed, so that the displacement changes its sign, as angles do: a gear then joins both as before.
    worldAxis,
    heading, ///< the angle of the object itself, in the same frame
};

/// One field of a property. A field with key "value" is written bare in files: "mass": 2.
struct FieldInfo {
    std::string_view key;
    std::string_view unit; ///< SI, "" for a pure number, "rad" for angles in code
    std::string_view meaning;
    double minimum = -std::numeric_limits<double>::max();
    double maximum = std::numeric_limits<double>::max();
    bool minimumExcluded = false; ///< for example a mass, which must be above zero
    bool required = false;    ///< files must state it; otherwise the member's initial value is the default
    AccuracyRange accuracy{}; ///< stated only for accuracy settings; everything else is physics
    bool adds = false;        ///< of an entry in a list: the values of several entries of one object add up
    FieldGeometry geometry = FieldGeometry::unstated;
    /// Of a list: how many entries it must have, if a file states it. Only for the schema: a rule checks it,
    /// as an author adds entries one by one.
    std::size_t least = 0;
    std::size_t most = limits::listInProperty; ///< of a list; files with more are refused
};

/// The names of an enumeration's values 0, 1, 2 ... as files spell them. Specialise for each
/// enumeration, as an array.
template <class E>
inline constexpr std::span<std::string_view const> choiceNames = {};

/// A property type: a plain struct with `kind` and `text`. One with fields has `describe(self, visitor)`,
/// which calls visitor(FieldInfo, self.field) for every field in a fixed order; a marker, or data that only
/// components read, has none (see MayLackFields).
template <class P>
concept Property = requires {
    { P::kind } -> std::convertible_to<PropertyKind>;
    { P::text } -> std::convertible_to<PropertyText>;
};
template <class P>
concept ObjectProperty = Property<P> &&(P::kind == PropertyKind::object);
template <class P>
concept ResolverProperty = Property<P> &&(P::kind == PropertyKind::resolver);
template <class P>
concept DerivedProperty = Property<P> &&(P::kind == PropertyKind::derived);

/// A type that describes its fields: a property, or a struct inside one, for example one corner of a shape.
template <class T>
concept Described = requires(T& t) {
    T::describe(t, [](FieldInfo const&, auto&) {});
};

/// A property that may lack describe(). Object properties that a level file can state must have it, except
/// markers, which have no members.
template <class P>
concept MayLackFields = Property<P> &&
    (P::kind != PropertyKind::object || std::is_empty_v<P> || P::text.place == PropertyPlace::hidden);

} // namespace trembler

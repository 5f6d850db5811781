#include "puzzle/edit/world/displacement.hpp"

#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <utility>

namespace trembler::edit {
namespace {

using Keys = std::span<std::string_view const>;

constexpr std::array<std::string_view, 2> placeKeys{"at", "angle_deg"};
constexpr std::array<std::string_view, 2> sizeKeys{"shape", "magnetic_poles"};
constexpr std::array<std::string_view, 5> jointKeys{"at", "at_b", "ground_a", "ground_b", "axis"};
constexpr std::array<std::string_view, 5> handledKeys{"objects", "joints", "placing", "goals", "task"};

bool isOneOf(std::string_view key, Keys keys) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Whether two objects are equal but for the members with these keys.
bool equalBut(Json const& a, Json const& b, Keys keys) {
    if (!a.is_object() || !b.is_object()) {
        return a == b;
    }
    auto const counts = [&](Json const& object) {
        auto const& members = object.get_ref<Json::object_t const&>();
        return std::count_if(members.begin(), members.end(),
                             [&](auto const& member) { return !isOneOf(member.first, keys); });
    };
    if (counts(a) != counts(b)) {
        return false;
    }
    auto const& members = a.get_ref<Json::object_t const&>();
    return std::all_of(members.begin(), members.end(), [&](auto const& member) {
        auto const other = b.find(member.first);
        return isOneOf(member.first, keys) || (other != b.end() && *other == member.second);
    });
}

Json const& memberOf(Json const& object, char const* key) {
    static Json const none;
    auto const found = object.is_object() ? object.find(key) : object.end();
    return found == object.end() ? none : *found;
}

/// The index of an entry in its list: the last token of its path.
std::optional<std::size_t> indexOf(std::string_view path) {
    std::size_t const slash = path.rfind('/');
    std::size_t index = 0;
    if (slash == std::string_view::npos) {
        return {};
    }
    auto const [end, error] = std::from_chars(path.data() + slash + 1, path.data() + path.size(), index);
    return error == std::errc() && end == path.data() + path.size() ? std::optional(index) : std::nullopt;
}

/// A turn about a point and a shift.
struct Rigid {
    Vec2 from;
    Vec2 to;
    double turn = 0; ///< rad

    [[nodiscard]] Vec2 point(Vec2 at) const {
        return turn == 0 ? at + (to - from) : to + rotated(at - from, turn);
    }
    [[nodiscard]] Vec2 direction(Vec2 way) const { return turn == 0 ? way : rotated(way, turn); }
};

template <class P>
std::optional<P> valueIn(World const& world, ObjectId id) {
    P const* const value = world.find<P>(id);
    return value == nullptr ? std::nullopt : std::optional(*value);
}

/// A property that is stated as a part of an entry; nothing if it cannot be read.
template <class P>
std::optional<P> statedIn(GameData const& data, Json const& entry) {
    Json const json = effectiveStatement(data, entry, propertyInfo<P>());
    NameTable names;
    auto const value = json.is_null() ? nullptr : readValue(propertyInfo<P>(), json, names);
    return value ? std::optional(static_cast<ValueOf<P> const&>(*value).value) : std::nullopt;
}

} // namespace

Displacement::Displacement(GameData const& data, Json tree, LevelFile const& level, World const& world)
    : data_(data), tree_(std::move(tree)) {
    auto const sizeOf = [&](char const* key) {
        Json const* const list = findList(tree_, key);
        return list == nullptr ? std::size_t{0} : list->size();
    };
    objects_.resize(sizeOf("objects"));
    joints_.resize(sizeOf("joints"));
    ObjectTable const& all = world.store().objects();
    for (std::uint32_t number = 0; number < all.indexBound(); ++number) {
        ObjectId const id = all.at(number);
        Origin const origin = world.store().originOf(id);
        bool const joint = origin.kind == Origin::Kind::joint;
        if (!joint && origin.kind != Origin::Kind::object) {
            continue;
        }
        auto& entries = joint ? joints_ : objects_;
        auto const index =
            indexOf(joint ? level.joints[origin.number].path : level.objects[origin.number].path);
        if (index && *index < entries.size()) {
            entries[*index].pieces.push_back({id, valueIn<Position>(world, id), valueIn<Rotation>(world, id),
                                              valueIn<Shape>(world, id), valueIn<MagneticPoles>(world, id),
                                              valueIn<Joint>(world, id)});
        }
    }
}

bool Displacement::differsElsewhere(Json const& tree) const {
    auto const size = [](Json const& list) { return list.is_array() ? list.size() : 0; };
    return !equalBut(tree_, tree, handledKeys) || size(memberOf(tree, "objects")) != objects_.size() ||
           size(memberOf(tree, "joints")) != joints_.size();
}

bool Displacement::follow(Json const& tree, World& world) {
    if (differsElsewhere(tree)) {
        return false;
    }
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        Json const& before = tree_["objects"][i];
        Json const& now = tree["objects"][i];
        bool const differs = before != now;
        if ((differs || objects_[i].displaced) && !moveObject(before, now, objects_[i], world)) {
            return false;
        }
        objects_[i].displaced = differs;
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        Json const& before = tree_["joints"][i];
        Json const& now = tree["joints"][i];
        bool const differs = before != now;
        if (!differs && !joints_[i].displaced) {
            continue;
        }
        if (!equalBut(before, now, jointKeys)) {
            return false;
        }
        joints_[i].displaced = differs;
        for (Piece const& piece : joints_[i].pieces) {
            if (!piece.joint) {
                continue;
            }
            Joint joint = *piece.joint;
            auto const take = [&](char const* key, Vec2& value) {
                if (memberOf(before, key) != memberOf(now, key)) {
                    value = pointOf(memberOf(now, key)).value_or(value);
                }
            };
            take("at", joint.at);
            take("at_b", joint.atB);
            take("ground_a", joint.groundA);
            take("ground_b", joint.groundB);
            take("axis", joint.axis);
            world.store().column<Joint>().set(piece.id, joint);
        }
    }
    return true;
}

bool Displacement::moveObject(Json const& before, Json const& now, Entry const& entry, World& world) const {
    bool const resizes = memberOf(before, "properties") != memberOf(now, "properties");
    constexpr std::array<std::string_view, 3> moving{placeKeys[0], placeKeys[1], "properties"};
    if (!equalBut(before, now, moving) ||
        (resizes && !equalBut(memberOf(before, "properties"), memberOf(now, "properties"), sizeKeys))) {
        return false;
    }
    Store& store = world.store();
    Rigid const motion{placeOf(before), placeOf(now), radians(angleOf(now) - angleOf(before))};
    for (Piece const& piece : entry.pieces) {
        if (piece.position) {
            store.column<Position>().set(piece.id, {motion.point(piece.position->value)});
        }
        if (piece.rotation) {
            store.column<Rotation>().set(piece.id, {piece.rotation->angle + motion.turn});
        }
        if (piece.joint) { // of a composite part
            Joint joint = *piece.joint;
            for (Vec2* const point : {&joint.at, &joint.atB, &joint.groundA, &joint.groundB}) {
                *point = motion.point(*point);
            }
            joint.axis = motion.direction(joint.axis);
            store.column<Joint>().set(piece.id, joint);
        }
        if (piece.shape) {
            store.column<Shape>().set(piece.id, *piece.shape);
        }
        if (piece.poles) {
            store.column<MagneticPoles>().set(piece.id, *piece.poles);
        }
    }
    // An object that states its first place or angle has no property for it yet.
    bool const lacksPlace =
        motion.from != motion.to && std::none_of(entry.pieces.begin(), entry.pieces.end(),
                                                 [](Piece const& p) { return p.position.has_value(); });
    bool const lacksAngle =
        motion.turn != 0 && std::none_of(entry.pieces.begin(), entry.pieces.end(),
                                         [](Piece const& p) { return p.rotation.has_value(); });
    return !lacksPlace && !lacksAngle &&
           (!resizes || (entry.pieces.size() == 1 && resize(now, entry.pieces.front(), world)));
}

bool Displacement::resize(Json const& now, Piece const& piece, World& world) const {
    if (piece.shape) {
        auto shape = statedIn<Shape>(data_, now);
        if (!shape || faultIn(*shape)) {
            return false;
        }
        world.store().column<Shape>().set(piece.id, std::move(*shape));
    }
    if (piece.poles) {
        if (auto const poles = statedIn<MagneticPoles>(data_, now)) {
            world.store().column<MagneticPoles>().set(piece.id, *poles);
        }
    }
    return true;
}

} // namespace trembler::edit

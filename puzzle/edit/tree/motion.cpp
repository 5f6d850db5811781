#include "puzzle/edit/tree/motion.hpp"

#include "puzzle/edit/tree/reference_owners.hpp"
#include "puzzle/edit/tree/subset.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <utility>

namespace trembler::edit {
namespace {

bool hasTwoEnds(Json const& joint) {
    std::string const form = textOf(joint, "form");
    return form == "distance" || form == "rope" || form == "spring" || form == "pulley";
}

/// The second ends of such a joint to the world stay where they are: they are hooks in a wall.
void shiftJointOf(Json& joint, Shifts const& shifts, ReferenceOwners const& owners) {
    auto const shiftOf = [&](std::string const& name) {
        auto const found = shifts.find(owners.of(name));
        return found == shifts.end() ? Vec2{} : found->second;
    };
    std::string const b = textOf(joint, "b");
    Vec2 const shiftA = shiftOf(textOf(joint, "a"));
    if (hasTwoEnds(joint)) {
        shiftJoint(joint, shiftA, b.empty() ? Vec2{} : shiftOf(b));
    } else if (b.empty() || shiftOf(b) == shiftA) {
        shiftJoint(joint, shiftA, shiftA);
    }
}

void movePointOf(Json& joint, char const* key, std::function<Vec2(Vec2)> const& motion) {
    if (auto const found = joint.find(key); found != joint.end()) {
        if (auto const point = pointOf(*found)) {
            *found = pointJson(motion(*point));
        }
    }
}

/// A slider or wheel that states no axis has a level one.
void moveAxis(Json& joint, std::function<Vec2(Vec2)> const& motion) {
    std::string const form = textOf(joint, "form");
    if (!joint.contains("axis") && (form == "slider" || form == "wheel")) {
        Vec2 const level{1, 0};
        if (Vec2 const turned = motion(level); turned != level) {
            joint["axis"] = pointJson(turned);
        }
        return;
    }
    movePointOf(joint, "axis", motion);
}

/// The limits and the speed of a hinge or a wheel, seen in a mirror.
void turnRound(Json& joint) {
    auto const take = [&](char const* key) -> std::optional<double> {
        auto const found = joint.find(key);
        return found == joint.end() || !found->is_number() ? std::nullopt : std::optional(numberOf(*found));
    };
    auto const put = [&](char const* key, std::optional<double> value) {
        if (value) {
            joint[key] = numberJson(-*value);
        } else {
            joint.erase(key);
        }
    };
    auto const lower = take("lower_deg");
    auto const upper = take("upper_deg");
    if (lower || upper) {
        put("lower_deg", upper);
        put("upper_deg", lower);
    }
    if (auto const speed = take("motor_speed_deg")) {
        put("motor_speed_deg", speed);
    }
}

/// A gear couples angles and displacements. In a mirror angles change their sign and displacements do not, so
/// one between a hinge and a slider runs the other way.
void turnGearRound(Json& gear, std::map<std::string, std::string> const& forms) {
    auto const slides = [&](char const* key) {
        auto const found = forms.find(textOf(gear, key));
        return found != forms.end() && found->second == "slider";
    };
    if (textOf(gear, "form") == "gear" && slides("joint_a") != slides("joint_b")) {
        gear["ratio"] = numberJson(gear.contains("ratio") ? -numberOf(gear["ratio"]) : -1);
    }
}

std::map<std::string, std::string> formsOfJoints(Json const& level) {
    std::map<std::string, std::string> forms;
    for (Json const& joint : *findList(level, "joints")) {
        forms[textOf(joint, "name")] = textOf(joint, "form");
    }
    return forms;
}

} // namespace

void shiftObjects(GameData const& data, Json& level, Shifts const& shifts) {
    ObjectEntries const entries(level);
    for (auto const& [name, shift] : shifts) {
        Json& entry = entries.of(name);
        setPlace(entry, placeOf(entry) + shift);
    }
    if (findList(level, "joints") != nullptr) {
        ReferenceOwners const owners(data, level);
        for (Json& joint : level["joints"]) {
            shiftJointOf(joint, shifts, owners);
        }
    }
}

void moveJoints(GameData const& data, Json& level, std::set<std::string> const& objects,
                Motion const& motion) {
    if (findList(level, "joints") == nullptr) {
        return;
    }
    std::map<std::string, std::string> const forms = formsOfJoints(level);
    ReferenceOwners const owners(data, level);
    for (Json& joint : level["joints"]) {
        if (!joint.is_object()) {
            continue;
        }
        std::string const b = textOf(joint, "b");
        bool const first = objects.contains(owners.of(textOf(joint, "a")));
        bool const second = b.empty() ? first : objects.contains(owners.of(b));
        if (first && (second || hasTwoEnds(joint))) {
            movePointOf(joint, "at", motion.point);
        }
        // A hook in the wall stays where it is, but is part of a mirror image.
        bool const endsAtWall = hasTwoEnds(joint) && b.empty() && !motion.mirrors;
        if (second && !endsAtWall && (first || hasTwoEnds(joint))) {
            movePointOf(joint, "at_b", motion.point);
        }
        if (first && second) {
            if (!endsAtWall) {
                movePointOf(joint, "ground_a", motion.point);
                movePointOf(joint, "ground_b", motion.point);
            }
            moveAxis(joint, motion.direction);
            if (motion.mirrors) {
                turnRound(joint);
                turnGearRound(joint, forms);
            }
        }
    }
}

} // namespace trembler::edit

#include "insight/run/reduced_level.hpp"

#include "physics/dynamics/properties/joint.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/level/build/joint_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>

namespace trembler::insight {
namespace {

using Indices = std::set<std::size_t>;

template <class T>
void eraseThose(std::vector<T>& list, Indices const& indices, std::string_view what) {
    if (!indices.empty() && *indices.rbegin() >= list.size()) {
        throw std::invalid_argument(fmt::format("there is no {} {}; expected a number below {}", what,
                                                *indices.rbegin(), list.size()));
    }
    for (auto at = indices.rbegin(); at != indices.rend(); ++at) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(*at));
    }
}

/// The joints of the objects, and the gears between those joints.
Indices jointsOf(LevelFile const& level, std::set<std::string> const& objects, Indices joints) {
    std::vector<std::string> const names = jointNames(level);
    std::set<std::string> gone = objects;
    for (std::size_t const joint : joints) {
        if (joint < names.size()) {
            gone.insert(names[joint]);
        }
    }
    for (bool more = true; more;) {
        more = false;
        for (std::size_t i = 0; i < level.joints.size(); ++i) {
            Joint const* const joint = level.joints[i].properties.find<Joint>();
            if (joint == nullptr || joints.contains(i)) {
                continue;
            }
            ObjectId const ends[] = {joint->a, joint->b, joint->jointA, joint->jointB};
            if (std::any_of(std::begin(ends), std::end(ends), [&](ObjectId end) {
                    return end.valid() && gone.contains(level.names.nameOf(end));
                })) {
                joints.insert(i);
                gone.insert(names[i]);
                more = true;
            }
        }
    }
    return joints;
}

} // namespace

ReducedLevel reduced(LevelFile const& level, Variation const& variation) {
    std::map<LeftOut::Kind, Indices> indices;
    std::set<std::string> objects;
    ReducedLevel left{level, variation.solution, {}, {}};
    for (LeftOut const& one : variation.leftOut) {
        switch (one.kind) {
        case LeftOut::Kind::object:
            if (level.findObject(one.a) == nullptr) {
                throw std::invalid_argument(fmt::format("the level has no object '{}'", one.a));
            }
            objects.insert(one.a);
            break;
        case LeftOut::Kind::effect:
            if (!dispensableGameEffects().contains(one.a)) {
                throw std::invalid_argument(fmt::format("there is no effect '{}' to be left out", one.a));
            }
            left.effects.insert(one.a);
            break;
        case LeftOut::Kind::contact:
        case LeftOut::Kind::dip:
            left.touches.push_back(one);
            break;
        default:
            indices[one.kind].insert(one.index);
        }
    }
    std::sort(left.touches.begin(), left.touches.end(),
              [](LeftOut const& x, LeftOut const& y) { return x.from < y.from; });
    eraseThose(left.solution.placements, indices[LeftOut::Kind::placement], "placement");
    eraseThose(left.solution.wires, indices[LeftOut::Kind::wire], "wire");
    eraseThose(left.solution.inputs, indices[LeftOut::Kind::input], "input");
    eraseThose(left.level.connections, indices[LeftOut::Kind::connection], "connection");
    eraseThose(left.level.joints, jointsOf(level, objects, indices[LeftOut::Kind::joint]), "joint");
    std::erase_if(left.level.objects,
                  [&](LevelObject const& object) { return objects.contains(object.name); });
    auto const loose = [&](LevelConnection const& wire) {
        return objects.contains(wire.a) || objects.contains(wire.b);
    };
    std::erase_if(left.level.connections, loose);
    std::erase_if(left.solution.wires, loose);
    for (std::string const& effect : left.effects) {
        left.level.detail.erase(effect);
        std::erase_if(left.solution.changes, [&](RecordedChange const& change) {
            return change.kind == RecordedChange::Kind::detail && change.subject == effect;
        });
    }
    return left;
}

} // namespace trembler::insight

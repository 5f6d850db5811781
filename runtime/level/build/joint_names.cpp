#include "runtime/level/build/joint_names.hpp"

#include "runtime/level/property/property_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace trembler {

std::vector<std::string> jointNames(LevelFile const& level) {
    return jointNames(level.objects, level.joints, level.names);
}

std::vector<std::string> jointNames(std::span<LevelObject const> objects, std::span<LevelJoint const> joints,
                                    NameTable const& references) {
    std::set<std::string> taken;
    for (LevelObject const& object : objects) {
        taken.insert(object.name);
    }
    struct Nameless {
        std::string stated;
        std::size_t index;
    };
    std::vector<Nameless> nameless;
    std::vector<std::string> names;
    for (LevelJoint const& joint : joints) {
        if (joint.name.empty()) {
            auto const stated = writeProperties(joint.properties, PropertyPlace::properties, references);
            nameless.push_back({stated.dump(), names.size()});
        }
        taken.insert(joint.name);
        names.push_back(joint.name);
    }
    // Joints that state the same are equal: it does not matter which of them gets which number.
    std::stable_sort(nameless.begin(), nameless.end(),
                     [](Nameless const& a, Nameless const& b) { return a.stated < b.stated; });
    int number = 0;
    for (Nameless const& joint : nameless) {
        std::string& name = names[joint.index];
        do {
            name = fmt::format("joint {}", ++number);
        } while (taken.contains(name));
    }
    return names;
}

} // namespace trembler

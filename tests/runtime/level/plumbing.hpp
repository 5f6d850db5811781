// A second effect that owns connections, for tests: pipes between vessels.
#pragma once

#include "runtime/level/build/build_world.hpp"
#include "runtime/world/registry.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trembler::plumbing {

/// An object that pipes can connect, and the vessels at the other ends of its pipes.
struct Vessel {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Vessel", "test_vessel", "Holds a liquid, for tests."};
    double litres = 1;
    std::vector<ObjectId> to; ///< in the order in which pipes were laid from here

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "litres"}, self.litres);
    }
};

inline std::optional<std::string> refusePipe(Store const& store, ObjectId a, ObjectId b) {
    auto const* const vessels = store.findColumn<Vessel>();
    for (ObjectId const id : {a, b}) {
        if (vessels == nullptr || !vessels->has(id)) {
            return "'" + store.nameOf(id) + "' holds no liquid; expected two vessels";
        }
    }
    return std::nullopt;
}
inline void layPipe(Store& store, ObjectId a, ObjectId b) {
    store.column<Vessel>()[a].to.push_back(b);
}
inline void fill(Registry& registry) {
    registry.property<Vessel>();
    registry.connector({"pipe", "plumbing", "a pipe between two vessels", refusePipe, layPipe});
}

/// The error in the input that `build` reads; empty if there is none.
[[nodiscard]] inline std::string problemOf(std::function<void()> const& build) {
    try {
        build();
        return "";
    } catch (InputError const& error) {
        return error.what();
    }
}

} // namespace trembler::plumbing

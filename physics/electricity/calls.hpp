// The interaction functions of the Electricity resolver.
#pragma once

#include "runtime/component/call.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace trembler {

/// Why two objects are connected. Connections are counted (5.7.2), and counted for each cause, so that "how are
/// these two connected?" has an answer: the thesis's doubled vertices, without their cost.
enum class ConnectionCause : std::uint8_t {
    wire,    ///< laid by the level, or an invisible wire of the thesis
    contact, ///< the two touch
    other,   ///< anything else: an arc, a script
};
inline constexpr std::size_t connectionCauses = 3;

/// One more reason, or one less, for two objects to be connected.
struct ChangeConnection {
    static constexpr CallText text{"addConnection / removeConnection", "(object, object, cause)",
                                   "Adds to, or takes from, the count of connections between two conductors; they "
                                   "are connected while any count is above zero."};
    static constexpr Algebra algebra = Algebra::countedSet;
    ObjectId a;
    ObjectId b;
    ConnectionCause cause = ConnectionCause::contact;
    bool add = true;
    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {a, b}; }
    [[nodiscard]] auto key() const { return std::pair{a < b ? std::pair{a, b} : std::pair{b, a}, cause}; }
    [[nodiscard]] int delta() const { return add ? 1 : -1; }
};

struct ElectricityRole {
    static constexpr std::string_view name = "Electricity";
    using Calls = CallList<ChangeConnection>;
};

} // namespace trembler

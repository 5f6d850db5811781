// The interaction functions of the Electricity resolver.
#pragma once

#include "runtime/component/call.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace trembler {

/// Why two objects are connected. Connections are counted (5.7.2), and counted for each cause, so that "how
/// are these two connected?" has an answer: the thesis's doubled vertices, without their cost.
enum class ConnectionCause : std::uint8_t {
    wire,    ///< laid by the level, or an invisible wire of the thesis
    contact, ///< the two touch
    other,   ///< anything else: an arc, a script
};
inline constexpr std::size_t connectionCauses = 3;
inline constexpr std::array<std::string_view, connectionCauses> connectionCauseNames{"wire", "contact",
                                                                                     "other"};

/// What the calls that change connections have in common. Their algebra is the counted set: the calls of one
/// frame on one key, (pair of objects, cause), are added up before they take effect, so their order is
/// nothing to them; the pair is connected while the count of any cause is above zero. A removal of what is
/// not there takes nothing away: the count is zero afterwards, not below.
struct ConnectionKey {
    static constexpr Algebra algebra = Algebra::countedSet;
    ObjectId a;
    ObjectId b;
    ConnectionCause cause = ConnectionCause::contact;
    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {a, b}; }
    [[nodiscard]] auto key() const { return std::pair{a < b ? std::pair{a, b} : std::pair{b, a}, cause}; }
};

/// One more reason for two objects to be connected.
struct AddConnection : ConnectionKey {
    static constexpr CallText text{"addConnection", "(object, object, cause)",
                                   "Adds one to the count of connections between two conductors; they are "
                                   "connected while any count is above zero."};
    [[nodiscard]] int delta() const { return 1; }
};

/// One reason less.
struct RemoveConnection : ConnectionKey {
    static constexpr CallText text{
        "removeConnection", "(object, object, cause)",
        "Takes one from the count of connections between two conductors; taking from "
        "zero leaves zero."};
    [[nodiscard]] int delta() const { return -1; }
};

/// A fuse melts.
struct BlowFuse {
    static constexpr CallText text{"blowFuse", "(object)",
                                   "Blows a fuse, for good: it loses its connections and takes no more."};
    static constexpr Algebra algebra = Algebra::destroy;
    ObjectId fuse;
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {fuse}; }
    [[nodiscard]] ObjectId key() const { return fuse; }
};

struct ElectricityRole {
    static constexpr std::string_view name = "Electricity";
    using Calls = CallList<AddConnection, RemoveConnection, BlowFuse>;
};

} // namespace trembler

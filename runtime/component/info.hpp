// The description of a component without its C++ type: printed as notation, used to derive the schedule.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/property/property_info.hpp"

#include <optional>
#include <string>
#include <typeindex>
#include <vector>

namespace trembler {

struct RoleInfo;

enum class ComponentKind : std::uint8_t { resolver, dps, interaction };
[[nodiscard]] std::string_view nameOf(ComponentKind kind);

/// The words of a component and its place among its alternatives.
struct ComponentText {
    std::string_view name;   ///< for example "Linear Gravity"; an interaction's "Dynamics <- Gravity"
    std::string_view effect; ///< for example "gravity", as in --detail
    std::string_view
        level;             ///< for example "linear": one of the effect's detail levels, "" if it has only one
    std::string_view work; ///< its work on advance, update or apply
    int rank = 0;          ///< of alternatives that suit a scene, the one of the least rank is chosen
};

struct CallInfo {
    CallText text;
    Algebra algebra;
};

/// The properties of the two objects of a pair.
struct PairRoles {
    std::vector<PropertyInfo const*> first;
    std::vector<PropertyInfo const*> second;
};

/// One component type, as registered.
struct ComponentInfo {
    std::type_index type;
    ComponentKind kind;
    ComponentText text;
    std::vector<PropertyInfo const*> reads{};
    std::vector<PropertyInfo const*> writes{};
    bool writesEverything =
        false; ///< the Population resolver: objects are created and destroyed with all their properties
    std::vector<PropertyInfo const*> offers{}; ///< resolver properties of a resolver, derived ones of a DPS
    std::optional<std::type_index>
        role{}; ///< of a resolver: its own; of an interaction: that of its resolver
    std::string_view roleName{};
    RoleInfo const* roleInfo = nullptr; ///< of a resolver: its calls and their arguments, see role_info.hpp
    std::vector<CallInfo> calls{};      ///< of a resolver: its interaction functions
    std::vector<PropertyInfo const*> neededAll{};
    std::vector<PropertyInfo const*> neededAny{};
    /// Of an interaction that is applied to pairs of objects. neededAll has the properties of both, as it is
    /// constructed if there are objects with each of them, though none may have them all.
    std::optional<PairRoles> pairs{};
    bool onDemand = false;            ///< constructed only while a property that it offers is read
    std::optional<Coverage> memory{}; ///< how the state hash covers its data members, if any
    bool hashesMemory = false; ///< it hashes its data members, or the members that `memory` leaves open
    bool inSetup = false; ///< an interaction that is applied in frame 0 as well, before the first advance
};

/// The full title as the thesis writes it: "Dynamics Resolver", "Electricity DPS", "(A <- B) Interaction".
[[nodiscard]] std::string title(ComponentInfo const& info);

} // namespace trembler

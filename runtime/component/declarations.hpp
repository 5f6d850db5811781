// The type lists with which a component declares the properties that it reads and changes. A component has
// access to these only, and the schedule and the notation are made from the same types.
#pragma once

#include "runtime/property/property_info.hpp"

#include <tuple>
#include <vector>

namespace trembler {

/// Properties that a component reads.
template <Property... P>
struct Reads {};
/// Object properties that a resolver changes, and may read.
template <ObjectProperty... P>
struct Writes {};
/// Resolver properties that a resolver offers (5.4).
template <ResolverProperty... P>
struct Provides {};
/// Derived properties that a derived property set offers (5.5).
template <DerivedProperty... P>
struct Derives {};

/// A scene needs a component while objects with each of these properties exist ...
template <ObjectProperty... P>
struct NeedsAll {};
/// ... or with at least one of these.
template <ObjectProperty... P>
struct NeedsAny {};

namespace detail {

template <class P, class List>
inline constexpr bool listed = false;
template <class P, template <class...> class List, class... Q>
inline constexpr bool listed<P, List<Q...>> = (std::is_same_v<P, Q> || ...);

// Each argument of a component's base accepts only its own kind of list: Provides<> in the place of Derives<>
// would let a derived property set change the properties of a resolver.
template <class List>
inline constexpr bool isReads = false;
template <class... P>
inline constexpr bool isReads<Reads<P...>> = true;
template <class List>
inline constexpr bool isWrites = false;
template <class... P>
inline constexpr bool isWrites<Writes<P...>> = true;
template <class List>
inline constexpr bool isProvides = false;
template <class... P>
inline constexpr bool isProvides<Provides<P...>> = true;
template <class List>
inline constexpr bool isDerives = false;
template <class... P>
inline constexpr bool isDerives<Derives<P...>> = true;

template <class List>
inline constexpr bool anyDerived = false;
template <class... P>
inline constexpr bool anyDerived<Reads<P...>> = ((P::kind == PropertyKind::derived) || ...);
template <class List>
inline constexpr bool onlyObjectProperties = false;
template <class... P>
inline constexpr bool onlyObjectProperties<Reads<P...>> = ((P::kind == PropertyKind::object) && ...);

template <template <class...> class List, class... P>
[[nodiscard]] std::vector<PropertyInfo const*> infos(List<P...> const&) {
    return {&propertyInfo<P>()...};
}

/// Where a property lives: a column if it belongs to objects, a slot otherwise.
template <Property P>
struct HomeOf {
    using Type = Slot<P>;
};
template <ObjectProperty P>
struct HomeOf<P> {
    using Type = Column<P>;
};
template <Property P>
using Home = typename HomeOf<P>::Type;

} // namespace detail
} // namespace trembler

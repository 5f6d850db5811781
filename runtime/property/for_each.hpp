// Iterates over all objects that have a set of properties.
#pragma once

#include "runtime/property/column.hpp"

#include <array>
#include <tuple>

namespace trembler {

namespace detail {

template <class... C>
[[nodiscard]] bool allSameOwners(ColumnBase const& first, C const&... rest) {
    return (first.sameOwners(rest) && ...);
}

} // namespace detail

/// Calls f(ObjectId, P&...), in ascending order of objects, for every object that is in all columns and whose
/// row in the first column lies in [begin, end). Pass the rarest property first: its rows are walked when the
/// owners differ. When all columns have the same owners this is a plain loop over arrays.
template <class F, class First, class... Rest>
void forEachInRows(std::size_t begin, std::size_t end, F&& f, First& first, Rest&... rest) {
    ObjectId const* const owners = first.owners().data();
    if (detail::allSameOwners(first, rest...)) {
        auto const pointers = std::make_tuple(first.values().data(), rest.values().data()...);
        std::apply(
            [&](auto*... p) {
                for (std::size_t i = begin; i < end; ++i) {
                    f(owners[i], p[i]...);
                }
            },
            pointers);
        return;
    }
    for (std::size_t i = begin; i < end; ++i) {
        ObjectId const id = owners[i];
        std::array<std::uint32_t, sizeof...(Rest)> const rows{rest.row(id)...};
        bool complete = true;
        for (std::uint32_t const r : rows) {
            complete = complete && r != ColumnBase::absent;
        }
        if (complete) {
            [&]<std::size_t... I>(std::index_sequence<I...>) {
                f(id, first.values()[i], rest.values()[rows[I]]...);
            }
            (std::index_sequence_for<Rest...>{});
        }
    }
}

/// The same for all rows of the first column.
template <class F, class First, class... Rest>
void forEach(F&& f, First& first, Rest&... rest) {
    forEachInRows(0, first.size(), std::forward<F>(f), first, rest...);
}

} // namespace trembler

// Where the fields that a type describes lie in its values: for code that reads very many of them, or makes
// values, without knowing the type.
#pragma once

#include "runtime/property/description.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <functional>
#include <string_view>
#include <vector>

namespace trembler {

enum class FieldKind : std::uint8_t {
    boolean, ///< bool
    integer, ///< std::int32_t
    number,  ///< double
    vector,  ///< Vec2
    text,    ///< std::string
    object,  ///< ObjectId
    choice,  ///< an enumeration
    list,    ///< std::vector
    part,    ///< std::uint32_t, of a call only: the number of a part in the PrototypeLibrary
    whole,   ///< std::uint64_t, of a call only: a whole number
};

/// A described field, and its place in a value of the type.
struct FieldPlace {
    FieldInfo info;
    FieldKind kind = FieldKind::number;
    std::size_t offset = nowhere; ///< in bytes; nowhere: it is computed when it is visited
    std::size_t size = 0;         ///< in bytes
    std::span<std::string_view const> choices{};

    static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
};

namespace detail {

template <class T>
constexpr FieldKind fieldKind() {
    if constexpr (std::is_same_v<T, bool>) {
        return FieldKind::boolean;
    } else if constexpr (std::is_same_v<T, std::int32_t>) {
        return FieldKind::integer;
    } else if constexpr (std::is_same_v<T, double>) {
        return FieldKind::number;
    } else if constexpr (std::is_same_v<T, Vec2>) {
        return FieldKind::vector;
    } else if constexpr (std::is_same_v<T, std::string>) {
        return FieldKind::text;
    } else if constexpr (std::is_same_v<T, ObjectId>) {
        return FieldKind::object;
    } else if constexpr (std::is_enum_v<T>) {
        return FieldKind::choice;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return FieldKind::part;
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
        return FieldKind::whole;
    } else {
        return FieldKind::list;
    }
}

// Adds the fields that a value describes and whose keys are not among the places yet.
template <class T>
void addPlaces(T const& value, std::vector<FieldPlace>& places) {
    auto const* const begin = reinterpret_cast<char const*>(&value); // NOLINT(*-reinterpret-cast)
    T::describe(value, [&]<class Field>(FieldInfo const& info, Field const& field) {
        if (std::any_of(places.begin(), places.end(),
                        [&](FieldPlace const& known) { return known.info.key == info.key; })) {
            return;
        }
        FieldPlace place{.info = info, .kind = fieldKind<Field>(), .size = sizeof(Field)};
        auto const* const at = reinterpret_cast<char const*>(&field); // NOLINT(*-reinterpret-cast)
        if (std::less_equal<>()(begin, at) && std::less<>()(at, begin + sizeof(T))) {
            place.offset = static_cast<std::size_t>(at - begin);
        }
        if constexpr (std::is_enum_v<Field>) {
            place.choices = choiceNames<Field>;
        }
        places.push_back(place);
    });
}

} // namespace detail

/// The fields of T at the top, in the order of their description. Some fields may exist only with certain
/// choices in a value: the fields of all choices are listed.
template <Described T>
[[nodiscard]] std::vector<FieldPlace> fieldPlaces() {
    std::vector<FieldPlace> places;
    T const initial{};
    detail::addPlaces(initial, places);
    std::size_t const count = places.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (places[i].kind != FieldKind::choice || places[i].offset == FieldPlace::nowhere) {
            continue;
        }
        for (int choice = 0; choice < static_cast<int>(places[i].choices.size()); ++choice) {
            T value{};
            // Little-endian: the low bytes are those of a smaller underlying type.
            std::memcpy(reinterpret_cast<char*>(&value) + places[i].offset, &choice, // NOLINT
                        std::min(places[i].size, sizeof choice));
            detail::addPlaces(value, places);
        }
    }
    return places;
}

} // namespace trembler

// The hash by which two worlds are compared bit for bit.
#pragma once

#include "runtime/property/description.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>

struct XXH3_state_s;

namespace trembler {

/// Feeds values into XXH3-64. Numbers go in by their bits, so 0.0 and -0.0 differ, as they may behave
/// differently.
class StateHash {
public:
    StateHash();
    void bytes(void const* data, std::size_t size);
    void integer(std::uint64_t value) { bytes(&value, sizeof value); }
    /// Hashes every field that a description names, and nothing else: padding never counts.
    template <class T>
    void value(T const& v) {
        if constexpr (std::is_same_v<T, std::string>) {
            integer(v.size());
            bytes(v.data(), v.size());
        } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Vec2> ||
                             std::is_same_v<T, ObjectId>) {
            bytes(&v, sizeof v);
        } else if constexpr (Described<T> || Property<T>) {
            T::describe(v, [this](FieldInfo const&, auto const& field) { this->value(field); });
        } else {
            integer(v.size());
            for (auto const& element : v) {
                value(element);
            }
        }
    }
    [[nodiscard]] std::uint64_t digest() const;

private:
    struct Free {
        void operator()(XXH3_state_s* state) const;
    };
    std::unique_ptr<XXH3_state_s, Free> state_;
};

/// A type whose bytes are exactly its described fields can be hashed a whole column at a time.
template <class T>
inline constexpr bool hashableAsBytes = false;

} // namespace trembler

// The hash by which two worlds are compared bit for bit.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/property/members.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>

struct XXH3_state_s;

namespace trembler {

struct EventId;

/// Feeds values into XXH3-64. Numbers are hashed by their bits, so 0.0 and -0.0 differ, as they do in
/// computations.
class StateHash {
public:
    StateHash();
    void bytes(void const* data, std::size_t size) {
        if (size > buffer_.size() - used_) {
            flush();
            if (size > buffer_.size()) {
                update(data, size);
                return;
            }
        }
        if (size > 0) {
            std::memcpy(buffer_.data() + used_, data, size);
            used_ += size;
        }
    }
    void integer(std::uint64_t value) { bytes(&value, sizeof value); }
    /// Hashes every field that a description names, and nothing else, so no padding.
    template <class T>
    void value(T const& v) {
        if constexpr (std::is_same_v<T, std::string>) {
            integer(v.size());
            bytes(v.data(), v.size());
        } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Vec2> ||
                             std::is_same_v<T, ObjectId>) {
            bytes(&v, sizeof v);
        } else if constexpr (requires { v.hash(*this); }) {
            v.hash(*this);
        } else if constexpr (Described<T>) {
            T::describe(v, [this](FieldInfo const&, auto const& field) { this->value(field); });
        } else {
            integer(v.size());
            for (auto const& element : v) {
                value(element);
            }
        }
    }
    /// Hashes every member of a plain struct, of the structs in it and of lists of structs, except ids of
    /// trace events, as the hash must not depend on whether a trace is recorded, and except members that
    /// state why they are left out (LeftOutOfHash). The compiler finds the members,
    /// so none can be forgotten. A struct whose members are all in its base class declares `using MembersOf =
    /// Base`.
    template <class T>
    void members(T const& v) {
        static_assert(!std::is_pointer_v<T>, "a pointer may not be hashed: addresses differ between runs");
        if constexpr (std::is_same_v<T, EventId> || LeftOutOfHash<T>) {
            return;
        } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Vec2> ||
                             std::is_same_v<T, ObjectId>) {
            bytes(&v, sizeof v);
        } else if constexpr (std::is_same_v<T, std::string>) {
            value(v);
        } else if constexpr (requires {
                                 v.begin();
                                 v.end();
                             }) {
            static_assert(
                !requires { typename T::hasher; },
                "an unordered container may not be hashed: its order differs between runs");
            integer(static_cast<std::uint64_t>(std::distance(v.begin(), v.end())));
            for (auto const& element : v) {
                members(element);
            }
        } else if constexpr (requires {
                                 v.first;
                                 v.second;
                             } &&
                             !std::is_aggregate_v<T>) {
            members(v.first);
            members(v.second);
        } else if constexpr (requires { typename T::MembersOf; }) {
            static_assert(sizeof(T) == sizeof(typename T::MembersOf),
                          "a type with MembersOf must have no data members besides those of that base");
            members(static_cast<typename T::MembersOf const&>(v));
        } else if constexpr (!std::is_aggregate_v<T>) {
            value(v); // a class: by its own hash(), or by the fields that it describes
        } else {
            forEachMember(v, [this](auto const& member) { this->members(member); });
        }
    }
    [[nodiscard]] std::uint64_t digest();

private:
    void flush();
    void update(void const* data, std::size_t size);

    std::array<char, 1024> buffer_; // gathers small pieces
    std::size_t used_ = 0;
    struct Free {
        void operator()(XXH3_state_s* state) const;
    };
    std::unique_ptr<XXH3_state_s, Free> state_;
};

/// A type whose bytes are exactly its described fields can be hashed a whole column at a time.
template <class T>
inline constexpr bool hashableAsBytes = false;

} // namespace trembler

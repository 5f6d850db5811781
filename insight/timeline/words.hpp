// Values as lists of 64-bit words, the form in which a recording keeps them.
#pragma once

#include "physics/electricity/properties/graph.hpp"
#include "runtime/math/vec2.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/property/members.hpp"
#include "runtime/trace/event.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace trembler::insight {

using Words = std::vector<std::uint64_t>;

/// Appends values. Numbers keep their bits, so that values are read exactly as they were written, bit for
/// bit.
class WordWriter {
public:
    explicit WordWriter(Words& words) : words_(words) {}

    void word(std::uint64_t value) { words_.push_back(value); }
    void number(double value) { word(std::bit_cast<std::uint64_t>(value)); }
    void text(std::string_view text);

    /// Every member of a plain struct, of the structs in it and of its lists.
    template <class T>
    void members(T const& value) {
        if constexpr (std::is_same_v<T, double>) {
            number(value);
        } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
            word(static_cast<std::uint64_t>(value));
        } else if constexpr (std::is_same_v<T, Vec2>) {
            number(value.x);
            number(value.y);
        } else if constexpr (std::is_same_v<T, ObjectId>) {
            word(packed(value));
        } else if constexpr (std::is_same_v<T, EventId>) {
            word(value.value);
        } else if constexpr (std::is_same_v<T, std::string>) {
            text(value);
        } else if constexpr (std::is_same_v<T, CallerCounts>) {
            counts(value);
        } else if constexpr (requires { value.size(); }) {
            word(value.size());
            for (auto const& element : value) {
                members(element);
            }
        } else {
            forEachMember(value, [this](auto const& member) { this->members(member); });
        }
    }

private:
    void counts(CallerCounts const& counts);

    Words& words_;
};

/// The callers of connections by their names: ids of callers are valid only while their world lives.
class CallerNames {
public:
    /// The names of a world's interactions, in their order.
    explicit CallerNames(std::span<std::string const> names);
    /// A caller of that name; no caller for an unknown one.
    [[nodiscard]] CallerId of(std::string const& name) const;

private:
    Callers callers_;
    std::vector<CallerId> known_;
};

/// Reads what WordWriter wrote, in the same order. Throws std::out_of_range at the end of the words: the
/// value was then written as another type, which is a programming error.
class WordReader {
public:
    WordReader(std::span<std::uint64_t const> words, CallerNames const& callers)
        : words_(words), callers_(callers) {}

    std::uint64_t word() {
        if (at_ == words_.size()) {
            throw std::out_of_range("a recorded value is shorter than its type");
        }
        return words_[at_++];
    }
    double number() { return std::bit_cast<double>(word()); }
    std::string text();
    ObjectId object() {
        std::uint64_t const both = word();
        return {static_cast<std::uint32_t>(both), static_cast<std::uint32_t>(both >> 32U)};
    }
    [[nodiscard]] bool done() const { return at_ == words_.size(); }

    template <class T>
    void members(T& value) {
        if constexpr (std::is_same_v<T, double>) {
            value = number();
        } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
            value = static_cast<T>(word());
        } else if constexpr (std::is_same_v<T, Vec2>) {
            value.x = number();
            value.y = number();
        } else if constexpr (std::is_same_v<T, ObjectId>) {
            value = object();
        } else if constexpr (std::is_same_v<T, EventId>) {
            value.value = word();
        } else if constexpr (std::is_same_v<T, std::string>) {
            value = text();
        } else if constexpr (std::is_same_v<T, CallerCounts>) {
            counts(value);
        } else if constexpr (requires { value.resize(1); }) {
            value.resize(count());
            for (auto&& element : value) {
                members(element);
            }
        } else if constexpr (requires { value.size(); }) { // std::array
            if (word() != value.size()) {
                throw std::out_of_range("a recorded array has another length than its type");
            }
            for (auto& element : value) {
                members(element);
            }
        } else {
            forEachMember(value, [this](auto& member) { this->members(member); });
        }
    }

private:
    /// A number of elements, each of at least one word.
    std::size_t count();
    void counts(CallerCounts& counts);

    std::span<std::uint64_t const> words_;
    CallerNames const& callers_;
    std::size_t at_ = 0;
};

} // namespace trembler::insight

// A set of properties from which objects are made: a part definition, once its file has been read.
#pragma once

#include "runtime/property/property_value.hpp"

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace trembler {

struct Prototype {
    std::string name; ///< for example "steel bar"
    std::vector<std::unique_ptr<PropertyValue>> values;
    bool composite = false; ///< its objects have several pieces, so that none can be made while a world runs
};

/// Prototypes by name and by number, so that a call that creates an object can name one in a few bytes.
class PrototypeLibrary {
public:
    /// Adds a prototype and returns its number; one of the same name is replaced and keeps its number.
    std::uint32_t add(Prototype prototype);
    [[nodiscard]] Prototype const* find(std::uint32_t number) const {
        return number < all_.size() ? &all_[number] : nullptr;
    }
    static constexpr std::uint32_t unknown = 0xffffffffU;
    [[nodiscard]] std::uint32_t numberOf(std::string const& name) const;

private:
    std::vector<Prototype> all_;
    std::unordered_map<std::string, std::uint32_t> numbers_; // looked up, never iterated over
};

} // namespace trembler

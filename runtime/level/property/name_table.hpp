// References between the objects of a file by name, before the objects exist.
#pragma once

#include "runtime/object/object_id.hpp"

#include <map>
#include <string>
#include <vector>

namespace trembler {

/// Assigns numbers to names. In the property values of a level file, an ObjectId represents a name: its index
/// is the name's number. An invalid id refers to nothing.
class NameTable {
public:
    [[nodiscard]] ObjectId refer(std::string const& name) {
        auto const [at, isNew] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
        if (isNew) {
            names_.push_back(name);
        }
        return {at->second, 0};
    }
    /// The name that a reference represents; "" for an invalid id.
    [[nodiscard]] std::string nameOf(ObjectId reference) const {
        return reference.index < names_.size() ? names_[reference.index] : std::string();
    }

private:
    std::vector<std::string> names_;
    std::map<std::string, std::uint32_t> numbers_;
};

} // namespace trembler

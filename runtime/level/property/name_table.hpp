// References between the objects of a file: before there are objects, there are only names.
#pragma once

#include "runtime/object/object_id.hpp"

#include <map>
#include <string>
#include <vector>

namespace trembler {

/// Numbers names. In the property values of a level file, an ObjectId stands for a name: its index is the
/// name's number. An invalid id refers to nothing.
class NameTable {
public:
    [[nodiscard]] ObjectId refer(std::string const& name) {
        auto const [at, isNew] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
        if (isNew) {
            names_.push_back(name);
        }
        return {at->second, 0};
    }
    /// The name that a reference stands for; "" for none.
    [[nodiscard]] std::string nameOf(ObjectId reference) const {
        return reference.index < names_.size() ? names_[reference.index] : std::string();
    }

private:
    std::vector<std::string> names_;
    std::map<std::string, std::uint32_t> numbers_;
};

} // namespace trembler

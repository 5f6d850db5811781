#include "puzzle/edit/tree/reference_owners.hpp"

#include "puzzle/edit/tree/tree_access.hpp"

namespace trembler::edit {

ReferenceOwners::ReferenceOwners(Json const& level) {
    for (char const* const key : {"objects", "joints"}) {
        Json const* const list = findList(level, key);
        for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
            std::string name = textOf((*list)[i], "name");
            if (name.empty()) {
                continue;
            }
            if (!textOf((*list)[i], "part").empty()) {
                ofParts_.insert(name);
            }
            names_.insert(std::move(name));
        }
    }
}

std::string ReferenceOwners::of(std::string const& reference) const {
    if (names_.contains(reference)) {
        return reference;
    }
    for (std::size_t end = reference.rfind(' '); end != std::string::npos && end > 0;
         end = reference.rfind(' ', end - 1)) {
        if (std::string name = reference.substr(0, end); ofParts_.contains(name)) {
            return name;
        }
    }
    return reference;
}

} // namespace trembler::edit

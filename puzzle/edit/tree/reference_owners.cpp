#include "puzzle/edit/tree/reference_owners.hpp"

#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

namespace trembler::edit {

ReferenceOwners::ReferenceOwners(GameData const& data, Json const& level) {
    for (char const* const key : {"objects", "joints"}) {
        Json const* const list = findList(level, key);
        for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
            if (std::string const name = textOf((*list)[i], "name"); !name.empty()) {
                owners_.emplace(name, name);
            }
        }
    }
    PartStatements parts(data);
    Json const* const objects = findList(level, "objects");
    for (std::size_t i = 0; objects != nullptr && i < objects->size(); ++i) {
        std::string const name = textOf((*objects)[i], "name");
        if (name.empty()) {
            continue;
        }
        for (std::string const& inside : parts.namesInside(textOf((*objects)[i], "part"))) {
            owners_.emplace(name + " " + inside, name); // names of entries come first
        }
    }
}

std::string ReferenceOwners::of(std::string const& reference) const {
    auto const found = owners_.find(reference);
    return found == owners_.end() ? reference : found->second;
}

} // namespace trembler::edit

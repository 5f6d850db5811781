// Which entries of a level the names in joints and connections belong to.
#pragma once

#include "puzzle/edit/document/command.hpp"

#include <string>
#include <unordered_set>

namespace trembler::edit {

/// Finds the entry that a reference belongs to: "door" for "door coil", if "door" is made from a part. It
/// needs no parts, so that what refers to a piece of an unknown part goes with its object, too. It answers
/// about the level as it was when this was made. For objects of the world: EditedWorld::entryOf().
class ReferenceOwners {
public:
    explicit ReferenceOwners(Json const& level);

    /// The name of the object or joint itself, else of the object of which it may be a piece; the longest if
    /// there are several. The reference itself if there is none.
    [[nodiscard]] std::string of(std::string const& reference) const;
    /// Whether names contain a reference, or the entry that it belongs to.
    template <class Names>
    [[nodiscard]] bool among(Names const& names, std::string const& reference) const {
        return names.contains(reference) || names.contains(of(reference));
    }

private:
    std::unordered_set<std::string> names_;   // of objects and joints; only looked up
    std::unordered_set<std::string> ofParts_; // of objects that are made from parts
};

} // namespace trembler::edit

// The forms for single entries of recorded solutions: placements, wires, inputs, changes of accuracy. They
// are made from the JSON Schema of level files, so that they have every member that files may state.
#pragma once

#include "puzzle/edit/inspect/inspector.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::edit {

/// A kind of entry of a list, such as the input "grab".
struct EntryForm {
    std::string key; ///< the member that tells this kind from the others; empty if the list has only one kind
    Json schema;
};

/// A list of a recorded solution.
struct EntryList {
    std::string key; ///< "placements"
    std::vector<EntryForm> forms;

    /// The form of an entry; nullptr if it has none of the kinds.
    [[nodiscard]] EntryForm const* formOf(Json const& entry) const;
};

/// The names that an entry may state.
struct EntryNames {
    std::vector<std::string> parts;   ///< that can be placed
    std::vector<std::string> objects; ///< of the level and of the solution's placements, with their pieces
};

/// The lists that a solution may have, in the schema's order.
[[nodiscard]] std::vector<EntryList> solutionLists(Json const& levelSchema);

/// The fields of an entry, in the schema's order. `place` is a JSON pointer inside the entry; a member that
/// has only one value, such as "release", has no field.
[[nodiscard]] std::vector<InspectedField> fieldsOfEntry(EntryForm const& form, Json const& entry,
                                                        EntryNames const& names);
/// The entry with another value of a field; with null without the field, and without objects around it that
/// this leaves empty.
[[nodiscard]] Json entryWith(Json entry, InspectedField const& field, Json const& value);
/// An entry with the members that it must state: of the names the first ones, points at `at`, and the
/// smallest numbers. Names that are lacking are empty.
[[nodiscard]] Json newEntry(EntryForm const& form, EntryNames const& names, Vec2 at);

} // namespace trembler::edit

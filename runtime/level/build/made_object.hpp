// An object that a world will have, with the places where its properties are stated.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/entries.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/math/piece_frame.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// A level, or one use of a part: the objects to which the names in its statements refer, and the file of the
/// statements.
struct StatementScope {
    NameTable const* names = nullptr;
    /// Names of objects begin with it, as "front bell " does; empty in a level.
    std::string prefix;
    JsonDocument const* document = nullptr; ///< of a part; null: the level's or the solution's
};

/// Properties stated in one place. They take precedence over those stated further inside.
struct StatedProperties {
    enum class Form {
        entry,     ///< of an object: "properties", and beside them those of its placement
        members,   ///< members of a joint's or the world's entry
        part,      ///< of a part's file: "properties", and beside them its look
        overrides, ///< properties that an entry of a composite states for one of its pieces
        placement, ///< a placement's "at" and "angle_deg"
    };
    PropertySet const* set = nullptr;
    StatementScope const* scope = nullptr;
    std::string path; ///< in the scope's file: of the entry; of overrides, of the object with the properties
    Form form = Form::entry;
    PieceFrame frame{}; ///< that it is stated in, in the world

    /// Whether it states the property. The place of a composite states nothing about its pieces.
    [[nodiscard]] bool states(PropertyInfo const& info) const {
        return (form != Form::overrides || info.text.place == PropertyPlace::properties) && set->states(info);
    }
};

/// One object of a world: an entry, or one piece or joint of a composite part.
struct MadeObject {
    std::string name;
    bool joint = false;
    /// The part that the entry or the placement names, of the one object that represents it in the goals.
    PartDefinition const* part = nullptr;
    bool flipped = false;                 ///< whether it is a mirror image, all frames taken together
    std::vector<StatedProperties> stated; ///< the last one that states a property determines it

    /// The place that determines a property; null: none states it.
    [[nodiscard]] StatedProperties const* determining(PropertyInfo const& info) const;
    /// Where that is in its file, or where it could be stated if no place states it.
    [[nodiscard]] std::pair<StatementScope const*, std::string> placeOf(PropertyInfo const& info) const;
    /// The properties in the world's frame; references still refer to the table of their scope.
    [[nodiscard]] PropertySet properties() const;
    /// The keys of the properties that it is stated not to have, ascending.
    [[nodiscard]] std::vector<std::string> without() const;
};

} // namespace trembler

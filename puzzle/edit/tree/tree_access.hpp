// Finding and changing places in the tree of a level. For commands: any entry of an unexpected form throws
// CommandError, whatever the file contains.
#pragma once

#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::edit {

/// "ball" for one name, "3 objects" for several.
[[nodiscard]] std::string objectsInWords(std::vector<std::string> const& names);

/// The list under a key of the level; nullptr if there is none, or it is no list.
[[nodiscard]] Json const* findList(Json const& level, char const* key);
/// The same for changing it; made, at its usual place in the file, if it does not exist. Throws CommandError
/// if something else is there.
[[nodiscard]] Json& listIn(Json& level, char const* key);
/// The object under a key, in the same way.
[[nodiscard]] Json& objectIn(Json& level, char const* key);
/// Removes a list or an object of the level that has become empty.
void dropIfEmpty(Json& level, char const* key);
/// An entry of a list of the level. Throws CommandError if it does not exist.
[[nodiscard]] Json& entryIn(Json& level, char const* key, std::size_t index);
/// The same as a question, for commands that are being made.
void mustHaveEntry(Json const& level, char const* key, std::size_t index, std::string_view what);
/// Moves an entry to another place of its list.
void moveEntry(Json& level, char const* key, std::size_t from, std::size_t to);

/// The entry of an object. Throws CommandError if there is none.
[[nodiscard]] Json& objectEntry(Json& level, std::string const& name);
/// The entries of all objects by name, for commands on many of them: searching for each would be quadratic.
/// Valid until the list of objects, or a name in it, changes.
class ObjectEntries {
public:
    explicit ObjectEntries(Json& level);
    /// Throws CommandError if there is none of that name.
    [[nodiscard]] Json& of(std::string const& name) const;

private:
    std::map<std::string, Json*> entries_; // copies: setting a member of an entry moves its name
};
void mustHaveObjects(Json const& level, std::vector<std::string> const& names);
/// The text under a key of an object; empty if there is none.
[[nodiscard]] std::string textOf(Json const& object, char const* key);
/// Sets a member of an entry, at its usual place between the others. `order` are the keys in their usual
/// order.
void setMember(Json& entry, std::string const& key, Json value, std::vector<std::string> const& order);
/// The same for an entry of "objects": name, part, place, then the rest.
void setObjectMember(Json& entry, std::string const& key, Json value);
/// The same for the level itself.
void setLevelMember(Json& level, std::string const& key, Json value);

/// Whole numbers without a fraction, others rounded to 1e-9.
[[nodiscard]] Json numberJson(double number);
[[nodiscard]] Json pointJson(Vec2 point);
/// A number of a file; 0 for anything else.
[[nodiscard]] double numberOf(Json const& value);
/// A point [x, y] of a file; nothing for anything else.
[[nodiscard]] std::optional<Vec2> pointOf(Json const& value);
/// Where an object is, m, and its angle in degrees; 0 if it does not state them.
[[nodiscard]] Vec2 placeOf(Json const& entry);
[[nodiscard]] double angleOf(Json const& entry);
/// Set them; an angle that becomes 0 is removed.
void setPlace(Json& entry, Vec2 at);
void setAngle(Json& entry, double degrees);

/// All names of objects and joints of a level, and "world".
[[nodiscard]] std::set<std::string> takenNames(Json const& level);
/// A name like `wanted` that is not taken, by adding or counting up a number. Shortened to the longest name
/// allowed.
[[nodiscard]] std::string untaken(std::set<std::string> const& taken, std::string const& wanted);
/// Throws CommandError unless files allow the text as a name.
void mustBeName(std::string const& name, std::string_view what);

} // namespace trembler::edit

// A change of a level, as a value that menus can name and a document can run.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace trembler::edit {

/// A level file, or a part of one, with its keys in the order of the file. Angles are in degrees, as files
/// state them.
using Json = nlohmann::ordered_json;

/// Thrown by the functions that make commands and by LevelDocument::run(), with a message for the author of
/// the level: the impossible change, and the reason. The document is then as it was.
class CommandError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A change and its name. The functions in puzzle/edit/commands/ make commands from the present
/// tree of a document; they are to be run on that document before anything else is. A command whose change
/// finds the tree otherwise than it expected throws CommandError.
struct Command {
    std::string name; ///< for menus, in the imperative: "Move 3 objects"
    /// Changes the tree of a level. May throw CommandError, having changed the tree or not: the document
    /// works on a copy.
    std::function<void(Json& level)> change;
    /// The objects that should be selected afterwards: the objects that it made, moved or renamed.
    std::vector<std::string> selects{};
};

/// Commands that together are one gesture, such as the moves of one drag or the letters typed into one field,
/// are one step of undo.
struct Gesture {
    enum class Next {
        replaces, ///< the next command is run on the tree before the gesture: a drag states its whole way
        adds,     ///< the next command is run on the tree as it is: an arrow key states one more step
    };
    std::uint64_t number = 0; ///< from LevelDocument::newGesture()
    Next next = Next::replaces;
};

/// Several commands as one step. They are run one after the other; the selection is that of the last one that
/// states any.
[[nodiscard]] Command together(std::string name, std::vector<Command> commands);

} // namespace trembler::edit

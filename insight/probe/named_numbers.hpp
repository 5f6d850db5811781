// Finds numbers that can be plotted by a part of their names.
#pragma once

#include "insight/probe/watch.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::watch {

/// Names as find() takes them.
struct NamedNumbers {
    std::vector<std::string> found;   ///< an exact name first, then names that contain the word
    std::size_t more = 0;             ///< how many others contain it
    std::vector<std::string> similar; ///< names that may be meant, if nothing was found
};

/// The numbers whose name contains a word, whatever its capitals: of `object` ("": none), of the world as a
/// whole, and of an object whose name and a dot begin the word. Numbers without a value at present are
/// included. Elements of lists are found by the name of their first element, the element 0, and any other
/// element by its exact name. `word` must not be empty; at most `most` names are found.
[[nodiscard]] NamedNumbers namedNumbers(World const& world, std::vector<WatchedField> const& fields,
                                        std::string const& object, std::string_view word, std::size_t most);

} // namespace trembler::watch

// The places of a level file: all that the schema has, and those in which two files differ. With "[]" for an
// entry of a list.
#pragma once

#include "tests/game/ui/edit/editor_kit.hpp"

#include <set>
#include <string>

namespace trembler::ui::test {

using Places = std::set<std::string>;

/// Every place of a file that the schema has, with "*" for any key. Those of properties and joints are left
/// out, as they are described once for files and forms.
[[nodiscard]] Places placesOf(edit::Json const& schema);

/// The places at which two values differ, and all within them.
[[nodiscard]] Places differences(edit::Json const& before, edit::Json const& now);

} // namespace trembler::ui::test

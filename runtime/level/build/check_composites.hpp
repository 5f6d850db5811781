// Whether the composite parts of a library can be made.
#pragma once

#include "runtime/level/model/part_library.hpp"

namespace trembler {

/// Throws InputError, with the places in the parts' files, if a piece is made from a part that does not exist
/// or that contains the piece, if there are too many pieces or levels of them (limits), if two pieces get the
/// same name, or if a joint, a connection or a property refers to a piece that does not exist. To be called
/// once all parts have been added. Whether properties and connections are possible is checked when a world is
/// built.
void checkComposites(PartLibrary const& library);

} // namespace trembler

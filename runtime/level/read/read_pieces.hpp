// Reads the pieces of a composite part.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// Reads "objects", "joints", "connections" and "main" of a part's file into the part. Complains if there
/// are joints or connections without pieces, and if no piece has the name of the main one.
void readPieces(MemberReader& reader, Registry const& registry, PartDefinition& part);

} // namespace trembler

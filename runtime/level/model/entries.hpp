// The entries of which a level consists, and likewise a part that is made of pieces.
#pragma once

#include "runtime/level/property/property_set.hpp"

#include <map>
#include <string>

namespace trembler {

/// An entry of "objects".
struct LevelObject {
    std::string name;
    std::string part;       ///< name of the part definition; empty: none
    PropertySet properties; ///< under "properties", and those of its placement ("at", "angle_deg")
    std::string path;       ///< in the file, for messages; empty if it is not from a file
    bool flipped = false;   ///< mirrored about its own vertical axis, before it is turned
    /// Properties of single pieces of a composite part, by the piece's name in the part. `properties` are
    /// those of its main piece.
    std::map<std::string, PropertySet> pieces{};
};

/// An entry of "joints": an object whose property has the key "joint".
struct LevelJoint {
    std::string name; ///< as stated; empty: it gets one (jointNames())
    PropertySet properties;
    std::string path;
};

/// An entry of "connections".
struct LevelConnection {
    std::string a;
    std::string b;
    std::string path;
    std::string kind{}; ///< as stated, for example "wire"; empty: it follows from the objects connected
};

} // namespace trembler

// Whether a name can be that of a piece, before the pieces of a level's parts are known.
#pragma once

#include "runtime/level/model/entries.hpp"

#include <set>
#include <span>
#include <string>

namespace trembler {

/// The pieces of an object "front bell", made from a part, are named "front bell coil" and so on. A level's
/// file is read without the parts, so such names are accepted then, and checked when a world is built.
class PieceNames {
public:
    explicit PieceNames(std::span<LevelObject const> objects);
    /// One more name of an object that is made from a part.
    void add(std::string const& name) { owners_.insert(name); }
    /// Whether it begins with the name of an object that is made from a part, and a blank.
    [[nodiscard]] bool mayBe(std::string const& name) const;

private:
    std::set<std::string> owners_;
};

} // namespace trembler

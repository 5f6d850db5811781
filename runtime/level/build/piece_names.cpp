#include "runtime/level/build/piece_names.hpp"

namespace trembler {

PieceNames::PieceNames(std::span<LevelObject const> objects) {
    for (LevelObject const& object : objects) {
        if (!object.part.empty()) {
            owners_.insert(object.name);
        }
    }
}

bool PieceNames::mayBe(std::string const& name) const {
    for (std::size_t at = name.find(' '); at != std::string::npos; at = name.find(' ', at + 1)) {
        if (owners_.contains(name.substr(0, at))) {
            return true;
        }
    }
    return false;
}

} // namespace trembler

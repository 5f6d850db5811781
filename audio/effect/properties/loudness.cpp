#include "audio/effect/properties/loudness.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>

namespace trembler {

double Loudness::at(ObjectId ear) const {
    auto const found = std::lower_bound(entries.begin(), entries.end(), ear,
                                        [](Entry const& entry, ObjectId id) { return entry.ear < id; });
    return found != entries.end() && found->ear == ear ? found->level : silentLevel;
}

} // namespace trembler

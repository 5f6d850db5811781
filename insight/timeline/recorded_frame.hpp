// One frame of a recording: the values that a picture of it needs.
#pragma once

#include "insight/timeline/words.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace trembler::insight {

/// Words that several frames share while they do not change.
using SharedWords = std::shared_ptr<Words const>;

struct RecordedFrame {
    std::uint64_t number = 0; ///< of the world's frames; 0: before the first one
    /// One for each part of the world's state, in the recording's order (Recording::parts()); null: as at the
    /// beginning of the run. Later parts may be missing, which means the same.
    std::vector<SharedWords> values;

    [[nodiscard]] Words const* of(std::size_t part) const {
        return part < values.size() ? values[part].get() : nullptr;
    }
};

} // namespace trembler::insight

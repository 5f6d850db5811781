#include "runtime/property/state_hash.hpp"

#include <xxhash.h>

#include <new>

namespace trembler {

StateHash::StateHash() : state_(XXH3_createState()) {
    if (!state_) {
        throw std::bad_alloc();
    }
    XXH3_64bits_reset(state_.get());
}

void StateHash::bytes(void const* data, std::size_t size) {
    XXH3_64bits_update(state_.get(), data, size);
}

std::uint64_t StateHash::digest() const {
    return XXH3_64bits_digest(state_.get());
}

void StateHash::Free::operator()(XXH3_state_s* state) const {
    XXH3_freeState(state);
}

} // namespace trembler

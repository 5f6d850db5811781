#include "runtime/property/state_hash.hpp"

#include <xxhash.h>

#include <new>

namespace trembler {

StateHash::StateHash() : state_(XXH3_createState()) { // NOLINT(cppcoreguidelines-pro-type-member-init)
    if (!state_) {
        throw std::bad_alloc();
    }
    XXH3_64bits_reset(state_.get());
}

void StateHash::update(void const* data, std::size_t size) {
    XXH3_64bits_update(state_.get(), data, size);
}

void StateHash::flush() {
    update(buffer_.data(), used_);
    used_ = 0;
}

std::uint64_t StateHash::digest() {
    flush();
    return XXH3_64bits_digest(state_.get());
}

void StateHash::Free::operator()(XXH3_state_s* state) const {
    XXH3_freeState(state);
}

} // namespace trembler

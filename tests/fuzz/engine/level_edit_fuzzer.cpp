// libFuzzer's entry: build with -DTREMBLER_FUZZERS=ON, see docs/contributors.md.
#include "tests/fuzz/targets.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    trembler::edit::fuzzLevelEdit({reinterpret_cast<char const*>(data), size});
    return 0;
}

#include "insight/trial/text_hash.hpp"

#include "puzzle/run/run_report.hpp"

#include <xxhash.h>

namespace trembler::insight {

std::string hashOf(std::string_view text) {
    return hashText(XXH3_64bits(text.data(), text.size()));
}

} // namespace trembler::insight

// The player's file: the kept inputs, and changed ones.
#include "tests/fuzz/files/corpus.hpp"
#include "tests/fuzz/targets.hpp"

namespace trembler::files {
namespace {

TEST(FuzzedFiles, SettingsHold) {
    fuzzTarget("settings", fuzzSettings, 80);
}

} // namespace
} // namespace trembler::files

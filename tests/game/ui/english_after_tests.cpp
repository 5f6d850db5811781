// Every test begins in English: the language in use belongs to the process, and a test that changes it
// through the settings would leave it to the tests after it.
#include "game/ui/shared/texts.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace english_after_tests {
namespace {

class EnglishAfterTests : public testing::EmptyTestEventListener {
    /// Called after the test's own objects are destroyed.
    void OnTestEnd(testing::TestInfo const& /*test*/) override { useLanguage("en"); }
};

/// The list of listeners owns it.
[[maybe_unused]] bool const listens = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new EnglishAfterTests);
    return true;
}();

} // namespace
} // namespace english_after_tests
} // namespace trembler::ui::test

// Messages appear and disappear.
#include "render/panels/toasts.hpp"
#include "tests/render/panels/panels.hpp"

#include <string>

namespace trembler::render::test {
namespace {

TEST_F(Panels, ToastsAppearAndDisappear) {
    Toasts toasts;
    for (int i = 0; i < 8; ++i) {
        toasts.add("Number " + std::to_string(i), ToastKind::News, 1);
    }
    EXPECT_EQ(toasts.count(), 5U);
    frame([&] { toasts.draw(0.5); });
    EXPECT_EQ(toasts.count(), 5U);
    frame([&] { toasts.draw(0.6); });
    EXPECT_EQ(toasts.count(), 0U);
}

} // namespace
} // namespace trembler::render::test

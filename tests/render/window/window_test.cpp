// The window reports failures as sentences, and its pictures can be saved.
#include "tests/render/stage.hpp"
#include "tests/support/read_png.hpp"

#include <SDL.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace trembler::render::test {
namespace {

/// Opens a second window with one environment variable set and prints the failure; runs in a separate
/// process, because SDL must be initialised there for the first time.
[[noreturn]] void openAndReport(char const* variable, char const* value, WindowMode mode) {
    for (auto const* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) {
        unsetenv(name); // NOLINT(concurrency-mt-unsafe): the only thread of a fresh process
    }
    setenv(variable, value, 1); // NOLINT(concurrency-mt-unsafe)
    try {
        Window const second({.mode = mode});
        std::fputs("opened", stderr);
    } catch (WindowError const& error) {
        std::fprintf(stderr, "kind %d: %s", static_cast<int>(error.kind()), error.what());
    }
    std::_Exit(0);
}

class WindowFailure : public testing::Test {
protected:
    void SetUp() override { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST_F(WindowFailure, AMissingDisplayIsReported) {
    EXPECT_EXIT(openAndReport("NO_SUCH_SETTING", "1", WindowMode::Visible), testing::ExitedWithCode(0),
                "kind 0: .*no display|kind 0: .*no video driver");
}

TEST_F(WindowFailure, ADriverWithoutAScreenIsNoDisplay) {
    EXPECT_EXIT(openAndReport("SDL_VIDEODRIVER", "dummy", WindowMode::Visible), testing::ExitedWithCode(0),
                "kind 0: There is no display");
    EXPECT_EXIT(openAndReport("SDL_VIDEODRIVER", "offscreen", WindowMode::Visible),
                testing::ExitedWithCode(0), "kind 0: There is no display");
}

TEST_F(WindowFailure, MissingOpenGlIsReported) {
    EXPECT_EXIT(openAndReport("SDL_VIDEO_EGL_DRIVER", "/no/such/library.so", WindowMode::Offscreen),
                testing::ExitedWithCode(0), "kind 1: .*OpenGL");
}

TEST_F(WindowFailure, OffscreenNeedsNoDisplay) {
    EXPECT_EXIT(openAndReport("SDL_VIDEODRIVER", "x11", WindowMode::Offscreen), testing::ExitedWithCode(0),
                "opened");
}

TEST(Windows, AreOffscreenInTests) {
    EXPECT_EQ(window().mode(), WindowMode::Offscreen);
    EXPECT_FLOAT_EQ(window().pixelsPerPoint(), 1.F);
}

TEST(Windows, OffscreenTakesAnySize) {
    for (auto const size : {Size{64, 48}, Size{3840, 2160}, Size{641, 479}}) {
        window().resize(size);
        window().beginFrame(rgb(0x336699));
        auto const image = window().readPixels();
        EXPECT_EQ(image.size(), size);
        EXPECT_EQ(image.at(size.width - 1, size.height - 1), (Pixel{0x33, 0x66, 0x99, 255}));
    }
    EXPECT_THROW(window().resize({1000000, 10}), RenderError);
    EXPECT_THROW(window().resize({0, 10}), RenderError);
    EXPECT_EQ(window().size(), (Size{641, 479})); // the old size is kept
}

TEST(Windows, TwoAreIndependent) {
    window().resize({64, 48});
    window().beginFrame(rgb(0x336699));
    {
        Window second({.size = {32, 32}, .mode = WindowMode::Offscreen});
        second.beginFrame(rgb(0xCC2200));
        EXPECT_EQ(window().readPixels().at(63, 47), (Pixel{0x33, 0x66, 0x99, 255}));
        EXPECT_EQ(second.readPixels().at(31, 31), (Pixel{0xCC, 0x22, 0x00, 255}));
        window().beginFrame(rgb(0x00AA00));
        EXPECT_EQ(second.readPixels().at(31, 31), (Pixel{0xCC, 0x22, 0x00, 255}));
    }
    EXPECT_EQ(window().readPixels().at(63, 47), (Pixel{0x00, 0xAA, 0x00, 255}));
}

TEST(Pictures, AreUnchangedAfterPngEncoding) {
    auto const image = picture({320, 200}, palette::paper, [](Canvas& canvas) {
        canvas.paper();
        canvas.circle({{0.5, 0.5}, 0}, 0.4, {.pattern = Pattern::Copper});
    });
    auto const file = pictureFolder() / "round-trip.png";
    writePng(image, file);
    EXPECT_EQ(readPng(file), image);
    EXPECT_EQ(image.at(0, 0)[3], 255);
}

TEST(Pictures, FirstRowIsTheUpperOne) {
    auto const image = picture({100, 100}, rgb(0), [](Canvas& canvas) {
        canvas.box({{0, 0.4}, 0}, {0.5, 0.1}, 0, {.tint = rgb(0xFFFFFF), .outline = 0.F, .height = 0.F});
    });
    EXPECT_GT(image.at(50, 10)[0], 200);
    EXPECT_EQ(image.at(50, 90)[0], 0);
}

TEST(Pictures, FailuresNameTheFile) {
    Image const image({2, 2});
    try {
        writePng(image, "/no/such/folder/picture.png");
        FAIL();
    } catch (RenderError const& error) {
        EXPECT_NE(std::string(error.what()).find("/no/such/folder/picture.png"), std::string::npos);
    }
    auto const file = pictureFolder() / "not-a-picture.png";
    std::ofstream(file) << "hello";
    EXPECT_THROW((void)readPng(file), RenderError);
    EXPECT_THROW(writePng(Image(), file), RenderError);
    EXPECT_THROW((void)image.at(2, 0), std::out_of_range);
    EXPECT_THROW(Image({-1, 2}), std::invalid_argument);
}

TEST(Framebuffers, AreDrawnAndReadSeparately) {
    window().resize({64, 64});
    window().beginFrame(rgb(0xFF0000));
    Framebuffer const target({32, 32});
    target.bind();
    auto& sheet = canvas();
    sheet.begin({{0, 0}, 100, {32, 32}}, {});
    sheet.paper();
    sheet.end();
    EXPECT_NEAR(target.read().at(16, 3)[0], palette::paper.red, 40);
    EXPECT_EQ(window().readPixels().at(16, 16), (Pixel{255, 0, 0, 255}));
}

} // namespace
} // namespace trembler::render::test

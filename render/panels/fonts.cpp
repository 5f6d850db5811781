#include "render/panels/theme.hpp"

#include <imgui_freetype.h>

#include <array>
#include <filesystem>
#include <system_error>

namespace trembler::render {

namespace {

/// One family: where its Debian package puts it.
struct Family {
    char const* package;
    char const* regular;
    char const* strong;
    char const* bold;
};

constexpr std::array families{
    Family{"fonts-inter", "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
           "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
           "/usr/share/fonts/opentype/inter/Inter-Bold.otf"},
    Family{"fonts-dejavu-core", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
           "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
           "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
};
constexpr auto const& signs = families[1];

// From the thin space, which stands between groups of digits.
// ImGui keeps these pointers until the atlas is built, hence static storage.
constexpr std::array<ImWchar, 7> latin{0x0020, 0x017F, 0x2009, 0x2026, 0x20AC, 0x20AC, 0};
constexpr std::array<ImWchar, 11> text{0x0020, 0x017F, 0x0370, 0x03FF, 0x2009, 0x203A,
                                       0x2070, 0x209C, 0x20AC, 0x20AC, 0};
/// Arrows, mathematics, keys, geometric shapes, ticks and crosses.
constexpr std::array<ImWchar, 11> symbols{0x2190, 0x21FF, 0x2200, 0x22FF, 0x2300, 0x23FF,
                                          0x25A0, 0x25FF, 0x2600, 0x27BF, 0};

/// Arrow keys are shown in small letters, too.
constexpr std::array<ImWchar, 3> arrows{0x2190, 0x2193, 0};

bool there(char const* file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored);
}

/// `symbolRange`: the signs taken from the other family; nullptr: none.
ImFont* load(char const* file, float pixels, ImWchar const* range, ImWchar const* symbolRange = nullptr) {
    ImFontConfig config;
    config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    auto& atlas = *ImGui::GetIO().Fonts;
    ImFont* font = atlas.AddFontFromFileTTF(file, pixels, &config, range);
    if (font != nullptr && symbolRange != nullptr && there(signs.regular)) {
        config.MergeMode = true;
        atlas.AddFontFromFileTTF(signs.regular, pixels * 0.94F, &config, symbolRange);
    }
    return font;
}

Fonts builtIn(float scale) {
    auto& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    auto const sized = [&](float pixels) {
        ImFontConfig config;
        config.SizePixels = pixels * scale;
        return atlas.AddFontDefault(&config);
    };
    Fonts fonts;
    fonts.body = fonts.strong = sized(15);
    fonts.small = sized(13);
    fonts.heading = sized(20);
    fonts.title = sized(39);
    fonts.builtIn = true;
    fonts.message =
        "No letters were found, so these are built in and coarse: install the package fonts-inter or "
        "fonts-dejavu-core.";
    return fonts;
}

} // namespace

Fonts loadFonts(float scale) {
    auto& atlas = *ImGui::GetIO().Fonts;
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    for (auto const& family : families) {
        if (!there(family.regular) || !there(family.strong) || !there(family.bold)) {
            continue;
        }
        atlas.Clear();
        Fonts fonts;
        fonts.body = load(family.regular, 17 * scale, text.data(), symbols.data());
        fonts.small = load(family.regular, 14 * scale, text.data(), arrows.data());
        fonts.strong = load(family.strong, 17 * scale, text.data());
        fonts.heading = load(family.strong, 23 * scale, latin.data());
        fonts.title = load(family.bold, 46 * scale, latin.data());
        bool const all = fonts.body != nullptr && fonts.small != nullptr && fonts.strong != nullptr &&
                         fonts.heading != nullptr && fonts.title != nullptr;
        if (all && atlas.Build()) {
            fonts.message = std::string("Letters from the package ") + family.package + ".";
            return fonts;
        }
    }
    return builtIn(scale);
}

} // namespace trembler::render

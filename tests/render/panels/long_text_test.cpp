// Texts of any length in every kind of ImGui's widgets: none ends the program, and pieces of a text lie where
// ImGui draws the whole.
#include "render/panels/long_text.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/toasts.hpp"
#include "tests/render/panels/panels.hpp"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace trembler::render::test {
namespace {

class LongText : public Panels {
protected:
    /// One frame that is laid out and collected, which ImGui checks, but not drawn.
    void collected(std::function<void()> const& draw) {
        dropped(draw);
        ImGui::Render();
    }
};

/// A letter on the screen.
struct Quad {
    ImVec2 low;
    ImVec2 high;
    ImVec2 letter; ///< its place in the texture
};

/// Those in sight, in the order in which they are drawn.
std::vector<Quad> quadsOf(ImDrawList const& list, ImVec4 const& clip) {
    std::vector<Quad> quads;
    for (int i = 0; i + 3 < list.VtxBuffer.Size; i += 4) {
        ImDrawVert const& low = list.VtxBuffer[i];
        ImDrawVert const& high = list.VtxBuffer[i + 2];
        if (high.pos.y > clip.y && low.pos.y < clip.w && high.pos.x > clip.x && low.pos.x < clip.z) {
            quads.push_back({low.pos, high.pos, low.uv});
        }
    }
    return quads;
}

/// A text of words, lines and signs of one to three bytes.
std::string someText(std::mt19937_64& random, std::size_t bytes) {
    constexpr std::array<char const*, 12> pieces{"a",  "word", " ",      "  ",     "\n", "\n\n",
                                                 "\t", "-",    "\u00E4", "\u20AC", ".",  "longerWord"};
    std::string text;
    while (text.size() < bytes) {
        text += pieces[random() % pieces.size()];
    }
    return text;
}

TEST_F(LongText, IsDrawnWhereImGuiDrawsTheWhole) {
    std::mt19937_64 random(36);
    std::size_t letters = 0;
    for (int round = 0; round < 150; ++round) {
        std::string const text = someText(random, 200 + random() % 9000);
        float const wrap = round % 3 == 0 ? 0.F : 40.F + static_cast<float>(random() % 600);
        ImVec2 const at{100.F - static_cast<float>(random() % 400),
                        50.F - static_cast<float>(random() % 3000)};
        ImVec4 const fine{at.x + 20, 100, at.x + 500, 400};
        ImVec4 const* const fineClip = round % 4 == 1 ? &fine : nullptr;
        dropped([&] {
            ImFont const& font = *theme().fonts.body;
            ImVec4 const clip{50, 40, 900, 600};
            std::array<std::vector<Quad>, 2> drawn;
            for (bool const pieces : {false, true}) {
                ImDrawList list(ImGui::GetDrawListSharedData());
                list._ResetForNewFrame();
                list.PushTextureID(ImGui::GetIO().Fonts->TexID);
                list.PushClipRect({clip.x, clip.y}, {clip.z, clip.w});
                char const* const end = text.data() + text.size();
                if (pieces) {
                    addLongText(list, font, font.FontSize, at, IM_COL32_BLACK, text.data(), end, wrap,
                                fineClip);
                } else {
                    ASSERT_LT(text.size(), static_cast<std::size_t>(mostBytesAtOnce));
                    list.AddText(&font, font.FontSize, at, IM_COL32_BLACK, text.data(), end, wrap, fineClip);
                }
                drawn.at(pieces ? 1 : 0) = quadsOf(list, clip);
            }
            auto const& [whole, split] = drawn;
            ASSERT_EQ(whole.size(), split.size()) << "round " << round;
            letters += whole.size();
            for (std::size_t i = 0; i < whole.size(); ++i) {
                EXPECT_EQ(whole[i].letter.x, split[i].letter.x);
                EXPECT_EQ(whole[i].letter.y, split[i].letter.y);
                EXPECT_NEAR(whole[i].low.x, split[i].low.x, 1) << "round " << round << ", letter " << i;
                EXPECT_NEAR(whole[i].low.y, split[i].low.y, 0.01) << "round " << round << ", letter " << i;
                EXPECT_NEAR(whole[i].high.x, split[i].high.x, 1);
            }
        });
    }
    EXPECT_GT(letters, 5000U);
}

TEST_F(LongText, EndsNoProgramInAnyWidget) {
    dropped([] {});
    EXPECT_NE(ImGui::GetIO().BackendFlags & ImGuiBackendFlags_RendererHasVtxOffset, 0)
        << "many texts of 16,000 bytes need it";
    std::mt19937_64 random(5);
    std::string combining;
    for (int i = 0; i < 20'000; ++i) {
        combining += "\u0301"; // of no width of its own
    }
    std::vector<std::string> texts{std::string(16'000, 'x'),
                                   std::string(16'001, 'x'),
                                   std::string(17'000, 'i'),
                                   std::string(100'000, 'i'),
                                   std::string(100'000, '\n'),
                                   std::string(100'000, ' '),
                                   combining,
                                   someText(random, 17'000),
                                   someText(random, 400'000)};
    std::string broken = someText(random, 30'000); // no UTF-8
    for (int i = 0; i < 3000; ++i) {
        broken[random() % broken.size()] = static_cast<char>(0x80U | (random() & 0x7FU));
    }
    texts.push_back(broken);
    Toasts toasts;
    for (std::string& text : texts) {
        char const* const words = text.c_str();
        toasts.add(text, ToastKind::Trouble, 60);
        std::string label = text + "##label";
        collected([&] {
            ImGui::SetNextWindowSize({500, 400});
            ImGui::Begin("long", nullptr, ImGuiWindowFlags_AlwaysVerticalScrollbar);
            ImGui::SetScrollY(3000);
            ImGui::TextWrapped("%s", words);
            ImGui::TextUnformatted(words);
            ImGui::Button(label.c_str());
            ImGui::Selectable(label.c_str());
            ImGui::SetTooltip("%s", words);
            ImGui::InputText("one line", &text);
            ImGui::InputTextMultiline("lines", &text);
            if (ImGui::BeginCombo("list", words)) {
                ImGui::EndCombo();
            }
            ImGui::BeginTooltip();
            ImGui::TextUnformatted(words);
            ImGui::EndTooltip();
            ImGui::End();
            ImGui::GetForegroundDrawList()->AddText({-300, -5000}, IM_COL32_BLACK, words);
            ImGui::GetForegroundDrawList()->AddText(nullptr, 0, {10, 10}, IM_COL32_BLACK, words, nullptr,
                                                    300);
            ImGui::GetBackgroundDrawList()->AddText(nullptr, 0, {10, -40'000}, IM_COL32_BLACK, words, nullptr,
                                                    1);
            toasts.draw(1.0 / 60);
        });
    }
}

TEST_F(LongText, DrawsWhatIsInSightOfATextThatWasScrolledTo) {
    // Line 20,000 of 40,000, by the letters of its number.
    std::string text;
    for (int line = 0; line < 40'000; ++line) {
        text += "line " + std::to_string(line) + "\n";
    }
    dropped([&] {
        ImFont const& font = *theme().fonts.body;
        ImVec4 const clip{0, 0, 600, 2.5F * font.FontSize};
        std::array<std::vector<Quad>, 2> drawn;
        for (bool const all : {false, true}) {
            ImDrawList list(ImGui::GetDrawListSharedData());
            list._ResetForNewFrame();
            list.PushTextureID(ImGui::GetIO().Fonts->TexID);
            list.PushClipRect({clip.x, clip.y}, {clip.z, clip.w});
            if (all) {
                list.AddText(&font, font.FontSize, {0, -20'000 * font.FontSize}, IM_COL32_BLACK, text.c_str(),
                             nullptr, 500);
            } else {
                list.AddText(&font, font.FontSize, {0, 0}, IM_COL32_BLACK,
                             "line 20000\nline 20001\nline 20002\n");
            }
            drawn.at(all ? 1 : 0) = quadsOf(list, clip);
        }
        ASSERT_EQ(drawn[0].size(), drawn[1].size());
        EXPECT_EQ(drawn[0].size(), 27U) << "three lines of nine letters";
        for (std::size_t i = 0; i < drawn[0].size(); ++i) {
            EXPECT_EQ(drawn[0][i].letter.x, drawn[1][i].letter.x);
            EXPECT_NEAR(drawn[0][i].low.x, drawn[1][i].low.x, 0.01);
            EXPECT_NEAR(drawn[0][i].low.y, drawn[1][i].low.y, 1.01);
        }
    });
}

TEST_F(LongText, IsCutInAMessage) {
    Toasts toasts;
    toasts.add(std::string(5000, 'x'));
    EXPECT_EQ(toasts.newest(), std::string(997, 'x') + "...");
}

} // namespace
} // namespace trembler::render::test

// The outlines of buttons are drawn whole, also of those at the edges of a row.
#include "tests/game/ui/player.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace trembler::ui::test {
namespace outlines_test {
namespace {

/// How far an area that is not transparent reaches beyond its clip rectangle, pixels; of all windows of these
/// names.
float cutFrom(std::span<std::string_view const> windows) {
    ImGui::Render(); // does nothing if the picture was drawn
    ImDrawData const& data = *ImGui::GetDrawData();
    float most = -1;
    for (int n = 0; n < data.CmdListsCount; ++n) {
        ImDrawList const& list = *data.CmdLists[n];
        std::string_view const owner = list._OwnerName != nullptr ? list._OwnerName : "";
        if (std::find(windows.begin(), windows.end(), owner) == windows.end()) {
            continue;
        }
        for (ImDrawCmd const& command : list.CmdBuffer) {
            ImVec4 const& clip = command.ClipRect;
            for (unsigned i = command.IdxOffset; i < command.IdxOffset + command.ElemCount; ++i) {
                unsigned const index = list.IdxBuffer[static_cast<int>(i)] + command.VtxOffset;
                ImDrawVert const& vertex = list.VtxBuffer[static_cast<int>(index)];
                if ((vertex.col >> IM_COL32_A_SHIFT) > 0) {
                    most = std::max({most, clip.x - vertex.pos.x, clip.y - vertex.pos.y,
                                     vertex.pos.x - clip.z, vertex.pos.y - clip.w});
                }
            }
        }
    }
    return most;
}

TEST(Outlines, AreWholeAtEverySize) {
    constexpr std::array<std::string_view, 4> rows{"transport", "tools", "corner", "timeline"};
    constexpr std::array<std::string_view, 2> editorRows{"bar", "tools"};
    for (render::Size const size : {render::Size{800, 600}, render::Size{1280, 720}, render::Size{2560, 1440},
                                    render::Size{3840, 2160}}) {
        std::string const where = std::to_string(size.width) + "x" + std::to_string(size.height);
        Player player(size);
        player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
        player.key(SDLK_SPACE);
        player.simulate(16);
        player.frames(6);
        ASSERT_TRUE(player.showsCard("transport"));
        EXPECT_LE(cutFrom(rows), 0.01F) << where;
        player.app().edit({});
        player.frames(6);
        ASSERT_TRUE(player.showsCard("bar"));
        EXPECT_LE(cutFrom(editorRows), 0.01F) << where << " in the editor";
    }
}

} // namespace
} // namespace outlines_test
} // namespace trembler::ui::test

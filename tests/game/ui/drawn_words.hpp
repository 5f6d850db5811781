// Reads the words of a picture back from Dear ImGui's draw lists: every letter is a rectangle of the font's
// texture. So all drawn text is found, whichever function has drawn it.
#pragma once

#include "render/panels/theme.hpp"

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace trembler::ui::test {

class DrawnWords {
public:
    DrawnWords() {
        ImFontAtlas const& fonts = *ImGui::GetIO().Fonts;
        for (ImFont const* const font : fonts.Fonts) {
            for (ImFontGlyph const& glyph : font->Glyphs) {
                glyphs_[key({glyph.U0, glyph.V0}, {glyph.U1, glyph.V1})] = {&glyph, font};
            }
        }
    }

    /// The lines of the last picture, in the order in which they were drawn; a space where there is a gap.
    [[nodiscard]] std::vector<std::string> lines() const {
        std::vector<std::string> all;
        Pen pen;
        ImDrawData const* const data = ImGui::GetDrawData();
        for (int i = 0; data != nullptr && i < data->CmdListsCount; ++i) {
            read(*data->CmdLists[i], pen, all);
        }
        return all;
    }

private:
    using Key = std::tuple<float, float, float, float>;
    struct Found {
        ImFontGlyph const* glyph = nullptr;
        ImFont const* font = nullptr;
    };
    struct Pen { // where the next letter of the line begins
        float x = 0, y = 0;
        ImFont const* font = nullptr;
    };
    static Key key(ImVec2 low, ImVec2 high) { return {low.x, low.y, high.x, high.y}; }

    void read(ImDrawList const& list, Pen& pen, std::vector<std::string>& all) const {
        for (int at = 0; at + 5 < list.IdxBuffer.Size; at += 3) {
            ImDrawIdx const* const index = list.IdxBuffer.Data + at;
            int const first = index[0];
            bool const quad = index[1] == first + 1 && index[2] == first + 2 && index[3] == first &&
                              index[4] == first + 2 && index[5] == first + 3;
            if (!quad) {
                continue;
            }
            ImDrawVert const& low = list.VtxBuffer[first];
            ImDrawVert const& high = list.VtxBuffer[first + 2];
            auto const found = glyphs_.find(key(low.uv, high.uv));
            if (found != glyphs_.end()) {
                write(found->second, low.pos, high.pos, pen, all);
                at += 3;
            }
        }
    }

    static void write(Found const& found, ImVec2 low, ImVec2 high, Pen& pen, std::vector<std::string>& all) {
        ImFontGlyph const& glyph = *found.glyph;
        float const scale = (high.x - low.x) / (glyph.X1 - glyph.X0);
        float const x = low.x - glyph.X0 * scale;
        float const y = low.y - glyph.Y0 * scale;
        float const em = found.font->FontSize * scale;
        bool const same = pen.font == found.font && std::abs(pen.y - y) < 0.2F * em &&
                          x > pen.x - 0.2F * em && x < pen.x + 0.6F * em;
        if (!same || all.empty()) {
            all.emplace_back();
        } else if (x > pen.x + 0.12F * em) {
            all.back() += ' ';
        }
        append(all.back(), glyph.Codepoint);
        pen = {x + glyph.AdvanceX * scale, y, found.font};
    }

    static void append(std::string& text, unsigned code) { // as UTF-8
        if (code < 0x80U) {
            text += static_cast<char>(code);
        } else if (code < 0x800U) {
            text += static_cast<char>(0xC0U | (code >> 6U));
            text += static_cast<char>(0x80U | (code & 0x3FU));
        } else {
            text += static_cast<char>(0xE0U | (code >> 12U));
            text += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
            text += static_cast<char>(0x80U | (code & 0x3FU));
        }
    }

    std::map<Key, Found> glyphs_;
};

} // namespace trembler::ui::test

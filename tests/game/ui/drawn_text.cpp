#include "tests/game/ui/drawn_text.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace trembler::ui::test {
namespace {

constexpr float cutBy = 1.5F;        // pixels; less is the softness of an edge
constexpr unsigned faintBelow = 200; // opacity of 255

struct Letter {
    ImFont const* font = nullptr;
    ImFontGlyph const* glyph = nullptr;
    bool whole = true; // the texture's rectangle is not clipped
};

/// Every letter of every font by its place in the texture.
class Letters {
public:
    explicit Letters(ImFontAtlas const& fonts) {
        for (ImFont const* font : fonts.Fonts) {
            for (ImFontGlyph const& glyph : font->Glyphs) {
                if (glyph.Visible != 0) {
                    byCorner_.emplace(std::pair(glyph.U0, glyph.V0), Letter{font, &glyph, true});
                    all_.push_back({font, &glyph, true});
                }
            }
        }
    }
    [[nodiscard]] std::optional<Letter> at(ImVec2 low, ImVec2 high) const {
        auto const found = byCorner_.find({low.x, low.y});
        if (found != byCorner_.end() && found->second.glyph->U1 == high.x &&
            found->second.glyph->V1 == high.y) {
            return found->second;
        }
        float const u = 0.5F * (low.x + high.x);
        float const v = 0.5F * (low.y + high.y);
        for (Letter const& letter : all_) {
            ImFontGlyph const& glyph = *letter.glyph;
            if (u > glyph.U0 && u < glyph.U1 && v > glyph.V0 && v < glyph.V1) {
                return Letter{letter.font, &glyph, false};
            }
        }
        return {};
    }

private:
    std::map<std::pair<float, float>, Letter> byCorner_;
    std::vector<Letter> all_;
};

/// The letters of the fonts that are shown now. There are thousands, so they are listed once for each
/// texture. A new texture shows in the fonts' lists of glyphs, as ImGui adds the glyphs again.
Letters const& shownLetters() {
    struct Made {
        ImFont const* font;
        ImFontGlyph const* glyphs;
        int count;
        float size;
        bool operator==(Made const&) const = default;
    };
    static std::vector<Made> madeFrom;
    static std::optional<Letters> letters;
    ImFontAtlas const& fonts = *ImGui::GetIO().Fonts;
    std::vector<Made> now;
    for (ImFont const* font : fonts.Fonts) {
        now.push_back({font, font->Glyphs.Data, font->Glyphs.Size, font->FontSize});
    }
    if (!letters || now != madeFrom) {
        letters.emplace(fonts);
        madeFrom = std::move(now);
    }
    return *letters;
}

std::string utf8(unsigned point) {
    std::string text;
    auto const tail = [&](unsigned shift) { text += static_cast<char>(0x80U | ((point >> shift) & 0x3FU)); };
    if (point < 0x80) {
        text += static_cast<char>(point);
    } else if (point < 0x800) {
        text += static_cast<char>(0xC0U | (point >> 6U));
        tail(0);
    } else {
        text += static_cast<char>(0xE0U | (point >> 12U));
        tail(6);
        tail(0);
    }
    return text;
}

/// Adds letters to words as long as they follow each other on a line.
class Lines {
public:
    explicit Lines(std::vector<DrawnText>& texts) : texts_(texts) {}

    void beginList(ImDrawList const& list) {
        window_ = list._OwnerName != nullptr ? list._OwnerName : "";
        ImGuiWindow const* const window = ImGui::FindWindowByName(window_.c_str());
        scrolls_ = window != nullptr && window->ScrollMax.y > 0;
        font_ = nullptr;
    }

    void add(Letter const& letter, ImVec2 low, ImVec2 high, ImVec4 const& clip) {
        ImFontGlyph const& glyph = *letter.glyph;
        // Letters may be enlarged; clipped ones keep at least one of their edges.
        float const scale = letter.whole ? (high.y - low.y) / (glyph.Y1 - glyph.Y0) : 1.F;
        float const top = low.y - glyph.Y0 * scale;
        float const size = letter.font->FontSize * scale;
        bool const seen = low.x < clip.z && high.x > clip.x && low.y < clip.w && high.y > clip.y;
        if (!seen) {
            return;
        }
        bool const follows = font_ == letter.font && std::abs(top - top_) < 1.F &&
                             low.x > right_ - 0.35F * size && low.x < right_ + 0.9F * size;
        if (!follows) {
            texts_.push_back(
                {"", window_, {{low.x, low.y}, {high.x, high.y}}, size, top, false, false, scrolls_});
        }
        DrawnText& text = texts_.back();
        if (follows && low.x > right_ + 0.16F * size) {
            text.text += ' ';
        }
        text.text += utf8(glyph.Codepoint);
        text.rect.low.x = std::min<double>(text.rect.low.x, std::max(low.x, clip.x));
        text.rect.low.y = std::min<double>(text.rect.low.y, std::max(low.y, clip.y));
        text.rect.high.x = std::max<double>(text.rect.high.x, std::min(high.x, clip.z));
        text.rect.high.y = std::max<double>(text.rect.high.y, std::min(high.y, clip.w));
        bool const narrowed = !letter.whole && std::abs((high.x - low.x) - (glyph.X1 - glyph.X0)) > cutBy;
        bool const lowered = !letter.whole && std::abs((high.y - low.y) - (glyph.Y1 - glyph.Y0)) > cutBy;
        text.cutAcross = text.cutAcross || narrowed || low.x < clip.x - cutBy || high.x > clip.z + cutBy;
        text.cutAlong = text.cutAlong || lowered || low.y < clip.y - cutBy || high.y > clip.w + cutBy;
        font_ = letter.font;
        top_ = letter.whole ? top : top_;
        right_ = high.x;
    }

private:
    std::vector<DrawnText>& texts_;
    std::string window_;
    bool scrolls_ = false;
    ImFont const* font_ = nullptr;
    float top_ = 0;
    float right_ = 0;
};

void readCommand(ImDrawList const& list, ImDrawCmd const& command, Letters const& letters, Lines& lines) {
    unsigned const end = command.IdxOffset + command.ElemCount;
    for (unsigned i = command.IdxOffset; i + 3 <= end;) {
        ImDrawIdx const* const index = &list.IdxBuffer[static_cast<int>(i)];
        // Six indices of four corners are a rectangle, as letters are.
        bool const rectangle = i + 6 <= end && index[1] == index[0] + 1 && index[2] == index[0] + 2 &&
                               index[3] == index[0] && index[4] == index[2] && index[5] == index[0] + 3;
        if (!rectangle) {
            i += 3;
            continue;
        }
        ImDrawVert const& low = list.VtxBuffer[static_cast<int>(index[0] + command.VtxOffset)];
        ImDrawVert const& high = list.VtxBuffer[static_cast<int>(index[2] + command.VtxOffset)];
        i += 6;
        if (low.uv.x >= high.uv.x || low.uv.y >= high.uv.y || (low.col >> IM_COL32_A_SHIFT) < faintBelow) {
            continue;
        }
        if (auto const letter = letters.at(low.uv, high.uv)) {
            lines.add(*letter, low.pos, high.pos, command.ClipRect);
        }
    }
}

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

} // namespace

std::vector<DrawnText> drawnTexts() {
    ImGui::Render(); // does nothing if the picture was drawn
    std::vector<DrawnText> texts;
    Letters const& letters = shownLetters();
    Lines lines(texts);
    ImDrawData const& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        ImDrawList const& list = *data.CmdLists[i];
        lines.beginList(list);
        for (ImDrawCmd const& command : list.CmdBuffer) {
            if (command.TextureId == ImGui::GetIO().Fonts->TexID && command.UserCallback == nullptr) {
                readCommand(list, command, letters, lines);
            }
        }
    }
    return texts;
}

bool breaksANumber(DrawnText const& first, DrawnText const& second) {
    bool const next = first.window == second.window && first.line == second.line &&
                      std::abs(second.top - first.top - first.line) < 2 &&
                      second.rect.low.x < first.rect.high.x && second.rect.high.x > first.rect.low.x;
    if (!next || first.text.empty() || second.text.empty()) {
        return false;
    }
    // "0 of | 5": a count is one number.
    for (std::string_view const of : {" of", " von"}) {
        std::size_t const length = first.text.size();
        if (first.text.ends_with(of) && length > of.size() && isDigit(first.text[length - of.size() - 1])) {
            return isDigit(second.text.front());
        }
    }
    if (!isDigit(first.text.back())) {
        return false;
    }
    constexpr std::array<std::string_view, 43> units{
        "m",    "cm",    "mm",   "km",    "s",      "ms",     "µs",      "N",       "kN",       "kg",  "g",
        "A",    "mA",    "V",    "W",     "kW",     "Hz",     "Ω",       "°",       "%",        "T",   "mT",
        "Pa",   "J",     "K",    "L",     "dB",     "second", "seconds", "Sekunde", "Sekunden", "of",  "von",
        "part", "parts", "Teil", "Teile", "Teilen", "metres", "Meter",   "degrees", "times",    "Grad"};
    std::string const word = second.text.substr(0, second.text.find_first_of(" .,;:)/"));
    return isDigit(second.text.front()) || std::find(units.begin(), units.end(), word) != units.end();
}

} // namespace trembler::ui::test

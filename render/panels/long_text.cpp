#include "render/panels/long_text.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

// The names are those that the linker gives to a wrapped function and to the one that it hides. They are of
// the Itanium C++ ABI, in which the object is the first argument of a member function.
namespace trembler::render {

void addTextOfImGui(
    ImDrawList* list, ImFont const* font, float size, ImVec2 const& at, ImU32 colour, char const* begin,
    char const* end, float wrapWidth,
    ImVec4 const* fineClip) asm("__real__ZN10ImDrawList7AddTextEPK6ImFontfRK6ImVec2jPKcS7_fPK6ImVec4");
void addText(
    ImDrawList* list, ImFont const* font, float size, ImVec2 const& at, ImU32 colour, char const* begin,
    char const* end, float wrapWidth,
    ImVec4 const* fineClip) asm("__wrap__ZN10ImDrawList7AddTextEPK6ImFontfRK6ImVec2jPKcS7_fPK6ImVec4");
void addPlainText(ImDrawList* list, ImVec2 const& at, ImU32 colour, char const* begin,
                  char const* end) asm("__wrap__ZN10ImDrawList7AddTextERK6ImVec2jPKcS4_");

namespace {

constexpr std::ptrdiff_t pieceOfLine = 4'000; // bytes

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

/// The end of the piece that begins at `from`: not inside a character of UTF-8.
char const* endOfPiece(char const* from, char const* end) {
    if (end - from <= pieceOfLine) {
        return end;
    }
    char const* at = from + pieceOfLine;
    for (int i = 0; i < 3 && (static_cast<unsigned char>(*at) & 0xC0U) == 0x80U; ++i) {
        --at;
    }
    return at;
}

struct Line {
    char const* end;  ///< of what is drawn
    char const* next; ///< where the next line begins
};

/// The line that begins at `from`, broken as ImFont::RenderText breaks it.
Line lineFrom(ImFont const& font, float scale, char const* from, char const* end, float wrapWidth) {
    auto const* const feed =
        static_cast<char const*>(std::memchr(from, '\n', static_cast<std::size_t>(end - from)));
    char const* const whole = feed == nullptr ? end : feed;
    if (wrapWidth > 0 && whole != from) {
        char const* broken = font.CalcWordWrapPositionA(scale, from, whole, wrapWidth);
        broken = broken == from ? from + 1 : broken; // at least one character, however narrow the space is
        while (broken < whole && (static_cast<unsigned char>(*broken) & 0xC0U) == 0x80U) {
            ++broken;
        }
        if (broken < whole) {
            char const* next = broken;
            while (next < whole && isBlank(*next)) {
                ++next;
            }
            return {broken, next == whole && feed != nullptr ? feed + 1 : next};
        }
    }
    return {whole, feed == nullptr ? end : feed + 1};
}

struct LongText {
    ImDrawList& list;
    ImFont const& font;
    float size;
    ImU32 colour;
    ImVec4 clip;
    ImVec4 const* fineClip;

    void drawLine(ImVec2 at, char const* from, char const* end) const {
        while (from < end && at.x <= clip.z) {
            char const* const piece = endOfPiece(from, end);
            float const width = font.CalcTextSizeA(size, FLT_MAX, 0, from, piece).x;
            if (at.x + width + size >= clip.x) { // letters may reach beyond their width
                addTextOfImGui(&list, &font, size, at, colour, from, piece, 0, fineClip);
            }
            at.x += width;
            from = piece;
        }
    }
};

} // namespace

void addLongText(ImDrawList& list, ImFont const& font, float size, ImVec2 const& at, ImU32 colour,
                 char const* begin, char const* end, float wrapWidth, ImVec4 const* fineClip) {
    LongText text{list, font, size, colour, list._CmdHeader.ClipRect, fineClip};
    if (fineClip != nullptr) {
        text.clip = {std::max(text.clip.x, fineClip->x), std::max(text.clip.y, fineClip->y),
                     std::min(text.clip.z, fineClip->z), std::min(text.clip.w, fineClip->w)};
    }
    float const scale = size / font.FontSize;
    ImVec2 place{std::floor(at.x), std::floor(at.y)}; // as ImGui aligns letters to pixels
    while (begin < end && place.y <= text.clip.w) {
        Line const line = lineFrom(font, scale, begin, end, wrapWidth);
        if (place.y + size >= text.clip.y) {
            text.drawLine(place, begin, line.end);
        }
        begin = line.next;
        place.y += size;
    }
}

void addText(ImDrawList* list, ImFont const* font, float size, ImVec2 const& at, ImU32 colour,
             char const* begin, char const* end, float wrapWidth, ImVec4 const* fineClip) {
    if (begin != nullptr && end == nullptr) {
        end = begin + std::strlen(begin);
    }
    if (begin == nullptr || end - begin <= mostBytesAtOnce) {
        addTextOfImGui(list, font, size, at, colour, begin, end, wrapWidth, fineClip);
        return;
    }
    addLongText(*list, font == nullptr ? *list->_Data->Font : *font, size == 0 ? list->_Data->FontSize : size,
                at, colour, begin, end, wrapWidth, fineClip);
}

void addPlainText(ImDrawList* list, ImVec2 const& at, ImU32 colour, char const* begin, char const* end) {
    addText(list, nullptr, 0, at, colour, begin, end, 0, nullptr);
}

} // namespace trembler::render

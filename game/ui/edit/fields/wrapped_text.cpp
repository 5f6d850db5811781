#include "game/ui/edit/fields/wrapped_text.hpp"

#include "render/panels/theme.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace trembler::ui {
namespace {

/// The character at a place of a text, and how many bytes it has; a damaged one counts as one byte.
std::pair<std::uint32_t, std::size_t> characterAt(std::string const& text, std::size_t at) {
    auto const byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    unsigned char const first = byte(at);
    std::size_t const size = first < 0x80U    ? 1
                             : first >= 0xF0U ? 4
                             : first >= 0xE0U ? 3
                             : first >= 0xC0U ? 2
                                              : 1;
    if (size == 1 || at + size > text.size()) {
        return {first, 1};
    }
    std::uint32_t code = first & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        code = (code << 6U) | (byte(at + i) & 0x3FU);
    }
    return {code, size};
}

struct FieldState {
    float width = 0;    // pixels
    int lastCursor = 0; // in the last picture
};

float advanceOf(std::uint32_t character) {
    ImFont const& font = *ImGui::GetFont();
    return font.GetCharAdvance(static_cast<ImWchar>(character)) * ImGui::GetFontSize() / font.FontSize;
}

/// Breaks the lines again after every change, and keeps the cursor out of the middle of a break.
int keepWrapped(ImGuiInputTextCallbackData* data) {
    auto& state = *static_cast<FieldState*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackAlways) {
        bool const inside = data->CursorPos > 0 && data->CursorPos < data->BufTextLen &&
                            data->Buf[data->CursorPos - 1] == '\r' && data->Buf[data->CursorPos] == '\n';
        if (inside && !data->HasSelection()) {
            data->CursorPos += data->CursorPos < state.lastCursor ? -1 : 1; // on, the way it went
            data->SelectionStart = data->SelectionEnd = data->CursorPos;
        }
        state.lastCursor = data->CursorPos;
        return 0;
    }
    WrappedText const now{std::string(data->Buf, static_cast<std::size_t>(data->BufTextLen)),
                          static_cast<std::size_t>(data->CursorPos)};
    WrappedText const wanted = wrapLines(unwrapLines(now), state.width, advanceOf);
    if (wanted.text != now.text && wanted.text.size() < static_cast<std::size_t>(data->BufSize)) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, wanted.text.c_str());
        data->CursorPos = static_cast<int>(wanted.cursor);
        data->SelectionStart = data->SelectionEnd = data->CursorPos;
    }
    return 0;
}

} // namespace

WrappedText wrapLines(WrappedText const& plain, float width,
                      std::function<float(std::uint32_t)> const& advance) {
    WrappedText wrapped;
    std::string const& text = plain.text;
    std::size_t line = 0;  // where the present line begins in `text`
    std::size_t blank = 0; // after the last blank of the line
    float used = 0;        // by the line
    float sinceBlank = 0;  // of it after that blank
    std::vector<std::size_t> breaks;
    for (std::size_t at = 0; at < text.size();) {
        auto const [character, size] = characterAt(text, at);
        if (character == '\n') {
            line = blank = at + 1;
            used = sinceBlank = 0;
            at += size;
            continue;
        }
        float const own = advance(character);
        if (used + own > width && character != ' ' && at > line) {
            bool const atBlank = blank > line;
            line = atBlank ? blank : at;
            breaks.push_back(line);
            used = atBlank ? sinceBlank : 0;
            blank = line;
        }
        used += own;
        sinceBlank += own;
        at += size;
        if (character == ' ') {
            blank = at;
            sinceBlank = 0;
        }
    }
    wrapped.cursor = plain.cursor;
    std::size_t from = 0;
    for (std::size_t const at : breaks) {
        wrapped.text.append(text, from, at - from);
        wrapped.text += "\r\n";
        wrapped.cursor += at <= plain.cursor ? 2 : 0;
        from = at;
    }
    wrapped.text.append(text, from);
    return wrapped;
}

WrappedText unwrapLines(WrappedText const& wrapped) {
    WrappedText plain;
    std::string const& text = wrapped.text;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        bool const breaks = at + 1 < text.size() && text[at] == '\r' && text[at + 1] == '\n';
        if (at == wrapped.cursor || (breaks && at + 1 == wrapped.cursor)) {
            plain.cursor = plain.text.size();
        }
        if (at == text.size()) {
            break;
        }
        if (breaks) {
            ++at;
            if (at == wrapped.cursor) {
                plain.cursor = plain.text.size();
            }
        } else if (text[at] == '\r') { // half of a break: the position before the break is meant
            while (!plain.text.empty() && (static_cast<unsigned char>(plain.text.back()) & 0xC0U) == 0x80U) {
                plain.text.pop_back();
            }
            if (!plain.text.empty()) {
                plain.text.pop_back();
            }
            plain.cursor = std::min(plain.cursor, plain.text.size());
        } else {
            plain.text += text[at];
        }
    }
    return plain;
}

bool textArea(char const* label, std::string& text, float lines, std::size_t longest) {
    ImGuiStyle const& style = ImGui::GetStyle();
    float const whole = ImGui::GetContentRegionAvail().x;
    // Room for a scroll bar, and for rounding.
    static FieldState state; // of the one that has the keyboard, as the callback is called for no other
    state.width = whole - 2 * style.FramePadding.x - style.ScrollbarSize - render::scaled(2);
    std::string stated = text.substr(0, longest);
    std::erase(stated, '\r'); // of a file made elsewhere; here it marks a break
    std::string buffer = wrapLines({stated, 0}, state.width, advanceOf).text;
    auto const used = 1.F + static_cast<float>(std::count(buffer.begin(), buffer.end(), '\n'));
    float const height =
        std::clamp(used, lines, 2 * lines) * ImGui::GetTextLineHeight() + 2 * style.FramePadding.y;
    buffer.resize(2 * longest + 1);
    // Undoing inside of the field knows nothing of the breaks; the whole change is a step of the editor.
    ImGui::InputTextMultiline(label, buffer.data(), buffer.size(), {whole, height},
                              ImGuiInputTextFlags_CallbackEdit | ImGuiInputTextFlags_CallbackAlways |
                                  ImGuiInputTextFlags_NoUndoRedo,
                              keepWrapped, &state);
    if (std::string const now = unwrapLines({buffer.c_str(), 0}).text; now != stated) {
        text = now;
        return true;
    }
    return false;
}

} // namespace trembler::ui

#include "game/ui/edit/fields/drop_down.hpp"

#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/panels/command_palette.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "render/window/gamepad.hpp"
#include "runtime/file/lower_case.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace trembler::ui {
namespace {

using namespace render;

constexpr std::size_t longList = 9;      // entries, from which on letters narrow the list down
constexpr std::size_t longestTyped = 60; // bytes
constexpr double forgetAfter = 1;        // s without a letter, in a short list
constexpr std::size_t pageOfEntries = 10;
// Pixels at UI scale 1, of a part's picture.
constexpr float pictureSide = 28;    ///< in a list
constexpr float largestPicture = 52; ///< as it is made

bool isPrintable(SDL_Keycode key) {
    return !isPadKey(key) && key > SDLK_SPACE && key < SDLK_DELETE;
}

void eraseLetter(std::string& text) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) {
        text.pop_back(); // the rest of a letter of several bytes
    }
    if (!text.empty()) {
        text.pop_back();
    }
}

std::vector<std::size_t> fitting(std::vector<DropDown::Entry> const& all, std::string const& typed) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (typed.empty() || fitsSearch(all[i].shown + " " + all[i].id, typed)) {
            shown.push_back(i);
        }
    }
    return shown;
}

/// What was typed, above the entries of a long list; before that, that one can type.
void drawSearched(std::string const& typed, bool none) {
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(none            ? palette::warning
                                                   : typed.empty() ? palette::inkSoft
                                                                   : palette::accent));
    ImGui::TextUnformatted(typed.empty() ? words::typeToFind : (typed + "|").c_str());
    ImGui::PopStyleColor();
    ImGui::Separator();
}

/// Whether it was chosen.
bool drawEntry(EditParts& parts, DropDown::Entry const& entry, bool marked) {
    if (entry.part.empty()) {
        return ImGui::Selectable((entry.shown + "##" + entry.id).c_str(), marked);
    }
    float const side = scaled(pictureSide);
    ImVec2 const words = ImGui::CalcTextSize(entry.shown.c_str());
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const width = std::max(side + scaled(8) + words.x, ImGui::GetContentRegionAvail().x);
    bool const chosen = ImGui::Selectable(("##" + entry.id).c_str(), marked, 0, {width, side});
    if (ImGui::IsItemVisible()) { // of a long list most are scrolled out of sight
        drawPartPicture(parts, entry.part, at, side);
        ImGui::GetWindowDrawList()->AddText({at.x + side + scaled(8), at.y + 0.5F * (side - words.y)},
                                            ImGui::GetColorU32(ImGuiCol_Text), entry.shown.c_str());
    }
    return chosen;
}

} // namespace

void drawPartPicture(EditParts& parts, std::string const& part, ImVec2 at, float side) {
    auto const pixels = static_cast<int>(std::lround(scaled(largestPicture)));
    if (unsigned const picture = parts.catalog().picture(part, pixels)) {
        auto const texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture));
        ImGui::GetWindowDrawList()->AddImage(texture, at, {at.x + side, at.y + side}, {0, 1}, {1, 0});
    }
}

bool DropDown::open() const {
    return ImGui::GetFrameCount() - openIn_ <= 1;
}

bool DropDown::readLetters() {
    std::string const before = typed_;
    sinceTyped_ += static_cast<double>(ImGui::GetIO().DeltaTime);
    if (!long_ && sinceTyped_ > forgetAfter) {
        typed_.clear();
    }
    if (erased_) {
        eraseLetter(typed_);
    }
    for (ImWchar const letter : ImGui::GetIO().InputQueueCharacters) {
        bool const leadingSpace = letter == ' ' && typed_.empty();
        if (letter >= 32 && !leadingSpace && typed_.size() < longestTyped) {
            std::array<char, 5> bytes{};
            ImTextCharToUtf8(bytes.data(), letter);
            typed_ += bytes.data();
            sinceTyped_ = 0;
        }
    }
    return typed_ != before;
}

void DropDown::markFit(std::vector<Entry> const& all, std::vector<std::size_t> const& shown) {
    std::string const wanted = inLowerCase(typed_);
    auto const begins = [&](std::size_t entry) { return inLowerCase(all[entry].shown).starts_with(wanted); };
    auto const contains = [&](std::size_t entry) {
        return inLowerCase(all[entry].shown).find(wanted) != std::string::npos;
    };
    auto found = std::find_if(shown.begin(), shown.end(), begins);
    if (found == shown.end()) {
        found = std::find_if(shown.begin(), shown.end(), contains);
    }
    if (found != shown.end()) {
        marked_ = static_cast<std::size_t>(found - shown.begin());
    }
}

bool DropDown::readKeys(EditParts const& parts, std::size_t count) {
    bool chosen = false;
    auto const by = [&](long steps) {
        long const to = static_cast<long>(marked_) + steps;
        marked_ = static_cast<std::size_t>(std::clamp(to, 0L, std::max(static_cast<long>(count) - 1, 0L)));
    };
    for (SDL_Event const& event : parts.context.input.events()) {
        if (event.type != SDL_KEYDOWN || isPrintable(event.key.keysym.sym)) {
            continue; // a letter is typed, whatever the player has bound to it
        }
        auto const meaning = menuKeyOf(event.key.keysym, parts.context.keys);
        SDL_Keycode const key = event.key.keysym.sym;
        if (meaning == MenuKey::down) {
            by(1);
        } else if (meaning == MenuKey::up) {
            by(-1);
        } else if (key == SDLK_PAGEDOWN || key == SDLK_PAGEUP) {
            by(key == SDLK_PAGEDOWN ? static_cast<long>(pageOfEntries) : -static_cast<long>(pageOfEntries));
        } else if (key == SDLK_HOME || key == SDLK_END) {
            marked_ = key == SDLK_HOME || count == 0 ? 0 : count - 1;
        } else if (key == SDLK_RETURN || key == SDLK_KP_ENTER ||
                   (meaning == MenuKey::press && (key != SDLK_SPACE || typed_.empty()))) {
            chosen = event.key.repeat == 0;
        }
    }
    return chosen;
}

std::optional<std::size_t> DropDown::drawEntries(EditParts& parts, std::string const& item,
                                                 std::vector<Entry> const& all,
                                                 std::vector<std::size_t> const& shown, bool moved) {
    std::optional<std::size_t> chosen;
    for (std::size_t row = 0; row < shown.size(); ++row) {
        Entry const& entry = all[shown[row]];
        if (drawEntry(parts, entry, row == marked_)) {
            chosen = shown[row];
        }
        parts.context.layout.item(item + entry.id);
        if (moved && row == marked_ && !ImGui::IsItemVisible()) {
            ImGui::SetScrollHereY();
        }
        if (!entry.tip.empty() && ImGui::IsItemHovered()) {
            tipBeside(entry.tip);
        }
    }
    return chosen;
}

std::optional<std::size_t> DropDown::draw(EditParts& parts, std::string const& item, std::string const& shown,
                                          Entries const& entries,
                                          std::function<bool(Entry const&)> const& current) {
    std::optional<std::size_t> chosen;
    if (ImGui::BeginCombo(("##" + item).c_str(), shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        std::vector<Entry> const all = entries();
        bool const fresh = ImGui::IsWindowAppearing();
        openIn_ = ImGui::GetFrameCount();
        long_ = all.size() >= longList;
        if (fresh) {
            typed_.clear();
            auto const found = current ? std::find_if(all.begin(), all.end(), current) : all.end();
            marked_ = found == all.end() ? 0 : static_cast<std::size_t>(found - all.begin());
        }
        auto const& events = parts.context.input.events();
        erased_ = std::any_of(events.begin(), events.end(), [](SDL_Event const& event) {
            return event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_BACKSPACE;
        });
        bool const typedNow = !fresh && readLetters();
        std::vector<std::size_t> const fits = fitting(all, long_ ? typed_ : std::string());
        if (typedNow) {
            marked_ = long_ ? 0 : marked_;
            markFit(all, fits);
        }
        std::size_t const before = marked_;
        bool const entered = !fresh && readKeys(parts, fits.size());
        bool const moved = fresh || typedNow || marked_ != before;
        if (long_) {
            drawSearched(typed_, fits.empty());
        }
        chosen = drawEntries(parts, item, all, fits, moved);
        if (entered && marked_ < fits.size()) {
            chosen = fits[marked_];
        }
        if (chosen) {
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndCombo();
    }
    parts.context.layout.item(item);
    return chosen;
}

void placeTipBeside() {
    ImVec2 const list = ImGui::GetWindowPos();
    float const width = ImGui::GetWindowSize().x;
    float const gap = scaled(6);
    bool const left = list.x > ImGui::GetIO().DisplaySize.x - list.x - width;
    ImGui::SetNextWindowPos({left ? list.x - gap : list.x + width + gap, ImGui::GetItemRectMin().y},
                            ImGuiCond_Always, {left ? 1.F : 0.F, 0.F});
}

void tipBeside(std::string const& text) {
    placeTipBeside();
    ImGui::SetTooltip("%s", words::wrapped(text, 44).c_str());
}

} // namespace trembler::ui

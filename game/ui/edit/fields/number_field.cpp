#include "game/ui/edit/fields/number_field.hpp"

#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/edit/edit_words.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace trembler::ui {
namespace {

constexpr int digitsToType = 9;     // all that files state of usual lengths
constexpr int digitsOfDrag = 5;     // a drag makes round numbers
constexpr double hundredths = 1000; // below this, multiples of 0.01
constexpr float tipAfter = 0.5F;    // s over a field
constexpr double sameToType = 1e-8; // relative

std::string inDigits(double value, int digits, bool whole) {
    std::array<char, 64> text{};
    if (whole) {
        std::snprintf(text.data(), text.size(), "%.0f", value);
    } else {
        std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    }
    return text.data();
}

std::string withUnit(std::string const& number, std::string const& unit) {
    return unit.empty() ? number : number + (unit.starts_with("°") ? "" : " ") + unit;
}

float dragSpeed(double value) {
    return static_cast<float>(std::clamp(0.01 * std::abs(value), 0.005, 1e6));
}

/// The number with its unit or, where that is too wide, without it, or with fewer digits.
std::string fittedNumber(double value, std::string const& unit, bool whole, float room) {
    std::string shown = withUnit(inDigits(value, digitsOfDrag, whole), unit);
    for (int digits = digitsOfDrag; digits > 0 && ImGui::CalcTextSize(shown.c_str()).x > room; --digits) {
        shown = inDigits(value, digits, whole);
    }
    return shown;
}

/// Dear ImGui rounds a dragged number to what its format shows.
std::string formatOfDrag(double value) {
    return std::abs(value) < hundredths ? "%.2f" : "%." + std::to_string(digitsOfDrag) + "g";
}

void numberTipOf(double value, std::string const& unit, bool whole, std::string const& shown) {
    ImGuiContext const& context = *ImGui::GetCurrentContext();
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive() || context.HoveredIdTimer < tipAfter) {
        return;
    }
    std::string const full = withUnit(inDigits(value, digitsToType, whole), unit);
    ImGui::SetTooltip("%s%s%s", full == shown ? "" : full.c_str(), full == shown ? "" : "\n",
                      words::numberTip);
}

} // namespace

bool numberField(EditParts& parts, std::string const& item, double& value, double low, double high,
                 std::string const& unit, bool whole) {
    // ImGui's drags take no ranges beyond half of all numbers.
    low = std::max(low, -1e300);
    high = std::min(high, 1e300);
    std::string const label = "##" + item;
    ImGuiID const id = ImGui::GetID(label.c_str());
    bool const typing = ImGui::TempInputIsActive(id);
    bool const dragging = ImGui::GetActiveID() == id && ImGui::IsMouseDown(ImGuiMouseButton_Left) && !typing;
    std::string const format = whole      ? "%.0f"
                               : dragging ? formatOfDrag(value)
                                          : "%." + std::to_string(digitsToType) + "g";
    ImU32 const colour = ImGui::GetColorU32(ImGuiCol_Text);
    if (!typing) { // the field draws its text itself, cut; ours is drawn over it
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
    }
    double const before = value;
    bool changed =
        ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &value, whole ? 0.05F : dragSpeed(value), &low,
                          &high, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    if (!typing) {
        ImGui::PopStyleColor();
    }
    parts.context.layout.item(item);
    if (ImGui::IsItemActivated()) { // each use of a widget is a gesture of its own
        parts.widget = {parts.document.newGesture(), edit::Gesture::Next::replaces};
    }
    if (whole) {
        value = std::round(value);
    }
    // Text that says the same in fewer digits is no change.
    if (changed && typing && std::abs(value - before) <= sameToType * std::abs(before)) {
        value = before;
        changed = false;
    }
    if (!typing) {
        float const padding = ImGui::GetStyle().FramePadding.x;
        ImVec2 const corner = ImGui::GetItemRectMin();
        ImVec2 const opposite = ImGui::GetItemRectMax();
        std::string const shown = fittedNumber(value, unit, whole, opposite.x - corner.x - padding);
        ImVec2 const size = ImGui::CalcTextSize(shown.c_str());
        ImGui::GetWindowDrawList()->AddText({std::round(0.5F * (corner.x + opposite.x - size.x)),
                                             std::round(0.5F * (corner.y + opposite.y - size.y))},
                                            colour, shown.c_str());
        numberTipOf(value, unit, whole, shown);
    }
    return changed;
}

} // namespace trembler::ui

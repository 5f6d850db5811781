#include "game/ui/play/whatif/what_if_fields.hpp"

#include "game/ui/play/whatif/what_if_words.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Change;
using insight::SettableField;

constexpr float whatIfName = 132;  ///< width of the names of fields, pixels at UI scale 1
constexpr double dragShare = 0.01; ///< of a number, for each pixel

/// A widget for the field; true while the player changes the amount.
bool fieldWidgetOf(SettableField const& field, insight::FieldAmount& amount) {
    double const turned = field.unit.starts_with("rad") ? 180 / pi : 1;
    std::string const unit =
        turned != 1 ? "°" + field.unit.substr(3) : (field.unit.empty() ? "" : " " + field.unit);
    std::string format = "%.4g";
    for (char const c : unit) {
        format += c == '%' ? std::string("%%") : std::string(1, c);
    }
    auto const number = [&](char const* id, double& value) {
        double shown = value * turned;
        double const low = field.least * turned;
        double const high = field.most * turned;
        auto const speed = static_cast<float>(std::clamp(dragShare * std::abs(shown), 0.01, 1e6));
        bool const changed = ImGui::DragScalar(id, ImGuiDataType_Double, &shown, speed, &low, &high,
                                               format.c_str(), ImGuiSliderFlags_AlwaysClamp);
        if (changed) {
            value = shown / turned;
        }
        return changed;
    };
    switch (field.type) {
    case FieldType::boolean: {
        bool on = amount.x != 0;
        bool const changed = checkBox("##on", &on);
        amount.x = on ? 1 : 0;
        return changed;
    }
    case FieldType::choice: {
        bool changed = false;
        auto const now = static_cast<std::size_t>(amount.x);
        auto const inWords = [&](std::size_t i) {
            return i < field.choices.size() ? spokenField(std::string(field.choices[i])) : std::string();
        };
        if (ImGui::BeginCombo("##choice", inWords(now).c_str())) {
            for (std::size_t i = 0; i < field.choices.size(); ++i) {
                if (ImGui::Selectable(inWords(i).c_str(), i == now) && i != now) {
                    amount.x = static_cast<double>(i);
                    changed = true;
                }
            }
            ImGui::EndCombo();
        }
        return changed;
    }
    case FieldType::vector: {
        ImGui::SetNextItemWidth(0.5F * ImGui::GetContentRegionAvail().x - scaled(2));
        bool const x = number("##x", amount.x);
        ImGui::SameLine(0, scaled(4));
        ImGui::SetNextItemWidth(-1);
        return number("##y", amount.y) || x;
    }
    default:
        return number("##number", amount.x);
    }
}

} // namespace

void drawWhatIfFields(Layout& layout, WhatIfView& view, std::string const& object) {
    ImGui::PushFont(theme().fonts.strong);
    ImGui::TextWrapped("%s", shownName(object).c_str());
    ImGui::PopFont();
    for (SettableField const& field : view.fieldsOf(object)) {
        std::string const property(field.property->text.key);
        std::string const name = field.key == "value" ? translated(std::string(field.property->text.name))
                                                      : spokenField(field.key);
        std::string const item = "set " + property + "." + field.key;
        ImGui::PushID(item.c_str());
        float const left = ImGui::GetCursorPosX();
        ImGui::AlignTextToFramePadding();
        ImGui::PushTextWrapPos(left + scaled(whatIfName - 6));
        ImGui::TextUnformatted(name.c_str());
        ImGui::PopTextWrapPos();
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", translated(std::string(field.property->text.name)).c_str());
        }
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + scaled(whatIfName));
        ImGui::SetNextItemWidth(-1);
        insight::FieldAmount amount = field.now;
        if (fieldWidgetOf(field, amount)) {
            view.change({.kind = Change::Kind::field,
                         .object = object,
                         .property = property,
                         .field = field.key,
                         .amount = amount});
        }
        if (ImGui::IsItemVisible()) {
            layout.item(item);
        }
        ImGui::PopID();
    }
}

} // namespace trembler::ui

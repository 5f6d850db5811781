#include "game/ui/shared/parameter_widgets.hpp"

#include "game/ui/shared/readable_number.hpp"
#include "game/ui/shared/words.hpp"
#include "lua/attach/parameter_value.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float nameShare = 0.36F; // of the line

bool hasRange(lua::Parameter const& parameter) {
    return parameter.minimum > -1e300 && parameter.maximum < 1e300;
}

/// Its unit behind the number, as ImGui formats numbers: a per cent sign is written twice.
std::string formatWith(std::string const& unit) {
    std::string format = "%.4g";
    if (!unit.empty()) {
        format += unit.starts_with("°") ? "" : " ";
        for (char const c : unit) {
            format += c == '%' ? std::string("%%") : std::string(1, c);
        }
    }
    return format;
}

bool numberWidget(lua::Parameter const& parameter, double& number) {
    std::string const format = formatWith(parameter.unit);
    if (hasRange(parameter)) {
        // Over three powers of ten, or from zero to thousands, equal lengths of the slider are equal factors.
        bool const wide = parameter.minimum >= 0 &&
                          parameter.maximum >= 1000 * (parameter.minimum > 0 ? parameter.minimum : 1);
        return ImGui::SliderScalar("##number", ImGuiDataType_Double, &number, &parameter.minimum,
                                   &parameter.maximum, format.c_str(),
                                   ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0));
    }
    double const low = parameter.minimum;
    double const high = parameter.maximum;
    auto const speed = static_cast<float>(std::clamp(0.01 * std::abs(number), 0.01, 1e6));
    return ImGui::DragScalar("##number", ImGuiDataType_Double, &number, speed, &low, &high, format.c_str(),
                             ImGuiSliderFlags_AlwaysClamp);
}

bool textWidget(lua::Parameter const& parameter, std::string& text) {
    if (parameter.choices.empty()) {
        std::string buffer = text;
        buffer.resize(lua::longestText + 1);
        if (!ImGui::InputText("##text", buffer.data(), buffer.size(), ImGuiInputTextFlags_EnterReturnsTrue)) {
            return false;
        }
        text = buffer.c_str();
        return true;
    }
    bool chosen = false;
    if (ImGui::BeginCombo("##choice", text.c_str())) {
        for (std::string const& choice : parameter.choices) {
            if (ImGui::Selectable(choice.c_str(), choice == text)) {
                text = choice;
                chosen = true;
            }
        }
        ImGui::EndCombo();
    }
    return chosen;
}

bool widgetFor(lua::Parameter const& parameter, lua::Value& value) {
    if (double* const number = std::get_if<double>(&value)) {
        return numberWidget(parameter, *number);
    }
    if (bool* const on = std::get_if<bool>(&value)) {
        return render::checkBox("##on", on);
    }
    if (Vec2* const vector = std::get_if<Vec2>(&value)) {
        std::array<double, 2> parts{vector->x, vector->y};
        bool const touched = ImGui::DragScalarN("##vector", ImGuiDataType_Double, parts.data(), 2, 0.02F,
                                                nullptr, nullptr, formatWith(parameter.unit).c_str());
        *vector = {parts[0], parts[1]};
        return touched;
    }
    return textWidget(parameter, std::get<std::string>(value));
}

} // namespace

std::string spokenName(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string valueInWords(lua::Value const& value) {
    if (double const* const number = std::get_if<double>(&value)) {
        return readable(*number);
    }
    if (bool const* const on = std::get_if<bool>(&value)) {
        return *on ? words::yes : words::no;
    }
    if (Vec2 const* const vector = std::get_if<Vec2>(&value)) {
        return readable(vector->x) + ", " + readable(vector->y);
    }
    return std::get<std::string>(value);
}

std::optional<lua::Value> parameterWidget(Layout& layout, lua::Parameter const& parameter,
                                          lua::Value const& value, std::string const& item) {
    float const width = ImGui::GetContentRegionAvail().x;
    float const left = ImGui::GetCursorPosX();
    ImGui::PushID(item.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
    ImGui::PushTextWrapPos(left + nameShare * width - scaled(6));
    ImGui::TextUnformatted(spokenName(parameter.name).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    auto const tip = [&] {
        if (!parameter.text.empty() && ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", words::wrapped(parameter.text, 60).c_str());
        }
    };
    tip();
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + nameShare * width);
    ImGui::SetNextItemWidth((1 - nameShare) * width);
    lua::Value changed = value;
    bool const touched = widgetFor(parameter, changed);
    layout.item(item);
    tip();
    ImGui::PopID();
    return touched && !lua::faultOf(parameter, changed) ? std::optional(std::move(changed)) : std::nullopt;
}

} // namespace trembler::ui

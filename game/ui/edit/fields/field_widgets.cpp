#include "game/ui/edit/fields/field_widgets.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/fields/wrapped_text.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

constexpr float shareOfName = 0.38F;

/// Whether a place inside a property is that of an entry of a list, which has a value or does not exist.
bool isListEntry(std::string const& place) {
    std::string const token = place.substr(place.rfind('/') + 1);
    return !token.empty() && token.find_first_not_of("0123456789") == std::string::npos;
}

double numberOf(Json const& value) {
    return value.is_number() ? value.get<double>() : 0;
}

} // namespace

std::string shownChoice(std::string const& choice) {
    return text(choice);
}

std::string shownField(std::string const& name) {
    std::string key = name;
    if (!key.empty() && key.front() >= 'A' && key.front() <= 'Z') {
        key.front() = static_cast<char>(key.front() - 'A' + 'a');
    }
    std::string const known = text(key); // of the field "lower limit"
    return known == key ? std::string(text(name)) : words::capital(known);
}

void fieldName(std::string const& name, std::string const& help) {
    float const width = ImGui::GetContentRegionAvail().x;
    float const left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
    ImGui::PushTextWrapPos(left + shareOfName * width - scaled(4));
    ImGui::TextUnformatted(name.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    if (!help.empty() && ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", words::wrapped(help, 60).c_str());
    }
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + shareOfName * width);
    ImGui::SetNextItemWidth((1 - shareOfName) * width);
}

bool committedText(EditParts& parts, std::string const& item, std::string& text, float lines) {
    auto typed = parts.typed.find(item);
    std::string shown = typed != parts.typed.end() ? typed->second : text;
    std::string const label = "##" + item;
    bool entered = false;
    if (lines > 1) {
        textArea(label.c_str(), shown, lines);
    } else {
        entered = textField(label.c_str(), shown, 400, true);
    }
    parts.context.layout.item(item);
    bool const active = ImGui::IsItemActive();
    if (active) {
        // Another field may have been left for this one and be drawn after it, so each has a text of its own.
        typed = parts.typed.insert_or_assign(item, shown).first;
    }
    bool const left = entered || ImGui::IsItemDeactivated();
    if (typed == parts.typed.end() || (active && !entered)) {
        return false;
    }
    parts.typed.erase(typed);
    if (!left || shown == text) {
        return false;
    }
    text = shown;
    return true;
}

bool choiceField(EditParts& parts, std::string const& item, std::string& chosen,
                 std::vector<std::string> const& choices,
                 std::function<std::string(std::string const&)> const& inWords, char const* none) {
    auto const shown = [&](std::string const& choice) {
        return choice.empty() ? std::string(none) : inWords ? inWords(choice) : choice;
    };
    auto const entries = [&] {
        std::vector<DropDown::Entry> all;
        for (std::string const& choice : choices) {
            all.push_back({shown(choice), " = " + choice, {}});
        }
        return all;
    };
    auto const now = parts.dropDown.draw(parts, item, shown(chosen), entries,
                                         [&](auto const& entry) { return entry.id == " = " + chosen; });
    if (!now || choices[*now] == chosen) {
        return false;
    }
    chosen = choices[*now];
    return true;
}

std::optional<Json> fieldWidget(EditParts& parts, edit::InspectedField const& field,
                                std::string const& item) {
    std::string help = text(field.help);
    if (field.mixed) {
        help += std::string(help.empty() ? "" : "\n") + words::severalValues;
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::warning));
    }
    fieldName(shownField(field.name), help);
    std::optional<Json> result;
    switch (field.type) {
    case FieldType::boolean: {
        bool on = field.value.is_boolean() && field.value.get<bool>();
        if (render::checkBox(("##" + item).c_str(), &on)) {
            result = on;
        }
        parts.context.layout.item(item);
        break;
    }
    case FieldType::integer:
    case FieldType::number: {
        double value = numberOf(field.value);
        bool const whole = field.type == FieldType::integer;
        if (numberField(parts, item, value, field.minimum, field.maximum, field.unit, whole)) {
            result = whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
        }
        break;
    }
    case FieldType::vector: {
        std::array<double, 2> value{};
        if (field.value.is_array() && field.value.size() == 2) {
            value = {numberOf(field.value[0]), numberOf(field.value[1])};
        }
        float const half = 0.5F * (ImGui::GetContentRegionAvail().x - scaled(4));
        ImGui::SetNextItemWidth(half);
        bool changed = numberField(parts, item + " x", value[0], field.minimum, field.maximum, field.unit);
        ImGui::SameLine(0, scaled(4));
        ImGui::SetNextItemWidth(half);
        changed =
            numberField(parts, item + " y", value[1], field.minimum, field.maximum, field.unit) || changed;
        if (changed) {
            result = Json::array({value[0], value[1]});
        }
        break;
    }
    case FieldType::text: {
        std::string text = field.value.is_string() ? field.value.get<std::string>() : "";
        if (committedText(parts, item, text)) {
            result = text;
        }
        break;
    }
    case FieldType::object:
    case FieldType::choice: {
        std::string chosen = field.value.is_string() ? field.value.get<std::string>() : "";
        bool const named = field.type == FieldType::object; // names of objects are the designer's
        std::vector<std::string> choices = field.choices;
        if (named && !field.required && !field.place.empty() && !isListEntry(field.place)) {
            choices.insert(choices.begin(), ""); // none, as the world for a joint
        }
        if (choiceField(parts, item, chosen, choices, named ? nullptr : shownChoice)) {
            result = chosen.empty() ? Json() : Json(chosen);
        }
        break;
    }
    case FieldType::list:
        ImGui::NewLine();
        break;
    }
    if (field.mixed) {
        ImGui::PopStyleColor();
    }
    return result;
}

bool isContinuous(edit::InspectedField const& field) {
    return field.type == FieldType::number || field.type == FieldType::integer ||
           field.type == FieldType::vector;
}

void runWidget(EditParts& parts, std::function<edit::Command(Json const&)> const& make, bool continuous) {
    std::vector<std::string> const selected = parts.selected();
    EntryKind const kind = parts.selection.kind();
    std::string const path = parts.selection.path();
    parts.run(make, continuous && parts.widget.number != 0 ? std::optional(parts.widget) : std::nullopt);
    // A property is changed, not another thing chosen.
    if (kind == EntryKind::none) {
        parts.selection.set(selected);
    } else {
        parts.selection.choose(kind, path);
    }
}

std::optional<Area> areaFields(EditParts& parts, Area const& area, std::string const& item) {
    Area changed = area;
    bool touched = false;
    auto const pair = [&](char const* name, std::string const& what, Vec2& value, double low) {
        fieldName(name, "");
        float const half = 0.5F * (ImGui::GetContentRegionAvail().x - scaled(4));
        ImGui::SetNextItemWidth(half);
        touched = numberField(parts, item + " " + what + " x", value.x, low, 1e6, "m") || touched;
        ImGui::SameLine(0, scaled(4));
        ImGui::SetNextItemWidth(half);
        touched = numberField(parts, item + " " + what + " y", value.y, low, 1e6, "m") || touched;
    };
    if (changed.box) {
        pair(words::cornerField, "corner", changed.box->corner, -1e6);
        pair(words::sizeField, "size", changed.box->size, 0.001);
    }
    std::optional<std::size_t> removed;
    bool const many = changed.corners.size() > 3;
    for (std::size_t i = 0; i < changed.corners.size(); ++i) {
        std::string const number = std::to_string(i);
        pair(words::cornerField, number, changed.corners[i], -1e6);
        if (many && smallButton(parts, words::removeIt, item + " " + number + " remove")) {
            removed = i;
        }
    }
    bool const added = !changed.corners.empty() && smallButton(parts, words::addEntry, item + " add");
    if (removed || added) {
        parts.widget = {parts.document.newGesture(), edit::Gesture::Next::replaces};
        touched = true;
    }
    if (removed) {
        changed.corners.erase(changed.corners.begin() + static_cast<std::ptrdiff_t>(*removed));
    } else if (added) { // where it changes nothing yet
        changed.corners.push_back(0.5 * (changed.corners.front() + changed.corners.back()));
    }
    return touched ? std::optional(changed) : std::nullopt;
}

} // namespace trembler::ui

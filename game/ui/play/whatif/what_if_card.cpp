#include "game/ui/play/whatif/what_if_card.hpp"

#include "game/ui/cards/play_cards.hpp"
#include "game/ui/play/whatif/what_if_words.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"
#include "runtime/component/info.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Change;
using insight::SettableField;

// Pixels at UI scale 1.
constexpr float whatIfWidth = 300;
constexpr float whatIfList = 132; ///< height of what scrolls, if there is room
constexpr float leastList = 64;
constexpr float whatIfRest = 182;  ///< height of the rest of the card, and a gap
constexpr float whatIfName = 132;  ///< of fields
constexpr double dragShare = 0.01; ///< of a number, for each pixel

std::string secondsAt(std::uint64_t frame) {
    return textWith("{:.2Lf} s", static_cast<double>(frame) / 60);
}

/// The interactions that are at work, or would be.
std::vector<std::string> interactionsOf(Session const& session) {
    std::vector<std::string> all;
    for (ComponentStatus const& status : session.world().status()) {
        if (status.info->kind == ComponentKind::interaction && status.activity != Activity::absent) {
            all.push_back(title(*status.info));
        }
    }
    return all;
}

std::optional<std::size_t> placeOfChange(insight::WhatIf const& whatIf, Change::Kind kind,
                                         std::string const& object) {
    for (std::size_t i = 0; i < whatIf.changes.size(); ++i) {
        if (whatIf.changes[i].kind == kind && (object.empty() || whatIf.changes[i].object == object)) {
            return i;
        }
    }
    return std::nullopt;
}

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

void drawFields(Layout& layout, WhatIfView& view, std::string const& object) {
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

void drawLeavingOut(Layout& layout, Session const& session, WhatIfView& view) {
    std::vector<std::size_t> later; // what the hands did after the moment
    for (std::size_t i = 0; i < session.inputs().size(); ++i) {
        RecordedInput const& input = session.inputs()[i];
        bool const begins = input.kind != PlayerInput::Kind::move && input.kind != PlayerInput::Kind::release;
        if (input.frame > view.moment() && begins) {
            later.push_back(i);
        }
    }
    auto const hands = placeOfChange(view.whatIf(), Change::Kind::input, "");
    if (!later.empty()) {
        bool without = hands.has_value();
        if (checkBox(text("Without what the hand does then"), &without)) {
            if (without) {
                view.leaveOut(later);
            } else if (hands) {
                view.takeBack(*hands);
            }
        }
        layout.item("without hands");
    }
    if (!ImGui::TreeNodeEx("without", ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
                           text("Leave out an effect"))) {
        if (ImGui::IsItemVisible()) {
            layout.item("leave out");
        }
        return;
    }
    if (ImGui::IsItemVisible()) {
        layout.item("leave out");
    }
    std::vector<std::string> all = interactionsOf(session);
    for (std::string const& each : all) {
        auto const place = placeOfChange(view.whatIf(), Change::Kind::interaction, each);
        bool without = place.has_value();
        if (checkBox((translated(each) + "##" + each).c_str(), &without)) {
            if (without) {
                view.change({.kind = Change::Kind::interaction, .object = each});
            } else {
                view.takeBack(*place);
            }
        }
        if (ImGui::IsItemVisible()) {
            layout.item("without " + each);
        }
    }
}

void drawChanges(Layout& layout, Session const& session, WhatIfView& view) {
    std::optional<std::size_t> back;
    bool hands = false; // what they do is one line, however much it is
    for (std::size_t i = 0; i < view.whatIf().changes.size(); ++i) {
        Change const& change = view.whatIf().changes[i];
        if (change.kind == Change::Kind::input && std::exchange(hands, true)) {
            continue;
        }
        std::string const item = "take back " + std::to_string(i);
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton("×")) {
            back = i;
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", text("Take this back"));
        }
        if (ImGui::IsItemVisible()) {
            layout.item(item);
        }
        ImGui::SameLine(0, scaled(6));
        ImGui::TextWrapped("%s", wordsOf(change, session.world()).c_str());
        ImGui::PopID();
    }
    if (back) {
        view.takeBack(*back);
    }
}

std::string outcome(WhatIfView const& view) {
    insight::OtherRun const* const run = view.run();
    if (run == nullptr || view.whatIf().changes.empty()) {
        return "";
    }
    std::string words = run->firstDifference()
                            ? textWith("Another run from {} on.", secondsAt(*run->firstDifference()))
                            : std::string(text("No difference so far."));
    std::size_t met = 0;
    for (GoalStatus const& goal : run->goals()) {
        met += goal.frame ? 1U : 0U;
    }
    if (!run->goals().empty()) {
        words += " " + textWith("Goals reached in it: {} of {}", met, run->goals().size());
    }
    if (run->solvedFrame()) {
        words += " (" + secondsAt(*run->solvedFrame()) + ")";
    }
    return words;
}

} // namespace

void drawWhatIfCard(CommandButtons& buttons, Session const& session, WhatIfView& view, WhatIfTool const& tool,
                    float above) {
    Layout& layout = buttons.layout();
    std::string const heading = textWith("What if, at {}", secondsAt(view.moment()));
    layout.beginCard("what if", heading.c_str(),
                     {.anchor = Anchor::BottomLeft, .offset = {cardGap, above}, .width = whatIfWidth});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    float const screen = ImGui::GetIO().DisplaySize.y / theme().scale;
    float const room = std::clamp(screen - above - whatIfRest, leastList, whatIfList);
    ImGui::BeginChild("changes", {0, scaled(room)});
    if (view.whatIf().changes.empty()) {
        caption(text("Drag, turn or remove something, pull it with the second hand, or cut a wire."));
    }
    drawChanges(layout, session, view);
    if (!view.atMoment()) {
        caption(text("Only at its moment can something be changed."));
    } else {
        if (!tool.chosen().empty()) {
            drawFields(layout, view, tool.chosen());
        }
        drawLeavingOut(layout, session, view);
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    if (std::string const words = outcome(view); !words.empty()) {
        ImGui::PushFont(theme().fonts.small);
        caption(words.c_str());
        ImGui::PopFont();
    }
    if (!view.atMoment()) {
        if (bigButton(text("To its moment"), {.width = 128})) {
            view.toMoment();
        }
        layout.item("what if moment");
    } else if (view.whatIf().changes.empty() && !view.kept().empty()) {
        if (bigButton(text("The last one"), {.width = 128})) {
            view.again(view.kept().size() - 1);
        }
        layout.item("what if again");
    }
    layout.endCard();
}

} // namespace trembler::ui

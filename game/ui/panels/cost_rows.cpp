#include "game/ui/panels/cost_rows.hpp"

#include "game/ui/panels/attempt.hpp"
#include "game/ui/panels/time_bar.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {

using namespace render;

namespace {

void tip(std::string const& text) {
    if (!text.empty() && ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", words::wrapped(text, 60).c_str());
    }
}

/// Draws a time (µs) as a bar relative to `scale`; `limit` draws the line of the budget.
void timeBar(double microseconds, double scale, double limit, bool grey) {
    auto const share = [&](double time) {
        return scale > 0 ? std::clamp(static_cast<float>(time / scale), 0.F, 1.F) : 0.F;
    };
    drawTimeBar({.share = share(microseconds),
                 .limit = share(limit),
                 .over = limit > 0 && microseconds > limit,
                 .text = grey ? words::nothingStated : words::duration(microseconds),
                 .grey = grey,
                 .half = 5,
                 .numbers = 62,
                 .framed = true});
}

/// Lists the other options of an effect, in its unfolded knob.
void drawOptions(Layout& layout, Session& session, Toasts& toasts, budget::Knob const& knob) {
    if (session.mode() == SessionMode::building || knob.options.size() < 2) {
        return; // settings and estimates need a running world
    }
    ImGui::Separator();
    ImGui::PushFont(theme().fonts.small);
    for (std::size_t i = 0; i < knob.options.size(); ++i) {
        budget::Option const& option = knob.options[i];
        if (option.lessOften && i != knob.current) {
            continue; // the period of a component has a knob of its own
        }
        std::string const label = translated(option.name) + "  ·  " + words::howFarOff(option.error.metres);
        ImGui::BeginDisabled(!option.cannot.empty() && i != knob.current);
        if (ImGui::Selectable(label.c_str(), i == knob.current)) {
            attempt(toasts, [&] {
                for (RecordedChange const& change : option.makes) {
                    session.change(change);
                }
            });
        }
        ImGui::EndDisabled();
        layout.item("option " + option.name);
    }
    ImGui::PopFont();
}

} // namespace

std::string switchBudget(budget::BudgetMode& mode) {
    if (mode.budget()) {
        mode.setBudget(std::nullopt);
        return words::budgetOff;
    }
    constexpr double usual = 2000; // µs: leaves a 60 Hz display enough time to draw
    mode.setBudget(usual);
    return words::budgetIs(usual);
}

std::string changeBudget(budget::BudgetMode& mode, double factor) {
    double const now = mode.budget().value_or(2000);
    mode.setBudget(std::clamp(now * factor, 1000.0 * static_cast<double>(leastBudget),
                              1000.0 * static_cast<double>(mostBudget)));
    return words::budgetIs(*mode.budget());
}

void CostRows::drawBudget(Layout& layout, budget::BudgetMode& mode) {
    bool on = mode.budget().has_value();
    if (on) {
        wanted_ = static_cast<float>(*mode.budget() / 1000);
    }
    ImGui::AlignTextToFramePadding();
    if (render::checkBox(words::keepToBudget, &on)) {
        mode.setBudget(on ? std::optional(1000.0 * static_cast<double>(wanted_)) : std::nullopt);
    }
    layout.item("budget");
    tip(tips_.budget);
    ImGui::SameLine(0, scaled(16));
    ImGui::BeginDisabled(!on);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - scaled(92));
    if (ImGui::SliderFloat("##budget", &wanted_, leastBudget, mostBudget, "",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp |
                               ImGuiSliderFlags_NoRoundToFormat) &&
        on) {
        mode.setBudget(1000.0 * static_cast<double>(wanted_));
    }
    ImGui::EndDisabled();
    layout.item("budget of a frame");
    tip(tips_.slider);
    ImGui::SameLine(0, scaled(10));
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(on ? palette::ink : palette::inkSoft));
    ImGui::TextUnformatted(words::budgetOf(static_cast<double>(wanted_)).c_str());
    ImGui::PopStyleColor();
    drawStatus(mode);
}

void CostRows::drawStatus(budget::BudgetMode const& mode) const {
    if (!mode.budget()) {
        return;
    }
    ImGui::PushFont(theme().fonts.small);
    bool const known = mode.figures().frame > 0;
    if (known && !mode.kept()) {
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::warning));
        ImGui::TextWrapped("%s", mode.hopeless() ? words::budgetHopeless : words::budgetMissed);
        ImGui::PopStyleColor();
    }
    if (mode.decisions().empty()) {
        caption(known ? words::nothingToChange : words::budgetMeasuring);
    }
    // All decisions of the last frame that had any.
    for (budget::Decision const& decision : mode.decisions()) {
        if (decision.frame == mode.decisions().back().frame) {
            caption(translated(inWords(decision)).c_str());
        }
    }
    ImGui::PopFont();
}

void CostRows::drawRow(Layout& layout, Session& session, budget::BudgetMode const& mode, Toasts& toasts,
                       EffectCost const& cost, double scale) {
    bool const absent = cost.activity == Activity::absent;
    bool const idle = cost.activity != Activity::active;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(idle ? palette::inkSoft : palette::ink));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words::capital(translated(cost.effect)).c_str());
    ImGui::PopStyleColor();
    tip(session.world().why(cost.effect).empty() ? std::string()
                                                 : words::sceneNeeds(session.world().why(cost.effect)));

    ImGui::TableNextColumn();
    auto const effect = std::find_if(levels_.begin(), levels_.end(),
                                     [&](EffectLevels const& l) { return l.effect == cost.effect; });
    budget::Knob const* const knob = mode.knob(cost.effect);
    if (effect == levels_.end()) {
        ImGui::AlignTextToFramePadding();
        caption(absent ? cost.reason.c_str() : words::oneWayOnly);
    } else if (absent && effect->chosen.empty()) {
        ImGui::AlignTextToFramePadding();
        caption(cost.reason.c_str());
    } else {
        std::string const automatic = effect->working.empty()
                                          ? std::string(words::automatic)
                                          : words::automaticNow(translated(effect->working));
        // The chosen level is not used because the scene does not need it; another level does the work.
        bool const elsewhere =
            !effect->chosen.empty() && !effect->working.empty() && effect->working != effect->chosen;
        std::string const asked =
            elsewhere ? words::idleNow(translated(effect->chosen), translated(effect->working))
                      : translated(effect->chosen);
        std::string shown = effect->chosen.empty() ? automatic : asked;
        if (knob != nullptr && !elsewhere && (cost.effect == "dynamics" || !effect->chosen.empty())) {
            shown = translated(knob->options[knob->current].name);
            if (cost.effect == "dynamics") {
                shown = translated(effect->working.empty() ? effect->chosen : effect->working) + ", " + shown;
            }
        }
        ImGui::SetNextItemWidth(-1);
        if (!ImGui::BeginCombo(("##" + cost.effect).c_str(), shown.c_str(), ImGuiComboFlags_HeightLarge)) {
            layout.item("detail of " + cost.effect);
            std::string const why = session.world().why(cost.effect);
            tip(shown + (why.empty() ? "" : ". " + words::sceneNeeds(why)));
        } else {
            if (ImGui::Selectable(automatic.c_str(), effect->chosen.empty())) {
                attempt(toasts, [&] { session.setDetail(cost.effect, ""); });
            }
            layout.item("as needed");
            for (std::string const& level : effect->levels) {
                auto const whyNot = session.whyNotDetail(cost.effect, level);
                ImGui::BeginDisabled(whyNot.has_value());
                if (ImGui::Selectable(translated(level).c_str(), level == effect->chosen)) {
                    attempt(toasts, [&] { session.setDetail(cost.effect, level); });
                }
                ImGui::EndDisabled();
                if (whyNot && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
                    ImGui::SetTooltip("%s", words::wrapped(translated(*whyNot), 60).c_str());
                }
                layout.item("level " + level);
            }
            if (knob != nullptr) {
                drawOptions(layout, session, toasts, *knob);
            }
            ImGui::EndCombo();
        }
    }

    ImGui::TableNextColumn();
    timeBar(idle ? 0 : cost.microseconds, scale, 0, idle);
    layout.item("time of " + cost.effect);
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(idle ? palette::inkSoft : palette::ink));
    if (idle) {
        ImGui::TextUnformatted(absent ? words::absent : words::asleep);
    } else if (knob != nullptr) {
        budget::Error const& error = knob->options[knob->current].error;
        ImGui::TextUnformatted(words::howFarOff(error.metres).c_str());
        tip(words::errorTip(error.metres, error.share, knob->of, knob->source));
        layout.item("error of " + cost.effect);
    }
    ImGui::PopStyleColor();
}

void CostRows::drawRows(Layout& layout, Session& session, budget::BudgetMode const& mode, Toasts& toasts,
                        bool all) {
    levels_ = effectLevels(session.world());
    auto const costs = effectCosts(session.world(), mode);
    double total = 0;
    for (EffectCost const& cost : costs) {
        total += cost.activity == Activity::active ? cost.microseconds : 0;
    }
    double const limit = mode.budget().value_or(0);
    double const scale = std::max(total, limit);
    ImGui::PushFont(theme().fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(scaled(4), scaled(1)));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(6), scaled(2)));
    if (ImGui::BeginTable("costs", 4, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthStretch, 0.17F);
        ImGui::TableSetupColumn("level", ImGuiTableColumnFlags_WidthStretch, 0.38F);
        ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthStretch, 0.29F);
        ImGui::TableSetupColumn("error", ImGuiTableColumnFlags_WidthStretch, 0.16F);
        ImGui::TableNextRow();
        for (char const* heading :
             {words::effect, words::howExactly, words::timePerFrameOf, words::errorAfterASecond}) {
            ImGui::TableNextColumn();
            caption(heading);
        }
        for (EffectCost const& cost : costs) {
            bool const hidden = cost.activity == Activity::absent && !all;
            bool const stated = std::any_of(levels_.begin(), levels_.end(), [&](EffectLevels const& l) {
                return l.effect == cost.effect && !l.chosen.empty();
            });
            if (!hidden || stated) {
                drawRow(layout, session, mode, toasts, cost, scale);
            }
        }
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::PushFont(theme().fonts.strong);
        ImGui::TextUnformatted(words::wholeFrame);
        ImGui::PopFont();
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        caption(limit > 0 ? words::ofBudget(limit).c_str() : words::withoutBudget);
        ImGui::TableNextColumn();
        timeBar(total, scale, limit, !(total > 0));
        layout.item("time of the frame");
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(total > 0 ? words::howFarOff(mode.error()).c_str() : "");
        ImGui::EndTable();
    }
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
}

} // namespace trembler::ui

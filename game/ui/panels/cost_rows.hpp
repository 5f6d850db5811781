// What accuracy costs, live: a row for each effect with its time, the knob for how exactly it is computed and
// how far off it is; and the frame budget.
#pragma once

#include "game/budget/budget_mode.hpp"
#include "game/ui/shared/layout.hpp"
#include "render/panels/toasts.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// An effect that can be computed in more than one way.
struct EffectLevels {
    std::string effect;
    std::vector<std::string> levels; ///< by rising cost
    std::string chosen;              ///< stated for this session; "" leaves it to the scene
    std::string working;             ///< the level of the component that is at work; "" if none is
};

/// Effects with more than one level, in order of their names.
[[nodiscard]] std::vector<EffectLevels> effectLevels(World const& world);

/// An effect as a whole.
struct EffectCost {
    std::string effect;
    Activity activity = Activity::absent; ///< of its busiest component
    double microseconds = 0;              ///< per frame
    std::string reason;                   ///< why it is absent, in words; "" if it is not
};

/// All effects of the program in order of their names. Times are those of the budget's last round; before
/// there is one, of the last turns.
[[nodiscard]] std::vector<EffectCost> effectCosts(World const& world, budget::BudgetMode const& mode);

/// Budgets that a player can choose from, in ms per frame: from and to.
inline constexpr float leastBudget = 0.02F;
inline constexpr float mostBudget = 16.7F;

/// The switch of the budget, and more or less of it: what keys do as well. Returns what is to be told.
std::string switchBudget(budget::BudgetMode& mode);
/// By the factor, within what can be chosen; switches it on if need be.
std::string changeBudget(budget::BudgetMode& mode, double factor);

class CostRows {
public:
    /// What the switch and the slider of the budget say of themselves, with the keys for it.
    struct Tips {
        std::string budget;
        std::string slider;
    };
    void setTips(Tips tips) { tips_ = std::move(tips); }
    /// The switch, how much, and what it did last. Both inside a card, as wide as that.
    void drawBudget(Layout& layout, budget::BudgetMode& mode);
    /// `all`: absent effects too.
    void drawRows(Layout& layout, Session& session, budget::BudgetMode const& mode, render::Toasts& toasts,
                  bool all);

private:
    void drawStatus(budget::BudgetMode const& mode) const;
    void drawRow(Layout& layout, Session& session, budget::BudgetMode const& mode, render::Toasts& toasts,
                 EffectCost const& cost, double scale);

    std::vector<EffectLevels> levels_; // of this picture
    Tips tips_;
    float wanted_ = 2; // ms, while it is off
};

} // namespace trembler::ui

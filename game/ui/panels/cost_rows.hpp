// The live cost of accuracy: a row for each effect with its time, the knob for its detail level and the
// estimated error; and the frame budget.
#pragma once

#include "game/budget/budget_mode.hpp"
#include "game/ui/shared/layout.hpp"
#include "render/panels/toasts.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// The detail levels of an effect that has several.
struct EffectLevels {
    std::string effect;
    std::vector<std::string> levels; ///< by ascending cost
    std::string chosen;              ///< chosen in this session; "": automatic
    std::string working;             ///< the level of the component that is constructed; "" if none is
};

/// Effects with more than one level, in order of their names.
[[nodiscard]] std::vector<EffectLevels> effectLevels(World const& world);

/// Time and state of an effect as a whole.
struct EffectCost {
    std::string effect;
    Activity activity = Activity::absent; ///< of its most active component
    double microseconds = 0;              ///< per frame
    std::string reason;                   ///< why it is absent, in words; "" if it is not
};

/// All effects of the program in order of their names. Times are means of the budget's last round; before the
/// first round, of each component's last turn.
[[nodiscard]] std::vector<EffectCost> effectCosts(World const& world, budget::BudgetMode const& mode);

/// Range of the budgets that a player can choose, ms per frame.
inline constexpr float leastBudget = 0.02F;
inline constexpr float mostBudget = 16.7F;

/// Switches the budget on or off, for keys. Returns the message for the player.
std::string switchBudget(budget::BudgetMode& mode);
/// Multiplies the budget by a factor, within the range above, and switches it on if necessary. Returns the
/// message for the player.
std::string changeBudget(budget::BudgetMode& mode, double factor);

class CostRows {
public:
    /// Tips for the switch and the slider of the budget, with their keys.
    struct Tips {
        std::string budget;
        std::string slider;
    };
    void setTips(Tips tips) { tips_ = std::move(tips); }
    /// Draws the switch, the slider and the last decisions. Both draw functions are called inside a card and
    /// use its width.
    void drawBudget(Layout& layout, budget::BudgetMode& mode);
    /// `all`: also lists absent effects.
    void drawRows(Layout& layout, Session& session, budget::BudgetMode const& mode, render::Toasts& toasts,
                  bool all);

private:
    void drawStatus(budget::BudgetMode const& mode) const;
    void drawRow(Layout& layout, Session& session, budget::BudgetMode const& mode, render::Toasts& toasts,
                 EffectCost const& cost, double scale);

    std::vector<EffectLevels> levels_; // of this picture
    Tips tips_;
    float wanted_ = 2; // ms, kept while the budget is off
};

} // namespace trembler::ui

#include "game/app/budget_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trembler {

void addBudget(nlohmann::ordered_json& all, budget::BudgetMode const& mode) {
    nlohmann::ordered_json decisions = nlohmann::ordered_json::array();
    for (budget::Decision const& decision : mode.decisions()) {
        decisions.push_back({{"frame", decision.frame},
                             {"effect", decision.effect},
                             {"from", decision.from},
                             {"to", decision.to},
                             {"saves_us", decision.microseconds},
                             {"error", decision.error.share},
                             {"error_unit", decision.of},
                             {"error_m", decision.error.metres}});
    }
    all["budget"] = {{"budget_us", *mode.budget()},
                     {"last_round_us", mode.figures().microseconds},
                     {"slowest_frame_us", mode.figures().worst},
                     {"kept", mode.kept()},
                     {"hopeless", mode.hopeless()},
                     {"error_m", mode.error()},
                     {"decisions", decisions}};
}

std::string budgetInWords(budget::BudgetMode const& mode) {
    std::string text;
    for (budget::Decision const& decision : mode.decisions()) {
        text += fmt::format("  frame {:>6}  {}\n", decision.frame, inWords(decision));
    }
    return text + fmt::format(
                      "  budget {:.3g} ms, last second {:.3g} ms per frame{}; estimated error {:.2g} m after "
                      "a second\n",
                      *mode.budget() / 1000, mode.figures().microseconds / 1000,
                      mode.kept()       ? ""
                      : mode.hopeless() ? ": no allowed choice is fast enough"
                                        : ": more than that",
                      mode.error());
}

} // namespace trembler

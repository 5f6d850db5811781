// Changes of how exactly the session's world is computed.
#include "puzzle/session/session.hpp"
#include "runtime/level/model/change_fault.hpp"

#include <utility>

namespace trembler {

void Session::change(RecordedChange change) {
    if (!building()) {
        run_->change(std::move(change));
    }
}

void Session::setDetail(std::string const& effect, std::string const& level) {
    RecordedChange made;
    made.kind = RecordedChange::Kind::detail;
    made.subject = effect;
    made.level = level;
    run_->change(std::move(made));
    if (level.empty()) {
        options_.detail.erase(effect);
    } else {
        options_.detail[effect] = level;
    }
}

void Session::setPeriod(std::string const& component, int period) {
    RecordedChange made;
    made.kind = RecordedChange::Kind::period;
    made.value = period;
    made.subject = component;
    for (ComponentStatus const& status : world().status()) { // a name without the kind is accepted, too
        std::string const full = title(*status.info);
        if (full == component) {
            made.subject = full;
            break;
        }
        if (status.info->text.name == component) {
            made.subject = full;
        }
    }
    std::string const subject = made.subject;
    run_->change(std::move(made));
    options_.periods[subject] = period;
}

std::optional<std::string> Session::whyNotDetail(std::string const& effect, std::string const& level) const {
    RecordedChange asked;
    asked.kind = RecordedChange::Kind::detail;
    asked.subject = effect;
    asked.level = level;
    auto const fault = faultIn(registry_, world(), asked);
    return fault ? std::optional(inWords(*fault)) : std::nullopt;
}

} // namespace trembler

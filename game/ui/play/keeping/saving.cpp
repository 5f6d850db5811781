#include "game/ui/play/keeping/saving.hpp"

#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/words.hpp"

#include <stdexcept>

namespace trembler::ui {

void saveSolution(Session const& session, std::string const& levelId, SavedSolutions const& saved,
                  render::Toasts& toasts, PendingWrites& pending) {
    if (session.mode() == SessionMode::building || session.world().frame() == 0) {
        toasts.add(words::runBeforeSaving, render::ToastKind::News, 5);
        return;
    }
    if (auto const whyNot = session.whyNotRecorded()) {
        toasts.add(translated(*whyNot), render::ToastKind::Trouble, 6);
        return;
    }
    try {
        auto const number = saved.of(levelId).size() + 1;
        std::string const name = words::mySolution + (" " + std::to_string(number));
        pending.write(Owned::solution, [&saved, levelId, name, solution = session.record(name)] {
            static_cast<void>(saved.keep(levelId, solution));
            return textWith("solutions.saved", name);
        });
    } catch (std::runtime_error const& error) { // it cannot be recorded
        toasts.add(shownError(error), render::ToastKind::Trouble, 6);
    }
}

} // namespace trembler::ui

#include "game/ui/play/keeping/saving.hpp"

#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/words.hpp"

#include <stdexcept>

namespace trembler::ui {

void saveSolution(Session const& session, std::string const& levelId, SavedSolutions const& saved,
                  render::Toasts& toasts) {
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
        auto const path = saved.save(levelId, session.record(name));
        toasts.add(words::solutionSaved(path.string()), render::ToastKind::News, 6);
    } catch (std::runtime_error const& error) {
        toasts.add(shownError(error), render::ToastKind::Trouble, 6);
    }
}

} // namespace trembler::ui

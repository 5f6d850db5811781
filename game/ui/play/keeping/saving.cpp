#include "game/ui/play/keeping/saving.hpp"

#include "game/ui/shared/words.hpp"

#include <stdexcept>

namespace trembler::ui {

void saveSolution(Session const& session, std::string const& level, Recorder& recorder,
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
        auto const path = recorder.solution(session.record(words::mySolution), level);
        toasts.add(words::solutionSaved(path.string()), render::ToastKind::News, 6);
    } catch (std::runtime_error const& error) {
        toasts.add(translated(error.what()), render::ToastKind::Trouble, 6);
    }
}

} // namespace trembler::ui

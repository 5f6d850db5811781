#include "game/ui/play/keeping/film.hpp"

#include "game/ui/shared/words.hpp"
#include "render/gl/error.hpp"

namespace trembler::ui {

void Film::toggle() {
    if (recording_) {
        return end();
    }
    try {
        recorder_.start();
        recording_ = true;
        toasts_.add(words::recordingTo(recorder_.film().string()), render::ToastKind::News, 5);
    } catch (render::RenderError const& error) {
        toasts_.add(translated(error.what()), render::ToastKind::Trouble);
    }
}

void Film::end() {
    if (!recording_) {
        return;
    }
    recorder_.stop();
    recording_ = false;
    toasts_.add(words::recorded(recorder_.frames(), recorder_.film().string()), render::ToastKind::News, 6);
}

void Film::take(std::function<render::Image()> const& pixels, bool stepped) {
    try {
        if (recording_ && stepped) {
            recorder_.add(pixels());
        }
        if (wanted_) {
            wanted_ = false;
            auto const path = recorder_.picture(pixels());
            toasts_.add(words::pictureTaken(path.string()));
        }
    } catch (render::RenderError const& error) {
        recording_ = false;
        toasts_.add(translated(error.what()), render::ToastKind::Trouble, 6);
    }
}

} // namespace trembler::ui

#include "game/ui/play/keeping/film.hpp"

#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/gl/error.hpp"
#include "render/gl/png.hpp"

#include <utility>

namespace trembler::ui {

render::Image halved(render::Image const& image) {
    auto const [width, height] = image.size();
    render::Image half({width / 2, height / 2});
    auto const& from = image.bytes();
    auto& to = half.bytes();
    auto const row = static_cast<std::size_t>(width) * 4;
    std::size_t next = 0;
    for (int y = 0; y < height / 2; ++y) {
        std::size_t at = static_cast<std::size_t>(y) * 2 * row;
        for (int x = 0; x < width / 2; ++x, at += 8) {
            for (std::size_t channel = 0; channel < 4; ++channel) {
                unsigned const sum = from[at + channel] + from[at + 4 + channel] + from[at + row + channel] +
                                     from[at + row + 4 + channel];
                to[next++] = static_cast<std::uint8_t>((sum + 2) / 4);
            }
        }
    }
    return half;
}

void Film::giveUp(std::string const& why) {
    recording_ = false;
    clip_.reset();
    toasts_.add(translated(why), render::ToastKind::Trouble, 10);
}

void Film::toggle() {
    if (recording_) {
        return end();
    }
    try {
        recorder_.prepare();
    } catch (OutputError const& error) {
        return giveUp(notWritten(Owned::clip, error));
    }
    clip_.reset();
    frames_ = 0;
    recording_ = true;
    toasts_.add(text("clip.begins"), render::ToastKind::News, 4);
}

void Film::end() {
    if (!recording_) {
        return;
    }
    recording_ = false;
    if (clip_ == nullptr) {
        toasts_.add(text("clip.empty"), render::ToastKind::News, 5);
        return;
    }
    try {
        std::string const bytes = clip_->bytes(static_cast<std::int64_t>(frames_) * 1000 / 60);
        clip_.reset();
        pending_.write(
            Owned::clip,
            [&recorder = recorder_, bytes, length = seconds()] {
                auto const file = recorder.write("clip", ".webp", bytes);
                return textWith("clip.written", length, shownPath(file));
            },
            bytes.size(), 8);
    } catch (render::RenderError const& error) {
        giveUp(error.what());
    }
}

void Film::writePicture(render::Image const& image) {
    std::string const bytes = render::pngOf(image);
    pending_.write(
        Owned::picture,
        [&recorder = recorder_, bytes] {
            return words::pictureTaken(shownPath(recorder.write("picture", ".png", bytes)));
        },
        bytes.size());
}

void Film::add(render::Image image) {
    if (clip_ == nullptr) {
        size_ = image.size();
    } else if (!(image.size() == size_)) { // the window has changed: all pictures of a clip are alike
        return end();
    }
    while (image.size().width > mostWidth) {
        image = halved(image);
    }
    if (clip_ == nullptr) {
        clip_ = std::make_unique<render::AnimatedWebp>(image.size());
    }
    clip_->add(image, static_cast<std::int64_t>(frames_) * 1000 / 60);
}

void Film::take(std::function<render::Image()> const& pixels, bool stepped) {
    try {
        bool const ofClip = recording_ && stepped && frames_ % framesPerPicture == 0;
        if (wanted_ || ofClip) {
            render::Image image = pixels();
            if (std::exchange(wanted_, false)) {
                writePicture(image);
            }
            if (ofClip) {
                add(std::move(image));
            }
        }
        if (recording_ && stepped && ++frames_ >= mostFrames) {
            end();
        }
    } catch (render::RenderError const& error) {
        giveUp(error.what());
    }
}

} // namespace trembler::ui

#include "game/ui/shared/kept/pending_writes.hpp"

#include "game/ui/shared/texts.hpp"

#include <utility>

namespace trembler::ui {
namespace {

constexpr double troubleShown = 14; // s: there is a reason and an advice to read

} // namespace

bool PendingWrites::write(Owned what, Write write, std::size_t bytes, double seconds) {
    try {
        toasts_.add(write(), render::ToastKind::News, seconds);
        return true;
    } catch (OutputError const& error) {
        std::size_t held = bytes;
        for (Piece const& piece : waiting_) {
            held += piece.bytes;
        }
        bool const waits = waiting_.size() < mostPieces && held <= mostBytes;
        toasts_.add(notWritten(what, error) + " " + text(waits ? "kept.again" : "kept.not_again"),
                    render::ToastKind::Trouble, troubleShown);
        if (waits) {
            waiting_.push_back({what, std::move(write), bytes, seconds});
        }
        return false;
    }
}

void PendingWrites::look(Owned what, std::optional<OutputError> const& unwritten) {
    auto const told = told_.find(what);
    if (!unwritten) {
        if (told != told_.end()) {
            told_.erase(told);
            toasts_.add(text("kept.written_now"), render::ToastKind::Success, 6);
        }
        return;
    }
    if (told != told_.end() && told->second == unwritten->what()) {
        return;
    }
    told_[what] = unwritten->what();
    toasts_.add(notWritten(what, *unwritten) + " " + text("kept.again"), render::ToastKind::Trouble,
                troubleShown);
}

void PendingWrites::pass(double seconds) {
    sinceTry_ += seconds;
    if (waiting_.empty()) {
        sinceTry_ = 0;
    } else if (sinceTry_ >= patience) {
        tryAgain();
    }
}

void PendingWrites::tryAgain() {
    sinceTry_ = 0;
    // In order: if one cannot be written, those behind it will hardly be.
    while (!waiting_.empty()) {
        std::string written;
        try {
            written = waiting_.front().write();
        } catch (OutputError const&) { // that has been said
            return;
        }
        toasts_.add(std::move(written), render::ToastKind::Success, waiting_.front().seconds);
        waiting_.pop_front();
    }
}

} // namespace trembler::ui

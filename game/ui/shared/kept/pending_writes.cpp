#include "game/ui/shared/kept/pending_writes.hpp"

#include "game/ui/shared/texts.hpp"

#include <exception>
#include <utility>

namespace trembler::ui {
namespace {

constexpr double troubleShown = 14; // s: there is a reason and an advice to read

} // namespace

bool PendingWrites::write(Owned what, Write write, std::size_t bytes, double seconds) {
    std::string why;
    try {
        toasts_.add(write(), render::ToastKind::News, seconds);
        return true;
    } catch (OutputError const& error) {
        why = notWritten(what, error);
    } catch (std::exception const& error) {
        why = notWritten(what, error);
    }
    std::size_t held = bytes;
    for (Piece const& piece : waiting_) {
        held += piece.bytes;
    }
    bool const waits = waiting_.size() < mostPieces && held <= mostBytes;
    toasts_.add(why + " " + text(waits ? "kept.again" : "kept.not_again"), render::ToastKind::Trouble,
                troubleShown);
    if (waits) {
        waiting_.push_back({what, std::move(write), bytes, seconds});
    }
    return false;
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
    for (auto piece = waiting_.begin(); piece != waiting_.end();) {
        std::string written;
        try { // why it cannot be written has been said
            written = piece->write();
        } catch (OutputError const&) {
            return; // those behind it will hardly be written on this disk
        } catch (std::exception const&) {
            ++piece; // something of its own is wrong with it
            continue;
        }
        toasts_.add(std::move(written), render::ToastKind::Success, piece->seconds);
        piece = waiting_.erase(piece);
    }
}

} // namespace trembler::ui

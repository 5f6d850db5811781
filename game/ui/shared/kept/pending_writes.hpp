// What the player wanted to keep and the disk did not take: said once, with the reason, and tried again.
#pragma once

#include "game/ui/shared/kept/kept_words.hpp"
#include "render/panels/toasts.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace trembler::ui {

/// Window thread only.
class PendingWrites {
public:
    /// Writes something and returns the sentence that says so. Whatever it throws, it is kept and tried
    /// again.
    using Write = std::function<std::string()>;
    /// Time until something is tried again, s.
    static constexpr double patience = 5;
    /// What waits at most: pieces, and bytes of memory.
    static constexpr std::size_t mostPieces = 16;
    static constexpr std::size_t mostBytes = 256U << 20U;

    /// The messages must outlive this.
    explicit PendingWrites(render::Toasts& toasts) : toasts_(toasts) {}

    /// Writes it now and says so, or says why not and tries again later; `bytes` of memory are in use as long
    /// as it waits. Returns whether it was written.
    bool write(Owned what, Write write, std::size_t bytes = 0, double seconds = 6);
    /// For what tries again by itself: says why it cannot be written when that begins or its reason changes,
    /// and that it was written when it ends.
    void look(Owned what, std::optional<OutputError> const& unwritten);
    /// For what is given up: nothing is said when it can be written.
    void forget(Owned what) { told_.erase(what); }
    /// To be called once per picture.
    void pass(double seconds);
    /// The last try, before the program ends.
    void finish() { tryAgain(); }
    /// How many pieces wait, without those of look().
    [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

private:
    struct Piece {
        Owned what;
        Write write;
        std::size_t bytes;
        double seconds;
    };
    void tryAgain();

    render::Toasts& toasts_;
    std::deque<Piece> waiting_;
    std::map<Owned, std::string> told_; // the reasons, of what look() reports
    double sinceTry_ = 0;               // s
};

} // namespace trembler::ui

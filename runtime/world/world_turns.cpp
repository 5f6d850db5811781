// The turns of components in one phase (resolvers, derived property sets or interactions) of a part of a
// frame.
#include "runtime/schedule/schedule.hpp"
#include "runtime/world/world.hpp"

#include <algorithm>
#include <chrono>

namespace trembler {

bool World::due(Entry const& entry) const {
    if (divider_ && &entry == &entries_[*divider_]) {
        return false; // the divider has its turn before the first part
    }
    auto const period = static_cast<std::uint64_t>(entry.status.period);
    return period == 1 || (now_.part == now_.parts && (now_.frame - 1) % period == 0);
}

void World::runEntry(Entry& entry) {
    auto const before = std::chrono::steady_clock::now();
    FrameContext const context{.when = now_,
                               .duration = secondsIn(ticks_ - entry.lastTick),
                               .executor = &executor_,
                               .store = &store_,
                               .tracing = tracer_ != nullptr,
                               .component = entry.index};
    if (entry.status.info->kind == ComponentKind::resolver) {
        entry.lastTick =
            ticks_; // also if an exception ends the turn: no time passes twice, see Resolver::run
    }
    entry.component->run(context);
    if (tracer_ && entry.component->hasEvents()) {
        eventful_.store(true, std::memory_order_relaxed);
    }
    entry.lastTick = ticks_;
    entry.ranTick = ticks_;
    ++entry.status.updates;
    std::chrono::duration<double, std::micro> const took = std::chrono::steady_clock::now() - before;
    entry.status.lastMicroseconds += took.count();
    entry.status.totalMicroseconds += took.count();
}

bool World::runsInside(Entry const& entry) const {
    return std::any_of(entry.insideOf.begin(), entry.insideOf.end(),
                       [this](std::size_t outer) { return entries_[outer].component != nullptr; });
}

// Runs a component if it has work, else lets it sleep.
void World::giveTurn(Entry& entry) {
    if (now_.part == 1 || entry.status.period > 1) { // its first turn in this frame
        entry.status.activity = Activity::asleep;
        entry.status.lastMicroseconds = 0;
    }
    if (entry.component->hasWork()) {
        runEntry(entry);
        entry.status.activity = Activity::active;
        return;
    }
    entry.lastTick = ticks_; // time that it sleeps through is not part of its next turn
}

// A turn that an entry sleeps through does not update the entry; its time is brought up to date here.
void World::wake(Turn& turn) {
    if (turn.quiet) {
        entries_[turn.entry].lastTick = settledTicks_;
        turn.quiet = false;
    }
}

void World::runPhase(ComponentKind kind) {
    auto const hasTurn = [this](Entry const& entry) { return entry.component && due(entry); };
    std::vector<std::size_t> running;
    std::size_t rows = 0;
    for (Turn& turn : turns_[static_cast<std::size_t>(kind)]) {
        if (turn.quiet && turn.component->sleeps()) {
            continue;
        }
        wake(turn);
        Entry& entry = entries_[turn.entry];
        bool runs = false;
        auto const consider = [&](Entry& candidate) {
            if (!hasTurn(candidate)) {
                return;
            }
            if (candidate.component->hasWork()) {
                rows += candidate.component->workload();
                runs = true;
            } else if (kind == ComponentKind::resolver) {
                runs = true; // an earlier resolver may give it work, so it decides at its turn
            } else {
                giveTurn(candidate);
            }
        };
        consider(entry);
        for (std::size_t const inner : entry.shortcuts) {
            consider(entries_[inner]);
        }
        if (runs) {
            running.push_back(turn.entry);
        } else {
            // An entry without a turn in this phase, such as the frame's divider, has not been asked.
            turn.quiet = hasTurn(entry) && entry.status.activity == Activity::asleep &&
                         entry.status.period == 1 && entry.shortcuts.empty();
        }
    }
    auto const takeTurn = [&](std::size_t n) {
        Entry& entry = entries_[running[n]];
        if (hasTurn(entry)) {
            giveTurn(entry);
        }
        for (std::size_t const inner : entry.shortcuts) {
            if (hasTurn(entries_[inner])) {
                giveTurn(entries_[inner]);
            }
        }
    };
    if (executor_.threads() == 1 || running.size() <= 1 || rows < options_.rowsWorthThreads) {
        for (std::size_t n = 0; n < running.size(); ++n) {
            takeTurn(n);
        }
        return;
    }
    if (kind == ComponentKind::resolver) {
        std::vector<ComponentInfo const*> infos;
        infos.reserve(running.size());
        for (std::size_t const i : running) {
            infos.push_back(entries_[i].status.info);
        }
        executor_.runGraph(running.size(), deriveEdges(infos), takeTurn);
    } else {
        executor_.forIndices(running.size(), takeTurn);
    }
}

} // namespace trembler

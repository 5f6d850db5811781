// A frame and its parts.
#include "runtime/frame/frame_resolver.hpp"
#include "runtime/world/world.hpp"

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

static_assert(World::ticksPerFrame == mostParts);

/// Sets a flag for its own lifetime.
class Raised {
public:
    explicit Raised(bool& flag) : flag_(flag) { flag_ = true; }
    ~Raised() { flag_ = false; }
    Raised(Raised const&) = delete;
    Raised& operator=(Raised const&) = delete;

private:
    bool& flag_;
};

} // namespace

void World::step(PartLook const& look) {
    if (knownStructure_ != 0 && wants_->takeChanged()) {
        selected_ = false;
        unbind(); // the numbers of readers have changed, even if no component comes or goes
    }
    if (knownStructure_ != 0 && !selected_) {
        select();
    }
    Raised const raised(underWay_);
    if (!std::exchange(whole_, false) && tracer_) {
        eventful_ = true; // the component whose exception ended the last frame may have left events
        gatherTrace();
    }
    now_ = {now_.frame + 1, 1, 1, now_.step + 1};
    ticks_ = (now_.frame - 1) * ticksPerFrame;
    settledTicks_ = ticks_; // differs only after a component's exception in the last frame
    now_.parts = chooseParts();
    for (SlotBase* const slot : news_) {
        slot->beginFrame();
    }
    for (;;) {
        ticks_ = (now_.frame - 1) * ticksPerFrame + now_.part * (ticksPerFrame / now_.parts);
        runPart();
        settledTicks_ = ticks_;
        if (now_.parts > 1) {
            gatherNews();
        }
        if (look) {
            look(*this);
        }
        if (now_.part == now_.parts) {
            whole_ = true;
            return;
        }
        // If no component had work in this part, nothing changes in the following parts before the last one,
        // in which components with a period have their turn.
        if (anybodyRan()) {
            ++now_.part;
        } else {
            // A component that slept in this part also sleeps through the skipped parts: if it wakes in the
            // last part, its turn covers the time of that part only.
            std::uint64_t const skipped =
                (now_.parts - now_.part - 1) * std::uint64_t{ticksPerFrame / now_.parts};
            for (Entry& entry : entries_) {
                entry.lastTick += entry.component && entry.lastTick == ticks_ ? skipped : 0;
            }
            settledTicks_ += skipped;
            now_.part = now_.parts;
        }
        ++now_.step;
    }
}

// The component that decides the number of parts of a frame has a separate turn before the first part, and so
// receives the calls that interactions made at the end of the previous frame.
std::uint32_t World::chooseParts() {
    if (!divider_ || !entries_[*divider_].component) {
        return 1;
    }
    if ((now_.frame - 1) % static_cast<std::uint64_t>(entries_[*divider_].status.period) == 0) {
        giveTurn(entries_[*divider_]);
    }
    int const parts = store_.slot<FrameParts>().value().parts;
    return static_cast<std::uint32_t>(roundedParts(parts));
}

void World::gatherNews() {
    double const share = 1.0 / now_.parts;
    double const begin = frameDuration * (now_.part - 1) * share;
    for (SlotBase* const slot : news_) {
        slot->endPart(begin, share);
    }
}

bool World::anybodyRan() const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [this](Entry const& entry) { return entry.component && entry.ranTick == ticks_; });
}

void World::runPart() {
    notes_ = 0;
    runPhase(ComponentKind::resolver);
    if (store_.structureVersion() != knownStructure_) {
        if (tracer_) {
            gatherTrace(); // select() may destroy components with their events
        }
        select(); // objects were created or destroyed: the scene may need other components
    }
    runPhase(ComponentKind::dps);
    runPhase(ComponentKind::interaction);
    if (tracer_) {
        gatherTrace();
    }
}

} // namespace trembler

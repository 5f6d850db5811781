// A running world: its data, the components that its scene needs, and its frames.
#pragma once

#include "runtime/component/channels.hpp"
#include "runtime/component/component.hpp"
#include "runtime/input/player_input.hpp"
#include "runtime/world/registry.hpp"
#include "runtime/world/selection.hpp"
#include "runtime/world/store.hpp"
#include "runtime/world/subscription.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

struct WorldOptions {
    int threads = 1; ///< >= 1; never changes a result
    std::map<std::string, std::string>
        detail;                         ///< effect -> detail level; for other effects the scene decides
    std::map<std::string, int> periods; ///< component title -> every nth frame
    bool trace = false;                 ///< gather events
    /// Below this many rows in a phase, waking other threads costs more than they can save (measured: a loop
    /// of 1000 cheap items is fourteen times slower on two threads than on one). 0 forces threads, for tests.
    std::size_t rowsWorthThreads = 4096;
};

/// The state of a registered component in a world.
struct ComponentStatus {
    ComponentInfo const* info = nullptr;
    Activity activity = Activity::absent;
    Choice choice; ///< why it is constructed or not, by the last selection; numbers are places in
                   ///< World::status()
    int period = 1;
    int longestPeriod = 1; ///< see Registration
    std::uint64_t updates = 0;
    double lastMicroseconds = 0;  ///< of all turns in the last frame in which it had any
    double totalMicroseconds = 0; ///< of all turns; for display only
};

/// To use a world: fill store(), call start(), then step() repeatedly. Not thread-safe from outside; inside,
/// it uses as many threads as its options state.
class World {
public:
    /// `registry` must outlive the world. Throws RuleBroken if it breaks the methodology's rules and
    /// std::invalid_argument if the options name an unknown effect, level or component.
    explicit World(Registry const& registry, WorldOptions options = {});
    ~World();
    World(World const&) = delete;
    World& operator=(World const&) = delete;

    [[nodiscard]] Store& store() { return store_; }
    [[nodiscard]] Store const& store() const { return store_; }

    /// Completes the objects, constructs the components that the scene needs and applies the interactions of
    /// the setup (frame 0). The objects must be in canonical order.
    void start();
    /// Computes one frame, in 1, 2, 4 or 8 equal parts, as the resolver property Frame parts states before
    /// the frame begins. In each part: advance every resolver, update every derived property set, apply every
    /// interaction. A component whose period n is not 1 has one turn in every nth frame, in its last part.
    /// If a component throws, the exception is passed on and the rest of the frame is left out. The next
    /// frame can be computed all the same: no call is carried out twice, and an interaction that threw has
    /// made none in that turn.
    void step() { step({}); }
    /// The same for observers of states that may last for one part only: a lamp that lights for less than a
    /// frame. `look` is called after each part in which anything may have changed; in it, find() returns the
    /// news of that part alone. After the frame, find() returns the news of all its parts.
    using PartLook = std::function<void(World const&)>;
    void step(PartLook const& look);
    /// The number of frames computed; during step(), the number of the current frame.
    [[nodiscard]] std::uint64_t frame() const { return now_.frame; }
    /// The current or last frame, and its current or last part.
    [[nodiscard]] Moment const& moment() const { return now_; }
    /// Time so far in ticks. A frame has mostParts ticks, so the shortest part is 1 tick.
    [[nodiscard]] std::uint64_t ticks() const { return ticks_; }
    static constexpr std::uint64_t ticksPerFrame = 8;
    /// s
    [[nodiscard]] double time() const { return secondsIn(ticks_); }
    /// XXH3-64 over all data on which later frames depend, between frames. Equal hashes mean equal worlds,
    /// bit for bit, and equal later frames; stateCoverage() lists the data that are left out and why. The
    /// hash does not depend on the number of threads, on whether events are traced, or on results that only
    /// subscriptions read.
    [[nodiscard]] std::uint64_t stateHash() const;

    /// A call from outside, for the next frame: recorded, drained and ordered like calls of an interaction.
    /// Before start(), or without a resolver of that role, the call is lost. Between frames only.
    template <ResolverRole Role, InteractionCall C>
    void feed(C const& call) {
        static_assert(FedFromOutside<Role>, "only interactions may call this role; to allow calls from "
                                            "outside the world, declare fedBy in the role (5.4)");
        if constexpr (FedFromOutside<Role>) {
            channels_.of<Role>().feed(call);
        }
    }
    /// An input of the player.
    void feed(PlayerInput const& input) { feed<PlayerRole>(input); }

    /// Requests a detail level from the next frame on; with "" the scene decides again. Throws
    /// std::invalid_argument, listing the known names, if the effect or the level is unknown. Between frames
    /// only.
    void setDetail(std::string const& effect, std::string const& level);
    /// Runs a component in every nth frame only, 1 <= n <= 3600. With 0 an interaction is left out: it is not
    /// applied any more, and the calls that it held are withdrawn. Throws std::invalid_argument if n is out
    /// of range, or if no component or several have that title or name. Between frames only.
    void setPeriod(std::string const& componentTitle, int period);
    [[nodiscard]] WorldOptions const& options() const { return options_; }

    /// One entry per registered component: resolvers, then derived property sets, then interactions.
    [[nodiscard]] std::vector<ComponentStatus> status() const;
    /// Why the scene needs the detail level that an effect has without a request, in words for people; empty
    /// if its components do not state it.
    [[nodiscard]] std::string why(std::string_view effect) const;
    /// Counts a reader outside the world, such as a loudspeaker or an overlay, among the readers of a
    /// resolver or derived property, so that it is computed even if no component reads it: from the next
    /// frame on, for as long as the subscription lives. Changes no state of the world. Between frames only.
    template <Property P>
    [[nodiscard]] Subscription want() const {
        static_assert(!ObjectProperty<P>, "want() takes a resolver or derived property; object properties "
                                          "always exist: read them with find()");
        return Subscription(wants_, propertyInfo<P>());
    }
    /// The same by description; `property` must not be an object property.
    [[nodiscard]] Subscription want(PropertyInfo const& property) const {
        return Subscription(wants_, property);
    }
    /// The value of a resolver or derived property, or nullptr if no component has ever been bound to it. Of
    /// a property that reports news (see ReportsNews), the news of the whole last frame; during step(), of
    /// the current part.
    template <Property P>
    [[nodiscard]] P const* find() const {
        auto const* const slot = store_.findSlot<P>();
        if (slot == nullptr) {
            return nullptr;
        }
        return underWay_ ? &slot->value() : &slot->ofFrame();
    }
    template <ObjectProperty P>
    [[nodiscard]] P const* find(ObjectId id) const {
        auto const* const column = store_.findColumn<P>();
        return column == nullptr ? nullptr : column->find(id);
    }
    /// Adds to the trace, after a frame, an event that an observer outside found in it: a goal that was met.
    /// Does nothing without a trace.
    EventId note(std::string_view component, std::string_view event, std::span<ObjectId const> objects,
                 std::span<EventId const> causes);
    /// The trace so far, or nullptr without a trace.
    [[nodiscard]] Tracer const* tracer() const { return tracer_.get(); }

private:
    struct Entry {
        Registration const* registration = nullptr;
        std::unique_ptr<Component> component;
        bool own = false; // it would be constructed without subscriptions as well
        ComponentStatus status;
        CallerId caller;                    // of an interaction, for the world's life
        std::uint32_t index = 0;            // in entries_
        std::vector<std::size_t> insideOf;  // of an interaction: the alternative DPS inside which it runs
        std::vector<std::size_t> shortcuts; // of a DPS: the interactions that run inside it
        std::uint64_t lastTick = 0; // at the end of its last turn, or of the last turn that it slept through
        std::uint64_t ranTick = 0;  // at the end of its last turn
    };

    /// The turn of an entry that has separate turns.
    struct Turn {
        Component const* component = nullptr;
        std::uint32_t entry = 0;
        /// It slept through its last turn, and its status says so. While it sleeps on, its entry is not
        /// looked at, and Entry::lastTick is brought up to date by wake().
        bool quiet = false;
    };

    [[nodiscard]] bool readHere(PropertyInfo const& property) const;
    void addEntries();
    void linkShortcuts();
    void select();
    void install(Entry& entry, std::unique_ptr<Component> component);
    void setUp();
    void unbind();
    void bindAll();
    [[nodiscard]] static double secondsIn(std::uint64_t ticks) {
        return frameDuration * (static_cast<double>(ticks) / ticksPerFrame);
    }
    [[nodiscard]] std::uint32_t chooseParts();
    void runPart();
    void gatherNews();
    [[nodiscard]] bool anybodyRan() const;
    void runPhase(ComponentKind kind);
    void giveTurn(Entry& entry);
    void wake(Turn& turn);
    void runEntry(Entry& entry);
    [[nodiscard]] bool due(Entry const& entry) const;
    [[nodiscard]] bool runsInside(Entry const& entry) const;
    void gatherTrace();

    Registry const& registry_;
    WorldOptions options_;
    Store store_;
    Callers callers_;
    Channels channels_{callers_};
    Executor executor_;
    std::unique_ptr<Tracer> tracer_;
    std::atomic<bool> eventful_ = false; // whether a component may have left events to gather
    std::shared_ptr<Wants> wants_ = std::make_shared<Wants>(); // not part of the world's state
    std::array<std::vector<Turn>, 3> turns_;                   // by kind, ascending by entry
    std::vector<Entry> entries_; // resolvers, derived property sets, interactions; registration order in each
    ComponentGraph graph_;       // of the entries: component n is entry n
    std::optional<std::size_t> divider_; // the entry that decides the number of parts of a frame
    std::vector<SlotBase*> news_;        // the slots of properties that report news
    Moment now_;
    std::uint64_t ticks_ = 0; // at the end of the current or last part
    std::uint64_t settledTicks_ =
        0;                    // at the end of the last part, or of the parts that were skipped after it
    bool underWay_ = false;   // during step()
    bool whole_ = false;      // no exception ended the start or the last frame
    std::uint32_t notes_ = 0; // events that note() has added in this part
    std::uint64_t knownStructure_ = 0;
    bool selected_ = false; // the components are those of the last selection; false after an exception in it
    bool bound_ = false;    // every component is bound and has its turns
};

} // namespace trembler

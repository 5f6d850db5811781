// A running world: its data, the components that its scene calls for, and the frame that moves it on.
#pragma once

#include "runtime/component/channels.hpp"
#include "runtime/component/component.hpp"
#include "runtime/input/player_input.hpp"
#include "runtime/world/registry.hpp"
#include "runtime/world/store.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

class InputResolver;

struct WorldOptions {
    int threads = 1;                           ///< >= 1; never changes a result
    std::map<std::string, std::string> detail; ///< effect -> detail level; others are picked by the scene
    std::map<std::string, int> periods;        ///< component title -> every nth frame
    bool trace = false;                        ///< gather events
    /// Below this many rows in a phase, waking other threads costs more than they can save (measured: a loop
    /// of 1000 cheap items is fourteen times slower on two threads than on one). 0 forces threads, for tests.
    std::size_t rowsWorthThreads = 4096;
};

/// How a component of the registry fares in a world.
struct ComponentStatus {
    ComponentInfo const* info = nullptr;
    Activity activity = Activity::absent;
    int period = 1;
    std::uint64_t updates = 0;
    double lastMicroseconds = 0;  ///< of its last turn
    double totalMicroseconds = 0; ///< over all turns; for people to look at, it never reaches the world
};

/// Life of a world: fill store(), start(), step() as often as wanted. Not thread-safe from outside; inside,
/// it uses as many threads as its options say.
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

    /// Constructs what the scene calls for. The objects must be complete and in canonical order.
    void start();
    /// One frame: advance every resolver, update every derived property set, apply every interaction.
    void step();
    /// Frames done so far.
    [[nodiscard]] std::uint64_t frame() const { return frame_; }
    [[nodiscard]] double time() const { return static_cast<double>(frame_) * frameDuration; }
    [[nodiscard]] std::uint64_t stateHash() const;

    /// Queues what the player did for the next frame. Before start() there is nobody to take it: it is lost.
    void feed(PlayerInput const& input);

    /// Picks a detail level from the next frame on; "" leaves the choice to the scene again. Throws
    /// std::invalid_argument, listing what there is, if the effect or the level is unknown. Between frames
    /// only.
    void setDetail(std::string const& effect, std::string const& level);
    /// Runs a component in every nth frame only. Throws std::invalid_argument. Between frames only.
    void setPeriod(std::string const& componentTitle, int period);
    [[nodiscard]] WorldOptions const& options() const { return options_; }

    /// One entry per registered component: resolvers, then derived property sets, then interactions.
    [[nodiscard]] std::vector<ComponentStatus> status() const;
    /// What in the scene calls for the detail level that an effect has if nobody asks for one, in words for
    /// people; empty if its components do not say.
    [[nodiscard]] std::string why(std::string_view effect) const;
    /// Counts somebody outside, a loudspeaker or an overlay, among the readers of a resolver or derived
    /// property, so that it is computed even if no component reads it. Changes no state of the world.
    /// Counted: every want() needs its own release(). Between frames only.
    template <Property P>
    void want() {
        setWants(propertyInfo<P>(), 1);
    }
    /// Takes one want() back; without one it does nothing.
    template <Property P>
    void release() {
        setWants(propertyInfo<P>(), -1);
    }
    /// The value of a resolver or derived property, or nullptr if no component has ever been bound to it.
    template <Property P>
    [[nodiscard]] P const* find() const {
        auto const* const slot = store_.findSlot<P>();
        return slot == nullptr ? nullptr : &slot->value();
    }
    template <ObjectProperty P>
    [[nodiscard]] P const* find(ObjectId id) const {
        auto const* const column = store_.findColumn<P>();
        return column == nullptr ? nullptr : column->find(id);
    }
    /// Adds to the account, after a frame, what somebody outside found in it: a goal that was met. Does
    /// nothing while nobody traces.
    EventId note(std::string_view component, std::string_view event, std::span<ObjectId const> objects,
                 std::span<EventId const> causes);
    /// The account so far, or nullptr if the options do not ask for one.
    [[nodiscard]] Tracer const* tracer() const { return tracer_.get(); }

private:
    struct Entry {
        Registration const* registration = nullptr;
        std::unique_ptr<Component> component;
        ComponentStatus status;
        std::uint32_t rank = 0;
        std::vector<std::size_t> insideOf;  // the entries of the DPS, alternatives, that it is a shortcut in
        std::vector<std::size_t> shortcuts; // the entries that run inside this one
        std::uint64_t lastFrame = 0;
    };

    void select();
    void setWants(PropertyInfo const& property, int change);
    [[nodiscard]] std::vector<bool> wanted() const;
    [[nodiscard]] std::vector<bool> wantedWithout(std::vector<bool> const& unread) const;
    [[nodiscard]] bool isRead(ComponentInfo const& info, std::vector<bool> const& chosen) const;
    [[nodiscard]] bool calledFor(ComponentInfo const& info) const;
    [[nodiscard]] bool hasProvider(PropertyInfo const& property, std::vector<bool> const& chosen) const;
    [[nodiscard]] std::size_t pick(std::vector<std::size_t> const& alternatives) const;
    void bindAll();
    void runPhase(ComponentKind kind);
    void giveTurn(Entry& entry);
    void runEntry(Entry& entry);
    [[nodiscard]] bool due(Entry const& entry) const;
    [[nodiscard]] bool runsInside(Entry const& entry) const;
    void gatherTrace();

    Registry const& registry_;
    WorldOptions options_;
    Store store_;
    Channels channels_;
    Executor executor_;
    std::unique_ptr<Tracer> tracer_;
    std::map<std::string_view, int> wants_; // by those outside, by key of the property
    std::vector<Entry> entries_; // resolvers, derived property sets, interactions; registration order in each
    InputResolver* input_ = nullptr;
    std::uint64_t frame_ = 0;
    std::uint32_t notes_ = 0; // of this frame
    std::uint64_t knownStructure_ = 0;
};

} // namespace trembler

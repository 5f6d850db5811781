#include "puzzle/run/frame_account.hpp"

#include "runtime/file/visible_text.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/trace/tracer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace trembler {
namespace {

// The headings of the thesis's four sections, in its order; the first section, the note, has none.
constexpr std::array<std::string_view, 3> headings{"Work for Resolvers", "Work for Derived Property Sets",
                                                   "Work for Interactions"};

// One action of one component in one frame, with all objects that it affects.
struct FrameAction {
    std::string who; ///< "Dynamics Resolver"
    std::string what;
    std::vector<std::string> objects; ///< "switch", or "floor and switch"
    bool lasting = false;             ///< a held call
};

struct Frame {
    std::vector<std::string> notes;
    std::array<std::vector<FrameAction>, headings.size()> work; ///< by phase
    std::size_t repeats = 0;                                    ///< events that have been described before

    [[nodiscard]] bool hasContent() const {
        return !notes.empty() ||
               std::any_of(work.begin(), work.end(), [](auto const& actions) { return !actions.empty(); });
    }
};

std::string listed(std::vector<std::string> const& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

/// Turns events into frames.
class Gatherer {
public:
    explicit Gatherer(World const& world) : world_(world), status_(world.status()) {}

    [[nodiscard]] std::map<std::uint64_t, Frame> frames() {
        for (Event const& event : world_.tracer()->events()) {
            for (EventId const cause : event.causes) {
                answered_.insert({cause, event.frame});
            }
        }
        for (Event const& event : world_.tracer()->events()) {
            add(event);
        }
        return std::move(frames_);
    }

private:
    [[nodiscard]] ComponentInfo const* infoOf(Event const& event) const {
        static constexpr std::array<ComponentKind, 3> kinds{ComponentKind::resolver, ComponentKind::dps,
                                                            ComponentKind::interaction};
        for (ComponentStatus const& status : status_) {
            if (status.info->kind == kinds[static_cast<std::size_t>(event.phase)] &&
                status.info->text.name == event.component) {
                return status.info;
            }
        }
        return nullptr;
    }
    // The resolver that executes an interaction's calls, if the world has one.
    [[nodiscard]] ComponentStatus const* resolverOf(ComponentInfo const& interaction) const {
        for (ComponentStatus const& status : status_) {
            if (status.info->kind == ComponentKind::resolver && status.info->role == interaction.role &&
                status.activity != Activity::absent) {
                return &status;
            }
        }
        return nullptr;
    }
    void add(Event const& event) {
        Frame& frame = frames_[event.frame];
        if (event.phase == Phase::goal) {
            frame.notes.push_back(visible(event.event)); // the name of a goal comes from a file
            return;
        }
        if (!seen_.insert({event.phase, event.component, event.event, event.objects}).second) {
            ++frame.repeats;
            return;
        }
        ComponentInfo const* const info = infoOf(event);
        bool const call = event.phase == Phase::interaction && info != nullptr;
        ComponentStatus const* const resolver = call ? resolverOf(*info) : nullptr;
        bool const held = resolver != nullptr && isHeldCall(*resolver->info, event.event);
        add(frame, event.phase, info == nullptr ? event.component : title(*info),
            (call ? "calls " : "") + event.event, event.objects, held);
        // The resolver executes the call in its next advance. If it records no event of its own for it, this
        // entry describes it.
        std::uint64_t const then = event.part < event.parts ? event.frame : event.frame + 1;
        if (resolver != nullptr && resolver->period == 1 && !answered_.contains({event.id, then})) {
            add(frames_[then], Phase::resolver, title(*resolver->info), "carries out " + event.event,
                event.objects, false);
        }
    }
    static void add(Frame& frame, Phase phase, std::string const& who, std::string const& what,
                    std::vector<std::string> const& objects, bool lasting) {
        auto& actions = frame.work[static_cast<std::size_t>(phase)];
        auto at = std::find_if(actions.begin(), actions.end(), [&](FrameAction const& action) {
            return action.who == who && action.what == what;
        });
        if (at == actions.end()) {
            at = actions.insert(actions.end(), {who, what, {}, lasting});
        }
        if (!objects.empty()) {
            at->objects.push_back(visible(fmt::format("{}", fmt::join(objects, " and "))));
        }
    }
    static bool isHeldCall(ComponentInfo const& resolver, std::string const& call) {
        return std::any_of(resolver.calls.begin(), resolver.calls.end(), [&](CallInfo const& info) {
            return info.text.name == call && isHeld(info.algebra);
        });
    }

    World const& world_;
    std::vector<ComponentStatus> status_;
    std::map<std::uint64_t, Frame> frames_;
    std::set<std::pair<EventId, std::uint64_t>>
        answered_; ///< pairs of a cause and a frame in which it had an effect
    std::set<std::tuple<Phase, std::string, std::string, std::vector<std::string>>> seen_;
};

// The properties that an object has, as its part and the level state them.
std::string propertiesOf(PropertySet const& stated, PartDefinition const* part) {
    std::vector<std::string> names;
    auto const add = [&](PropertySet const& set, PropertySet const* over) {
        for (PropertySet::Entry const& entry : set.entries()) {
            if (entry.value && entry.info->text.place == PropertyPlace::properties &&
                (over == nullptr || !over->states(*entry.info))) {
                names.emplace_back(entry.info->text.name);
            }
        }
    };
    if (part != nullptr) {
        add(part->properties, &stated);
    }
    add(stated, nullptr);
    std::sort(names.begin(), names.end());
    return names.empty() ? "-" : listed(names);
}

// A name as a cell of a table.
std::string cell(std::string_view words) {
    std::string text = visible(words);
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
        text.insert(at, 1, '\\');
    }
    return text;
}

std::string objectTable(Session const& session) {
    LevelFile const& level = session.level();
    std::map<std::string, std::vector<std::string>> connected;
    for (LevelConnection const& connection : level.connections) {
        connected[connection.a].push_back(connection.b);
        connected[connection.b].push_back(connection.a);
    }
    std::string text = "| Object | Properties | Connected to |\n|---|---|---|\n";
    auto const row = [&](std::string const& name, std::string const& properties) {
        auto const at = connected.find(name);
        text += fmt::format("| {} | {} | {} |\n", cell(name), properties,
                            at == connected.end() ? "-" : cell(listed(at->second)));
    };
    auto const rows = [&](std::string const& name, std::string const& partName, PropertySet const& own) {
        PartDefinition const* const part = session.parts().find(partName);
        row(name, propertiesOf(own, part));
        if (part != nullptr && part->composite()) {
            for (PlacedPiece const& piece : placedPieces(session.parts(), {partName, {}, 0, ""})) {
                row(fmt::format("{} {}", name, piece.name), propertiesOf(piece.properties, nullptr));
            }
        }
    };
    for (LevelObject const& object : level.objects) {
        rows(object.name, object.part, object.properties);
    }
    for (PlacedPart const& placed : session.placed()) {
        rows("placed: " + placed.placement.part, placed.placement.part, {});
    }
    return text;
}

std::string usedComponents(World const& world) {
    std::string text;
    for (auto const& [kind, heading] : {std::pair{ComponentKind::resolver, "Resolvers"},
                                        std::pair{ComponentKind::dps, "Derived property sets"},
                                        std::pair{ComponentKind::interaction, "Interactions"}}) {
        std::vector<std::string> names;
        for (ComponentStatus const& status : world.status()) {
            if (status.info->kind == kind && status.updates > 0) {
                names.emplace_back(status.info->text.name);
            }
        }
        text += fmt::format("- {}: {}\n", heading, names.empty() ? "-" : listed(names));
    }
    return text;
}

// A short summary of a frame, for its heading.
std::string headline(std::uint64_t number, Frame const& frame) {
    if (number == 0) {
        return "Setup";
    }
    if (!frame.notes.empty()) {
        return frame.notes.back();
    }
    for (std::size_t const phase : {std::size_t{1}, std::size_t{0}, std::size_t{2}}) {
        if (!frame.work[phase].empty()) {
            FrameAction const& action = frame.work[phase].back();
            return action.objects.empty() ? action.what
                                          : fmt::format("{}: {}", action.what, action.objects.front());
        }
    }
    return "";
}

std::string describe(std::uint64_t number, Frame const& frame) {
    std::string text = fmt::format("### Frame {} - {}\n\n", number, headline(number, frame));
    if (number == 0) {
        text += "The objects have the properties and connections of the table above.\n\n";
    }
    for (std::string const& note : frame.notes) {
        text += fmt::format("Note: {}.\n\n", note);
    }
    for (std::size_t phase = 0; phase < headings.size(); ++phase) {
        if (frame.work[phase].empty()) {
            continue;
        }
        text += fmt::format("**{}**\n\n", headings[phase]);
        for (FrameAction const& action : frame.work[phase]) {
            text +=
                fmt::format("- {}: {}{}{}{}\n", action.who, action.what, action.objects.empty() ? "" : ": ",
                            listed(action.objects), action.lasting ? "; and from now on" : "");
        }
        text += "\n";
    }
    return text;
}

} // namespace

std::string frameAccount(Session const& session) {
    World const& world = session.world();
    std::string text = fmt::format("# {}: the account of frames\n\n{}\n{}\n", visible(session.level().title),
                                   objectTable(session), usedComponents(world));
    std::map<std::uint64_t, Frame> frames;
    if (world.tracer() != nullptr) {
        frames = Gatherer(world).frames();
    }
    frames[0]; // the setup is always described
    std::uint64_t next = 0;
    std::size_t repeats = 0;
    auto const skipped = [&](std::uint64_t end) { // frames from `next` to before `end`
        if (next < end) {
            text += fmt::format("*{}: more of the same{}.*\n\n",
                                end - next == 1 ? fmt::format("Frame {}", next)
                                                : fmt::format("Frames {} to {}", next, end - 1),
                                repeats == 0 ? "" : fmt::format(", {} events as described", repeats));
            repeats = 0;
        }
    };
    for (auto const& [number, frame] : frames) {
        if (number > world.frame()) {
            break;
        }
        if (number == 0 || frame.hasContent()) {
            skipped(number);
            text += describe(number, frame);
            next = number + 1;
        }
        repeats += frame.repeats;
    }
    skipped(world.frame() + 1);
    text.pop_back(); // one line end is enough
    return text;
}

} // namespace trembler

#include "insight/why/story/trace_causes.hpp"

#include "insight/why/story/step.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace trembler::insight {
namespace {

using Names = std::vector<std::string>;

/// Whether an event is the call by which magnetic forces act. It is held, and recorded once, while magnets
/// begin and cease to act on its object.
bool isMagneticCall(Event const& event) {
    return event.phase == Phase::interaction && event.component == "Dynamics <- Magnetic Forces" &&
           event.event == "addForceToPoint";
}

/// Gathers the causes of each event in the trace, in one pass.
class CauseReader {
public:
    CauseReader(std::span<Event const> events, SceneFacts const& facts) : events_(events), facts_(facts) {}

    /// For each event the named events that led to it directly.
    [[nodiscard]] std::vector<std::set<std::size_t>> causes() {
        std::vector<std::set<std::size_t>> all(events_.size());
        for (std::size_t i = 0; i < events_.size(); ++i) {
            for (EventId const cause : events_[i].causes) {
                auto const at = std::lower_bound(events_.begin(), events_.begin() + static_cast<long>(i),
                                                 cause, [](Event const& e, EventId id) { return e.id < id; });
                if (at == events_.end() || at->id != cause) {
                    continue;
                }
                auto const place = static_cast<std::size_t>(at - events_.begin());
                if (isMagneticCall(*at) && !facts_.pulls.empty()) {
                    addPulls(at->objects.front(), i, all[i]);
                } else if (kindOf(*at)) {
                    if (!isIdle(*at, events_[i])) {
                        all[i].insert(place);
                    }
                } else {
                    all[i].insert(all[place].begin(), all[place].end());
                }
            }
            follow(i, all);
        }
        return all;
    }

private:
    /// Whether a magnet's pull or push had no part in another event: it is none of the main ones, or, as a
    /// force acts in the frame after it was computed, it came too late for a goal.
    [[nodiscard]] bool isIdle(Event const& cause, Event const& effect) const {
        auto const kind = kindOf(cause);
        return kind && isPull(*kind) && !facts_.pulls.empty() &&
               (!facts_.pulls.isMain(cause.id) ||
                (effect.phase == Phase::goal && cause.frame >= effect.frame));
    }

    /// Adds what moved an object by magnetic force, up to event i.
    void addPulls(std::string const& name, std::size_t i, std::set<std::size_t>& causes) const {
        for (MainPulls::Pull const& pull : facts_.pulls.on(name, events_[i].frame)) {
            auto const end = events_.begin() + static_cast<long>(i);
            auto const at = std::lower_bound(events_.begin(), end, pull.event,
                                             [](Event const& e, EventId id) { return e.id < id; });
            if (at != end && at->id == pull.event) {
                causes.insert(static_cast<std::size_t>(at - events_.begin()));
            }
        }
    }

    void follow(std::size_t i, std::vector<std::set<std::size_t>>& all) {
        Event const& event = events_[i];
        if (event.event == "connected") {
            connected_[event.objects] = all[i];
        } else if (event.event == "disconnected") {
            connected_.erase(event.objects);
        }
        auto const kind = kindOf(event);
        if (!kind) {
            return;
        }
        addReleases(*kind, i, all);
        if (*kind == StepKind::on) {
            on_.insert(event.objects.begin(), event.objects.end());
            waiting_.push_back(i);
        } else if (*kind == StepKind::off) {
            for (std::string const& name : event.objects) {
                on_.erase(name);
            }
            addShortCircuit(all[i]);
        }
        bool const last = i + 1 == events_.size() || events_[i + 1].frame != event.frame ||
                          events_[i + 1].event != event.event;
        if (last) {
            addCircuits(all);
        }
        if (*kind == StepKind::goal) {
            std::set<std::size_t> const stated = all[i]; // its causes, before others are added
            for (std::string const& name : event.objects) {
                if (!isAbout(stated, name)) {
                    continue;
                }
                if (auto const at = latest_.find(name); at != latest_.end()) {
                    if (kindOf(events_[at->second]) == StepKind::contact || facts_.pulls.empty()) {
                        all[i].insert(at->second);
                    } else {
                        addPulls(name, i, all[i]);
                    }
                }
                addImmersions(name, all[i]);
            }
        }
        if (*kind == StepKind::liquid && !event.objects.empty()) {
            immersed_[event.objects] = i;
        } else if (event.event == "leaves the liquid") {
            immersed_.erase(event.objects);
        }
        if (*kind == StepKind::contact) {
            for (std::string const& name : event.objects) {
                if (!facts_.fixed.contains(name)) {
                    latest_[name] = i;
                }
            }
        } else if (isPull(*kind) && !event.objects.empty()) {
            latest_[event.objects.front()] = i;
        }
    }

    /// Whether one of these events names the object, or there are none: a goal about any three boxes is not
    /// about objects that lie elsewhere.
    [[nodiscard]] bool isAbout(std::set<std::size_t> const& stated, std::string const& name) const {
        return stated.empty() || std::any_of(stated.begin(), stated.end(), [&](std::size_t i) {
                   std::vector<std::string> const& objects = events_[i].objects;
                   return std::find(objects.begin(), objects.end(), name) != objects.end();
               });
    }

    /// An object is carried by the liquid that contains it, or that contains an object to which it is tied.
    void addImmersions(std::string const& name, std::set<std::size_t>& causes) const {
        auto const tied = facts_.tied.find(name);
        for (auto const& [objects, event] : immersed_) {
            std::string const& dipped = objects.front();
            auto const group = facts_.tied.find(dipped);
            bool const together =
                tied != facts_.tied.end() && group != facts_.tied.end() && tied->second == group->second;
            if (dipped == name || together) {
                causes.insert(event);
            }
        }
    }

    /// What a magnet pulled off something returned there because the magnet was switched off, unless another
    /// magnet moves it now; what it touches besides, it may reach by its momentum.
    void addReleases(StepKind kind, std::size_t i, std::vector<std::set<std::size_t>>& all) {
        std::vector<std::string> const& objects = events_[i].objects;
        if (isPull(kind)) {
            if (!objects.empty() && (facts_.pulls.empty() || facts_.pulls.isMain(events_[i].id))) {
                pulls_[objects.front()] = {i, {}, {}};
            }
        } else if (kind == StepKind::apart) {
            for (std::string const& name : objects) {
                auto const pull = pulls_.find(name);
                if (pull != pulls_.end() && all[i].contains(pull->second.begin)) {
                    pull->second.left.insert(objects);
                }
            }
        } else if (kind == StepKind::magnetOff) {
            for (auto& [name, pull] : pulls_) {
                bool const own = std::any_of(all[pull.begin].begin(), all[pull.begin].end(), [&](auto cause) {
                    return kindOf(events_[cause]) == StepKind::magnetOn && events_[cause].objects == objects;
                });
                if (own && !pull.end) {
                    pull.end = i;
                }
            }
        } else if (kind == StepKind::contact) {
            for (std::string const& name : objects) {
                auto const pull = pulls_.find(name);
                if (pull != pulls_.end() && pull->second.end && pull->second.left.contains(objects) &&
                    !isMovedByAnother(name, pull->second.begin, events_[i].frame)) {
                    all[i].insert(*pull->second.end);
                }
            }
        }
    }

    /// Whether another magnet than that of a pull acts on the object.
    [[nodiscard]] bool isMovedByAnother(std::string const& name, std::size_t pull,
                                        std::uint64_t frame) const {
        std::vector<MainPulls::Pull> const now = facts_.pulls.on(name, frame);
        return std::any_of(now.begin(), now.end(), [&](MainPulls::Pull const& other) {
            return other.acting && other.by != events_[pull].objects.back();
        });
    }

    /// The contacts between objects that are on are causes of all that have just been switched on.
    void addCircuits(std::vector<std::set<std::size_t>>& all) {
        for (std::size_t const i : waiting_) {
            for (auto const& [pair, contacts] : connected_) {
                if (std::all_of(pair.begin(), pair.end(),
                                [&](std::string const& name) { return on_.contains(name); })) {
                    all[i].insert(contacts.begin(), contacts.end());
                }
            }
        }
        waiting_.clear();
    }

    /// A current that ends because something touches ends by all that it touches.
    void addShortCircuit(std::set<std::size_t>& causes) const {
        std::set<std::size_t> more;
        for (std::size_t const cause : causes) {
            if (kindOf(events_[cause]) != StepKind::contact) {
                continue;
            }
            for (std::string const& name : events_[cause].objects) {
                for (auto const& [pair, contacts] : connected_) {
                    bool const same = std::find(pair.begin(), pair.end(), name) != pair.end();
                    if (same && !facts_.fixed.contains(name)) {
                        more.insert(contacts.begin(), contacts.end());
                    }
                }
            }
        }
        causes.insert(more.begin(), more.end());
    }

    std::span<Event const> events_;
    SceneFacts const& facts_;
    std::map<Names, std::set<std::size_t>> connected_; // by contacts, at present
    std::set<std::string> on_;
    std::vector<std::size_t> waiting_;          // "on" events of this frame
    std::map<std::string, std::size_t> latest_; // contact or pull of each object
    struct Pull {
        std::size_t begin = 0;
        std::optional<std::size_t> end; // of the magnet
        std::set<Names> left;           // contacts that it ended
    };
    std::map<std::string, Pull> pulls_;     // the last one of each object
    std::map<Names, std::size_t> immersed_; // objects and the liquids that they are in, at present
};

} // namespace

std::vector<std::set<std::size_t>> causesIn(std::span<Event const> events, SceneFacts const& facts) {
    return CauseReader(events, facts).causes();
}

} // namespace trembler::insight

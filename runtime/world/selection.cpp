#include "runtime/world/selection.hpp"

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

using Numbers = ComponentGraph::Numbers;
using Flags = std::vector<bool>;

/// Computes one selection.
class Selecting {
public:
    Selecting(ComponentGraph const& graph, SelectionFacts const& facts)
        : graph_(graph), facts_(facts), choices_(graph.components.size()),
          candidate_(graph.components.size(), false), inhabited_(graph.objectProperties.size(), false),
          available_(graph.offered.size(), false), groupThere_(graph.groups.size(), false),
          groupUnread_(graph.groups.size(), false), chosenOf_(graph.groups.size()) {}

    std::vector<Choice> result() {
        findInhabited();
        findCandidates();
        for (std::size_t group = 0; group < graph_.groups.size(); ++group) {
            chooseFrom(group);
        }
        removeUnread();
        for (std::size_t number = 0; number < choices_.size(); ++number) {
            giveReason(number);
        }
        return std::move(choices_);
    }

private:
    void findInhabited() {
        for (std::size_t i = 0; i < inhabited_.size(); ++i) {
            inhabited_[i] = std::binary_search(facts_.inhabited.begin(), facts_.inhabited.end(),
                                               graph_.objectProperties[i]->text.key);
        }
    }

    [[nodiscard]] bool isActivated(ComponentGraph::Component const& component) const {
        auto const inhabited = [this](std::size_t property) { return inhabited_[property]; };
        auto const& all = component.neededAll;
        auto const& any = component.neededAny;
        return std::all_of(all.begin(), all.end(), inhabited) &&
               (any.empty() || std::any_of(any.begin(), any.end(), inhabited));
    }

    // Each component waits for the properties that it reads and for its resolver. A component that waits for
    // nothing becomes a candidate; the components that waited for it then wait for one less. Components that
    // need each other in a circle never become candidates.
    void findCandidates() {
        Numbers waitsFor(graph_.components.size());
        Numbers ready;
        for (std::size_t number = 0; number < waitsFor.size(); ++number) {
            ComponentGraph::Component const& component = graph_.components[number];
            bool const calls = component.info->kind == ComponentKind::interaction;
            waitsFor[number] = component.reads.size() + (calls ? 1 : 0) + (isActivated(component) ? 0 : 1);
            if (waitsFor[number] == 0) {
                ready.push_back(number);
            }
        }
        auto const end = [&](Numbers const& waiting) {
            for (std::size_t const number : waiting) {
                if (--waitsFor[number] == 0) {
                    ready.push_back(number);
                }
            }
        };
        while (!ready.empty()) {
            std::size_t const number = ready.back();
            ready.pop_back();
            candidate_[number] = true;
            ComponentGraph::Component const& component = graph_.components[number];
            for (std::size_t const property : component.offers) {
                if (!available_[property]) {
                    available_[property] = true;
                    end(graph_.offered[property].readers);
                }
            }
            if (!groupThere_[component.group]) {
                groupThere_[component.group] = true;
                end(graph_.groups[component.group].callers);
            }
        }
    }

    [[nodiscard]] bool isAskedFor(std::size_t number) const {
        ComponentText const& text = graph_.components[number].info->text;
        return std::any_of(facts_.detail.begin(), facts_.detail.end(), [&](auto const& asked) {
            return asked.first == text.effect && asked.second == text.level;
        });
    }

    // Chooses among candidates that serve the same need: the requested one, else the one of least rank that
    // suits the scene.
    void chooseFrom(std::size_t group) {
        candidates_.clear();
        for (std::size_t const number : graph_.groups[group].members) {
            if (candidate_[number]) {
                candidates_.push_back(number);
            }
        }
        if (candidates_.empty()) {
            return;
        }
        std::size_t const first = candidates_.front();
        auto const asked = std::find_if(candidates_.begin(), candidates_.end(),
                                        [this](std::size_t number) { return isAskedFor(number); });
        if (asked != candidates_.end()) {
            choose(*asked, ChoiceReason::levelAskedFor);
        } else if (candidates_.size() == 1) {
            choose(first, ChoiceReason::onlyCandidate);
        } else {
            auto const rank = [this](std::size_t number) {
                return graph_.components[number].info->text.rank;
            };
            std::stable_sort(candidates_.begin(), candidates_.end(),
                             [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
            auto const suits =
                std::find_if(candidates_.begin(), candidates_.end(),
                             [this](std::size_t number) { return !facts_.suits || facts_.suits(number); });
            suits != candidates_.end() ? choose(*suits, ChoiceReason::leastRank)
                                       : choose(first, ChoiceReason::noneSuits);
        }
    }

    void choose(std::size_t number, ChoiceReason reason) {
        chosenOf_[graph_.components[number].group] = number;
        choices_[number].reason = reason;
    }

    // A removal can only lower numbers of readers. The providers of a chosen component stay, as it reads
    // them, and the choice among candidates does not depend on the candidates that were not chosen. So no
    // component replaces a removed one, and only the providers of the properties that it read must be checked
    // again.
    void removeUnread() {
        readers_.assign(graph_.offered.size(), 0);
        for (std::size_t property = 0; property < readers_.size(); ++property) {
            ComponentGraph::Offered const& offered = graph_.offered[property];
            readers_[property] = static_cast<std::size_t>(
                std::count_if(offered.readers.begin(), offered.readers.end(),
                              [this](std::size_t number) { return choices_[number].chosen(); }));
            readers_[property] +=
                std::binary_search(facts_.subscribed.begin(), facts_.subscribed.end(), offered.info->text.key)
                    ? 1
                    : 0;
        }
        Numbers suspects(graph_.components.size());
        for (std::size_t number = 0; number < suspects.size(); ++number) {
            suspects[number] = number;
        }
        while (!suspects.empty()) {
            std::size_t const number = suspects.back();
            suspects.pop_back();
            if (!isUnread(number)) {
                continue;
            }
            std::size_t const group = graph_.components[number].group;
            groupUnread_[group] = true;
            remove(number, ChoiceReason::notRead, suspects);
            for (std::size_t const caller : graph_.groups[group].callers) {
                if (choices_[caller].chosen()) {
                    remove(caller, ChoiceReason::noResolver, suspects);
                }
            }
        }
    }

    [[nodiscard]] bool isUnread(std::size_t number) const {
        ComponentGraph::Component const& component = graph_.components[number];
        return choices_[number].chosen() && component.info->onDemand &&
               std::all_of(component.offers.begin(), component.offers.end(),
                           [this](std::size_t property) { return readers_[property] == 0; });
    }

    void remove(std::size_t number, ChoiceReason reason, Numbers& suspects) {
        choices_[number].reason = reason;
        chosenOf_[graph_.components[number].group].reset();
        for (std::size_t const property : graph_.components[number].reads) {
            if (--readers_[property] == 0) {
                Numbers const& providers = graph_.offered[property].providers;
                suspects.insert(suspects.end(), providers.begin(), providers.end());
            }
        }
    }

    void giveReason(std::size_t number) {
        Choice& choice = choices_[number];
        ComponentGraph::Component const& component = graph_.components[number];
        if (choice.chosen()) {
            return;
        }
        choice.alternative = chosenOf_[component.group];
        if (choice.reason != ChoiceReason::undecided) {
            return; // the component was removed
        }
        if (!isActivated(component)) {
            choice.reason = ChoiceReason::noObjects;
            auto const& all = component.neededAll;
            auto const lacking =
                std::find_if(all.begin(), all.end(), [this](std::size_t p) { return !inhabited_[p]; });
            choice.property = lacking == all.end() ? nullptr : graph_.objectProperties[*lacking];
        } else if (component.info->kind == ComponentKind::interaction &&
                   !(component.resolvers && groupThere_[*component.resolvers])) {
            choice.reason = ChoiceReason::noResolver;
        } else if (!candidate_[number]) {
            choice.reason = ChoiceReason::noProvider;
            auto const& reads = component.reads;
            choice.property = graph_
                                  .offered[*std::find_if(reads.begin(), reads.end(),
                                                         [this](std::size_t p) { return !available_[p]; })]
                                  .info;
        } else {
            choice.reason =
                groupUnread_[component.group] ? ChoiceReason::notRead : ChoiceReason::alternativeChosen;
        }
    }

    ComponentGraph const& graph_;
    SelectionFacts const& facts_;
    std::vector<Choice> choices_;
    Flags candidate_;                                  // of components
    Flags inhabited_;                                  // of object properties
    Flags available_;                                  // of offered properties: a candidate offers it
    Flags groupThere_;                                 // of groups: has a candidate
    Flags groupUnread_;                                // of groups: its properties have no readers
    std::vector<std::optional<std::size_t>> chosenOf_; // of groups
    Numbers candidates_;                               // of the group that is being chosen from
    Numbers readers_; // of offered properties: how many chosen components and subscriptions read it
};

} // namespace

std::vector<Choice> selectComponents(ComponentGraph const& graph, SelectionFacts const& facts) {
    return Selecting(graph, facts).result();
}

} // namespace trembler

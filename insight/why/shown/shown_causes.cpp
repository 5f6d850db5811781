#include "insight/why/shown/shown_causes.hpp"

#include <algorithm>
#include <string>

namespace trembler::insight {
namespace {

/// Whether a cause of a parting only says that the two touched before, or that the one that moved lay on
/// something fixed besides.
bool isPresupposed(Step const& cause, Step const& parting, SceneFacts const& facts) {
    if (parting.kind != StepKind::apart || cause.kind != StepKind::contact) {
        return false;
    }
    return cause.objects == parting.objects ||
           (std::any_of(cause.objects.begin(), cause.objects.end(),
                        [&](std::string const& name) { return facts.fixed.contains(name); }) &&
            std::any_of(cause.objects.begin(), cause.objects.end(), [&](std::string const& name) {
                return !facts.fixed.contains(name) &&
                       std::find(parting.objects.begin(), parting.objects.end(), name) !=
                           parting.objects.end();
            }));
}

/// The causes of a step with the causes of what it presupposes in its place; as they are if none are left.
StepSet withoutPresupposed(Story const& story, std::vector<StepSet> const& causes, std::size_t step,
                           SceneFacts const& facts) {
    StepSet left;
    for (std::size_t const cause : causes[step]) {
        if (isPresupposed(story.steps[cause], story.steps[step], facts)) {
            left.insert(causes[cause].begin(), causes[cause].end());
        } else {
            left.insert(cause);
        }
    }
    return left.empty() ? causes[step] : left;
}

} // namespace

std::vector<StepSet> nearestShown(Story const& story, std::vector<bool> const& shown) {
    std::vector<StepSet> nearest(story.steps.size());
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        for (std::size_t const cause : story.steps[i].because) {
            if (shown[cause]) {
                nearest[i].insert(cause);
            } else {
                nearest[i].insert(nearest[cause].begin(), nearest[cause].end());
            }
        }
    }
    return nearest;
}

void keepLastDips(Story const& story, StepSet& causes) {
    std::erase_if(causes, [&](std::size_t cause) {
        Step const& dip = story.steps[cause];
        return dip.kind == StepKind::liquid &&
               std::any_of(causes.upper_bound(cause), causes.end(), [&](std::size_t later) {
                   Step const& other = story.steps[later];
                   return other.kind == StepKind::liquid && other.objects == dip.objects;
               });
    });
}

std::vector<StepSet> shownCauses(Story const& story, std::vector<bool> const& shown,
                                 SceneFacts const& facts) {
    std::size_t const count = story.steps.size();
    std::vector<StepSet> nearest = nearestShown(story, shown);
    for (StepSet& causes : nearest) {
        keepLastDips(story, causes);
    }
    std::vector<StepSet> beside(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t const cause : nearest[i]) {
            StepKind const kind = story.steps[i].kind;
            bool const switches = (kind == StepKind::on || kind == StepKind::off) &&
                                  story.steps[cause].kind == StepKind::contact;
            if (shown[i] && switches) {
                beside[cause].insert(nearest[i].begin(), nearest[i].end());
            }
        }
    }
    std::vector<StepSet> ancestors(count);
    std::vector<StepSet> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        StepSet causes;
        for (std::size_t const cause : nearest[i]) {
            if (beside[i].contains(cause)) {
                causes.insert(result[cause].begin(), result[cause].end()); // in its place, its own causes
            } else {
                causes.insert(cause);
            }
        }
        for (std::size_t const cause : causes) {
            ancestors[i].insert(cause);
            ancestors[i].insert(ancestors[cause].begin(), ancestors[cause].end());
        }
        for (std::size_t const cause : causes) {
            bool const indirect = std::any_of(causes.begin(), causes.end(), [&](std::size_t other) {
                return ancestors[other].contains(cause);
            });
            if (!indirect) {
                result[i].insert(cause);
            }
        }
        result[i] = withoutPresupposed(story, result, i, facts);
    }
    return result;
}

} // namespace trembler::insight

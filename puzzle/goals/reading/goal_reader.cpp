#include "puzzle/goals/reading/goal_reader.hpp"

#include "puzzle/goals/conditions/table.hpp"
#include "runtime/level/build/joint_names.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

constexpr std::string_view itName = "it";
constexpr double longestHold = 3600; // s

std::string listedKeys() {
    std::vector<std::string> keys;
    for (ConditionKind const* const kind : conditionKinds()) {
        keys.emplace_back(kind->key());
    }
    return listed(keys);
}

} // namespace

GoalReader::GoalReader(LevelFile const& level) : keys_(listedKeys()), pieces_(level.objects) {
    for (LevelObject const& object : level.objects) {
        objects_.push_back(object.name);
        parts_.insert(object.part);
    }
    for (std::string const& joint : jointNames(level)) {
        objects_.push_back(joint);
    }
    for (ToolboxEntry const& entry : level.toolbox) {
        parts_.insert(entry.part);
    }
    parts_.erase("");
    known_.insert(objects_.begin(), objects_.end());
}

Condition GoalReader::condition(JsonNode const& node) {
    Condition condition;
    condition.path = node.path();
    if (++conditions_ > limits::conditions) { // one message suffices: finding a place in the file is slow
        if (conditions_ == limits::conditions + 1) {
            node.complain("is one condition too many", fmt::format("at most {}", limits::conditions));
        }
        return condition;
    }
    MemberReader reader(node, fmt::format("a condition: an object with one of the keys {}", keys_));
    if (!reader.valid()) {
        return condition;
    }
    ConditionKind const* stated = nullptr;
    int found = 0;
    for (ConditionKind const* const kind : conditionKinds()) {
        if (reader.optional(std::string(kind->key()))) {
            stated = kind;
            ++found;
        }
    }
    readExtras(reader, condition);
    reader.finish();
    if (found != 1) {
        node.complain(found == 0 ? "states no condition" : "states several conditions at once",
                      fmt::format("exactly one of the keys {}", keys_));
        return condition;
    }
    condition.kind = stated;
    stated->read(node.member(std::string(stated->key())), condition, *this);
    return condition;
}

std::vector<Condition> GoalReader::conditions(JsonNode const& node) {
    std::vector<Condition> all;
    if (!node.isList("a list of conditions", limits::conditions)) {
        return all;
    }
    if (node.size() == 0) {
        node.complain("is empty", "at least one condition");
    }
    for (std::size_t i = 0; i < node.size() && conditions_ <= limits::conditions; ++i) {
        all.push_back(condition(node.element(i)));
    }
    return all;
}

Condition GoalReader::conditionOnIt(JsonNode const& node) {
    insideCount_ = true;
    Condition that = condition(node);
    insideCount_ = false;
    return that;
}

void GoalReader::readExtras(MemberReader& reader, Condition& condition) {
    if (auto const seconds = reader.optional("for")) {
        condition.seconds = seconds->number(0, longestHold);
    }
    if (auto const text = reader.optional("text")) {
        condition.text = text->text().value_or("");
    }
    if (auto const id = reader.optional("id")) {
        condition.id = id->name("an id").value_or("");
        if (!condition.id.empty() && !ids_.insert(condition.id).second) {
            id->complain(fmt::format("there is already a goal with the id '{}'", condition.id),
                         "a unique id");
        }
    }
}

Selector GoalReader::selector(JsonNode const& node) {
    Selector selector;
    selector.path = node.path();
    if (!node.value().is_array()) {
        readSingle(node, selector);
        return selector;
    }
    if (!node.isList("a list of objects", limits::objects)) {
        return selector;
    }
    if (node.size() == 0) {
        node.complain("is empty", "at least one object");
    }
    for (std::size_t i = 0; i < node.size(); ++i) {
        readSingle(node.element(i), selector);
    }
    return selector;
}

void GoalReader::readPart(JsonNode const& node, Selector& selector) {
    MemberReader reader(node, "an object {\"part\"}");
    if (auto const part = reader.required("part", "the name of a part")) {
        std::string const name = part->name("the name of a part").value_or("");
        if (!name.empty() && !parts_.contains(name)) {
            std::vector<std::string> const known(parts_.begin(), parts_.end());
            part->complain(fmt::format("nothing in this level is made from the part '{}'{}", name,
                                       didYouMean(name, known)),
                           known.empty() ? "the name of an object" : listed(known));
        }
        selector.parts.push_back(name);
    }
    reader.finish();
}

void GoalReader::readSingle(JsonNode const& node, Selector& selector) {
    if (node.value().is_object()) {
        readPart(node, selector);
        return;
    }
    auto const name = node.text("the name of an object, {\"part\": name}, or a list of these");
    if (!name) {
        return;
    }
    if (*name == itName) {
        selector.it = true;
        if (!insideCount_) {
            node.complain("'it' refers to no object here",
                          "the name of an object; 'it' belongs inside a count");
        }
        return;
    }
    if (!known_.contains(*name) && !pieces_.mayBe(*name)) { // ObjectFinder knows which pieces there are
        addProblem(node.problems(), [&] { // only if the problem is kept: the suggestion searches all names
            return node.diagnostic(
                fmt::format("there is no object '{}'{}", *name, didYouMean(*name, objects_)),
                "the name of an object of this level; {\"part\": name} for what the player places");
        });
    }
    selector.names.push_back(*name);
}

} // namespace trembler

#include "puzzle/goals/read_goals.hpp"

#include "runtime/level/build/joint_names.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/json_node.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/read/read_area.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>

namespace trembler {
namespace {

constexpr std::string_view itName = "it";
constexpr double farthest = 1e6;     // m
constexpr double longestHold = 3600; // s

class GoalReader {
public:
    explicit GoalReader(LevelFile const& level) {
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

    Condition read(JsonNode const& node) {
        Condition condition;
        condition.path = node.path();
        if (++conditions_ > limits::conditions) { // finding a place takes a while, and one will do
            if (conditions_ == limits::conditions + 1) {
                node.complain("is one condition too many", fmt::format("at most {}", limits::conditions));
            }
            return condition;
        }
        MemberReader reader(node, "a condition: an object with one of the keys " + listed(kinds()));
        if (!reader.valid()) {
            return condition;
        }
        std::string kind;
        int found = 0;
        for (std::string const& key : kinds()) {
            if (reader.optional(key)) {
                kind = key;
                ++found;
            }
        }
        readExtras(reader, condition);
        reader.finish();
        if (found != 1) {
            node.complain(found == 0 ? "states no condition" : "states several conditions at once",
                          "exactly one of the keys " + listed(kinds()));
            return condition;
        }
        readBody(kind, node.member(kind), condition);
        return condition;
    }

private:
    static std::vector<std::string> kinds() {
        return {"inside", "touching", "on", "off", "moved", "count", "all", "any", "not", "sequence"};
    }

    void readExtras(MemberReader& reader, Condition& condition) {
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
                             "an id of its own");
            }
        }
    }

    void readBody(std::string const& kind, JsonNode const& body, Condition& condition) {
        if (kind == "inside") {
            readInside(body, condition);
        } else if (kind == "touching") {
            condition.kind = ConditionKind::touching;
            if (!body.value().is_array() || body.size() != 2) {
                body.complainOfType("a list of two: what shall touch what");
                return;
            }
            condition.subject = readSelector(body.element(0));
            condition.object = readSelector(body.element(1));
        } else if (kind == "on" || kind == "off") {
            condition.kind = kind == "on" ? ConditionKind::on : ConditionKind::off;
            condition.subject = readSelector(body);
        } else if (kind == "moved") {
            readMoved(body, condition);
        } else if (kind == "count") {
            readCount(body, condition);
        } else if (kind == "not") {
            condition.kind = ConditionKind::negation;
            condition.children.push_back(read(body));
        } else {
            condition.kind = kind == "all"   ? ConditionKind::all
                             : kind == "any" ? ConditionKind::any
                                             : ConditionKind::sequence;
            if (!body.isList("a list of conditions", limits::conditions)) {
                return;
            }
            if (body.size() == 0) {
                body.complain("is empty", "at least one condition");
            }
            for (std::size_t i = 0; i < body.size() && conditions_ <= limits::conditions; ++i) {
                condition.children.push_back(read(body.element(i)));
            }
        }
    }

    void readInside(JsonNode const& body, Condition& condition) {
        condition.kind = ConditionKind::inside;
        MemberReader reader(body, "an object {\"object\", \"area\"}");
        if (auto const object = reader.required("object", "the name of an object")) {
            condition.subject = readSelector(*object);
        }
        if (auto const area = reader.required("area", "a box [x, y, width, height] or a polygon, in m")) {
            condition.area = readArea(*area).value_or(Area{Box{}, {}});
        }
        if (auto const called = reader.optional("called")) {
            condition.areaName = called->name("words for the area").value_or("");
        }
        reader.finish();
    }

    void readMoved(JsonNode const& body, Condition& condition) {
        constexpr std::array<std::string_view, 4> directions{"up", "down", "left", "right"};
        condition.kind = ConditionKind::moved;
        MemberReader reader(body, "an object {\"object\", \"by\"}");
        if (auto const object = reader.required("object", "the name of an object")) {
            condition.subject = readSelector(*object);
        }
        if (auto const by = reader.required("by", "a distance in m")) {
            condition.distance = by->number(1e-3, farthest).value_or(1);
        }
        if (auto const towards = reader.optional("towards")) {
            if (auto const index = towards->choice(directions)) {
                condition.towards = static_cast<Towards>(*index + 1);
            }
        }
        reader.finish();
    }

    void readCount(JsonNode const& body, Condition& condition) {
        constexpr std::int64_t most = 100000;
        constexpr std::array<char const*, 3> quantities{"at_least", "at_most", "exactly"};
        condition.kind = ConditionKind::count;
        MemberReader reader(body, "an object {\"of\", \"at_least\", \"that\"}");
        if (!reader.valid()) {
            return;
        }
        if (insideCount_) {
            body.complain("stands inside another count", "conditions on \"it\" that do not count");
            return;
        }
        if (auto const of = reader.required("of", "a list of objects, or {\"part\": name}")) {
            condition.subject = readSelector(*of);
        }
        int stated = 0;
        for (std::size_t i = 0; i < quantities.size(); ++i) {
            if (auto const number = reader.optional(quantities[i])) {
                ++stated;
                condition.quantity = static_cast<Quantity>(i);
                condition.number = static_cast<int>(number->integer(i == 0 ? 1 : 0, most).value_or(1));
            }
        }
        if (stated != 1) {
            body.complain(stated == 0 ? "does not state a number" : "states several numbers",
                          "one of \"at_least\", \"at_most\", \"exactly\"");
        }
        if (auto const that = reader.required("that", "a condition on \"it\"")) {
            insideCount_ = true;
            condition.children.push_back(read(*that));
            insideCount_ = false;
        }
        reader.finish();
    }

    Selector readSelector(JsonNode const& node) {
        Selector selector;
        selector.path = node.path();
        if (node.value().is_array()) {
            if (!node.isList("a list of objects", limits::objects)) {
                return selector;
            }
            if (node.size() == 0) {
                node.complain("is empty", "at least one object");
            }
            for (std::size_t i = 0; i < node.size(); ++i) {
                readSingle(node.element(i), selector);
            }
        } else {
            readSingle(node, selector);
        }
        return selector;
    }

    void readSingle(JsonNode const& node, Selector& selector) {
        if (node.value().is_object()) {
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
            return;
        }
        auto const name = node.text("the name of an object, {\"part\": name}, or a list of these");
        if (!name) {
            return;
        }
        if (*name == itName) {
            selector.it = true;
            if (!insideCount_) {
                node.complain("'it' stands for nothing here",
                              "the name of an object; 'it' belongs inside a count");
            }
            return;
        }
        if (!known_.contains(*name)) {
            addProblem(node.problems(), [&] { // looking for what was meant costs a walk through all names
                return node.diagnostic(
                    fmt::format("there is no object '{}'{}", *name, didYouMean(*name, objects_)),
                    "the name of an object of this level; {\"part\": name} for what the player places");
            });
        }
        selector.names.push_back(*name);
    }

    std::vector<std::string> objects_;
    std::unordered_set<std::string> known_; // the same, to be asked
    std::set<std::string> parts_;
    std::set<std::string> ids_;
    std::size_t conditions_ = 0;
    bool insideCount_ = false;
};

} // namespace

std::optional<Condition> readGoals(LevelFile const& level, Problems& problems) {
    if (level.goals.is_null()) {
        return std::nullopt;
    }
    if (level.document) {
        return GoalReader(level).read(JsonNode(*level.document, level.goals, "/goals", problems));
    }
    // A level that never was a file still has to be told where its goals are wrong.
    auto const document = JsonDocument::parse(
        nlohmann::json{{"goals", level.goals}}.dump(1, ' ', false, nlohmann::json::error_handler_t::replace),
        "(level)");
    return GoalReader(level).read(JsonNode(*document, level.goals, "/goals", problems));
}

std::optional<Condition> readGoals(LevelFile const& level) {
    Problems problems;
    auto condition = readGoals(level, problems);
    problems.throwIfAny();
    return condition;
}

} // namespace trembler

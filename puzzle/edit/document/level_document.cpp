#include "puzzle/edit/document/level_document.hpp"

#include "physics/gravity/properties.hpp"
#include "puzzle/edit/text/lay_out.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/read/migrations.hpp"
#include "runtime/level/read/read_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace trembler::edit {
namespace {

constexpr std::uint64_t unsavedState = ~std::uint64_t{0};
constexpr std::string_view newLevelName = "new level";

Json blankTree() {
    return Json{
        {"version", levelVersion},
        {"title", "A new level"},
        {"world",
         {{"gravity", Json::array({0, -earthGravity})}, {"bounds", Json::array({-4, -0.5, 8, 4.5})}}},
        {"objects",
         Json::array({Json{{"name", "floor"},
                           {"at", Json::array({0, -0.15})},
                           {"properties",
                            {{"material", "stone"},
                             {"shape", Json::array({Json{{"form", "box"}, {"width", 8}, {"height", 0.3}}})},
                             {"fixed", true}}}}})}};
}

/// The migrated tree with its keys in the order of the original, new ones after them.
Json orderedLike(Json const& original, nlohmann::json const& migrated) {
    if (migrated.is_object()) {
        Json out = Json::object();
        if (original.is_object()) {
            for (auto const& [key, value] : original.items()) {
                if (auto const found = migrated.find(key); found != migrated.end()) {
                    out[key] = orderedLike(value, *found);
                }
            }
        }
        for (auto const& [key, value] : migrated.items()) {
            if (!out.contains(key)) {
                out[key] = orderedLike({}, value);
            }
        }
        return out;
    }
    if (migrated.is_array()) {
        Json out = Json::array();
        for (std::size_t i = 0; i < migrated.size(); ++i) {
            bool const there = original.is_array() && i < original.size();
            out.push_back(orderedLike(there ? original[i] : Json(), migrated[i]));
        }
        return out;
    }
    return Json(migrated);
}

/// Throws CommandError if a file could not hold the tree.
void checkSize(Json const& tree, std::size_t depth, std::size_t& values) {
    if (++values > limits::values || depth > limits::depth) {
        throw CommandError(
            values > limits::values
                ? fmt::format("the level would have more than {} values", limits::values)
                : fmt::format("more than {} lists and objects would be inside one another", limits::depth));
    }
    if (tree.is_structured()) {
        for (Json const& child : tree) {
            checkSize(child, depth + (child.is_structured() ? 1U : 0U), values);
        }
    }
}

} // namespace

LevelDocument::LevelDocument(GameData const& data, std::string text, std::filesystem::path path)
    : data_(&data), path_(std::move(path)) {
    text_ = std::move(text);
}

LevelDocument LevelDocument::blank(GameData const& data) {
    LevelDocument made(data, layOutFile(blankTree()), {});
    made.parse(std::string(newLevelName));
    return made;
}

LevelDocument LevelDocument::open(GameData const& data, std::filesystem::path const& path) {
    LevelDocument made(data, JsonDocument::readText(path), path);
    made.onDisk_ = made.text_;
    try {
        made.parse(path.string());
    } catch (InputError const& error) { // it is no JSON
        made.faults_ = error.diagnostics();
        made.readOnly_ = true;
    }
    return made;
}

LevelDocument LevelDocument::fromText(GameData const& data, std::string const& text,
                                      std::filesystem::path path, std::optional<std::string> onDisk) {
    LevelDocument made(data, text, std::move(path));
    made.parse(made.name());
    made.faults_.clear();
    if (made.readOnly_ && made.mayBeEdited()) {
        made.convert();
    }
    made.readOnly_ = false;
    made.onDisk_ = std::move(onDisk);
    made.savedState_ = made.onDisk_ && *made.onDisk_ == text ? 0 : unsavedState;
    return made;
}

void LevelDocument::parse(std::string const& file) {
    json_ = JsonDocument::parse(*text_, file);
    source_ = std::make_shared<SourceText const>(*text_);
    tree_ = source_->tree();
    Problems problems;
    static_cast<void>(readLevel(data_->registry, json_, problems));
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        faults_ = error.diagnostics();
        readOnly_ = true;
    }
    if (!readOnly_) {
        convert();
    }
}

void LevelDocument::convert() {
    auto const version = tree_.find("version");
    if (version == tree_.end() || !version->is_number_unsigned() ||
        version->get<std::uint64_t>() >= static_cast<std::uint64_t>(levelVersion)) {
        return;
    }
    nlohmann::json current = json()->root();
    migrate(current, version->get<int>());
    tree_ = orderedLike(tree_, current);
    tree_["version"] = levelVersion;
    text_.reset();
    json_.reset();
}

std::string const& LevelDocument::text() const {
    if (!text_) {
        text_ = source_->textOf(tree_);
    }
    return *text_;
}

std::string LevelDocument::name() const {
    return path_.empty() ? std::string(newLevelName) : data_->shortName(path_);
}

std::shared_ptr<JsonDocument const> const& LevelDocument::json() const {
    if (!json_) {
        json_ = JsonDocument::parse(text(), path_.empty() ? std::string(newLevelName) : path_.string());
    }
    return json_;
}

LevelFile LevelDocument::level() const {
    return readLevel(data_->registry, json());
}

bool LevelDocument::mayBeEdited() const {
    if (!tree_.is_object()) {
        return false;
    }
    auto const version = tree_.find("version");
    return version != tree_.end() && version->is_number_unsigned() &&
           version->get<std::uint64_t>() <= static_cast<std::uint64_t>(levelVersion);
}

void LevelDocument::editNevertheless() {
    if (!mayBeEdited()) {
        throw CommandError(
            "this file cannot be edited: it is no level, or was made by a newer version of the program");
    }
    readOnly_ = false;
    convert();
    ++revision_;
}

void LevelDocument::run(Command const& command, std::optional<Gesture> gesture) {
    if (readOnly_) {
        throw CommandError("the file has errors and was opened read-only");
    }
    bool const joins = gesture && gestureOpen_ && done_ > 0 && done_ == steps_.size() &&
                       steps_.back().gesture == gesture->number;
    if (!joins) {
        before_ = tree_;
    } else if (gesture->next == Gesture::Next::replaces) {
        steps_.back().patch.revert(tree_);
    }
    TreePatch patch;
    try {
        changeTree(command);
        patch = TreePatch::between(before_, tree_);
    } catch (...) {
        tree_ = before_;
        if (joins) {
            steps_.back().patch.apply(tree_);
        }
        throw;
    }
    if (patch.empty() && !joins) {
        return;
    }
    forgetStepsFrom(joins ? done_ - 1 : done_);
    if (!patch.empty()) {
        std::size_t const bytes = sizeof(Step) + command.name.size() + patch.bytes();
        steps_.push_back(
            {command.name, std::move(patch), ++lastState_, gesture ? gesture->number : 0, bytes});
        stepBytes_ += bytes;
    }
    done_ = steps_.size();
    shortenHistory(mostHistory);
    gestureOpen_ = gesture.has_value();
    if (!gestureOpen_) {
        before_ = {};
    }
    changed();
}

void LevelDocument::forgetStepsFrom(std::size_t first) {
    while (steps_.size() > first) {
        stepBytes_ -= steps_.back().bytes;
        steps_.pop_back();
    }
}

void LevelDocument::shortenHistory(std::size_t most) {
    while (stepBytes_ > most && steps_.size() > fewestSteps && done_ > 0) {
        stepBytes_ -= steps_.front().bytes;
        firstState_ = steps_.front().state;
        steps_.pop_front();
        --done_;
        ++forgotten_;
    }
}

void LevelDocument::changeTree(Command const& command) {
    try {
        command.change(tree_);
    } catch (nlohmann::json::exception const&) {
        throw CommandError("the level is not of the form that this needs");
    }
    std::size_t values = 0;
    checkSize(tree_, 1, values);
}

std::string LevelDocument::undoName() const {
    return canUndo() ? steps_[done_ - 1].name : std::string();
}

std::string LevelDocument::redoName() const {
    return canRedo() ? steps_[done_].name : std::string();
}

bool LevelDocument::undo() {
    if (!canUndo()) {
        return false;
    }
    steps_[--done_].patch.revert(tree_);
    gestureOpen_ = false;
    changed();
    return true;
}

bool LevelDocument::redo() {
    if (!canRedo()) {
        return false;
    }
    steps_[done_++].patch.apply(tree_);
    gestureOpen_ = false;
    changed();
    return true;
}

void LevelDocument::goTo(std::size_t count) {
    std::size_t const wanted = std::min(count - std::min(count, forgotten_), steps_.size());
    while (done_ > wanted) {
        undo();
    }
    while (done_ < wanted) {
        redo();
    }
}

void LevelDocument::changed() {
    ++revision_;
    text_.reset();
    json_.reset();
}

} // namespace trembler::edit

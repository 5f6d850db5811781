#include "insight/timeline/stage.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace trembler::insight {
namespace {

using Living = std::map<ObjectId, std::string>;

Living livingIn(Words const& words, CallerNames const& callers) {
    WordReader in(words, callers);
    Living living;
    for (std::uint64_t left = in.word(); left > 0; --left) {
        ObjectId const id = in.object();
        living.emplace(id, in.text());
    }
    return living;
}

/// The id that the next new object gets.
ObjectId nextId(ObjectTable const& objects) {
    ObjectId next{static_cast<std::uint32_t>(objects.indexBound()), 0};
    objects.forFree([&](std::uint32_t index, std::uint32_t generation) {
        if (index < next.index) {
            next = {index, generation};
        }
    });
    return next;
}

/// Lets exactly these objects exist. False if an id was used by a later object already, so that it cannot
/// come back in this store.
bool populate(Store& store, Living const& living) {
    std::vector<ObjectId> others;
    ObjectTable const& objects = store.objects();
    for (std::uint32_t index = 0; index < objects.indexBound(); ++index) {
        if (ObjectId const id = objects.at(index); id.valid() && living.count(id) == 0) {
            others.push_back(id);
        }
    }
    store.destroy(std::move(others));
    std::vector<ObjectId> fillers; // hold lower indices while higher ones are made
    bool possible = true;
    for (auto const& [id, name] : living) {
        while (possible && !store.alive(id)) {
            ObjectId const next = nextId(objects);
            if (next == id) {
                Origin origin;
                origin.kind = Origin::Kind::birth;
                store.create(name, origin);
            } else if (next.index > id.index || (next.index == id.index && next.generation > id.generation)) {
                possible = false;
            } else {
                ObjectId const filler = store.create("(filler " + std::to_string(fillers.size()) + ")");
                if (filler.index == id.index) {
                    store.destroy({filler}); // its index gets the next generation
                } else {
                    fillers.push_back(filler);
                }
            }
        }
    }
    store.destroy(fillers);
    return possible;
}

} // namespace

Stage::Stage(Build build) : build_(std::move(build)) {}

void Stage::forget() {
    run_.reset();
    shown_.clear();
    frame_.reset();
}

void Stage::rebuild() {
    run_ = build_();
    ++builds_;
    shown_.clear();
    std::vector<std::string> names;
    for (ComponentStatus const& status : run_->world().status()) {
        if (status.info->kind == ComponentKind::interaction) {
            names.emplace_back(status.info->text.name);
        }
    }
    callers_ = std::make_unique<CallerNames>(names);
}

void Stage::prepare() {
    if (!run_) {
        rebuild();
    }
}

void Stage::show(Recording const& recording, std::uint64_t frame) {
    RecordedFrame const& recorded = recording.at(frame);
    prepare();
    std::vector<RecordedPart> const& parts = recording.parts();
    auto const wordsOf = [&](std::size_t part) {
        SharedWords const stated = part < recorded.values.size() ? recorded.values[part] : nullptr;
        return stated ? stated : recording.beginning()[part];
    };
    for (std::size_t part = 0; part < parts.size(); ++part) {
        SharedWords const words = wordsOf(part);
        if (parts[part].kind != RecordedPart::Kind::objects || !words ||
            (part < shown_.size() && shown_[part] == words)) {
            continue;
        }
        Living const living = livingIn(*words, callers());
        bool possible = false;
        run_->alter("shown", [&](World& world) { possible = populate(world.store(), living); });
        if (!possible) {
            rebuild();
            run_->alter("shown", [&](World& world) { populate(world.store(), living); });
        }
        shown_.clear(); // rows have come and gone
        shown_.resize(parts.size());
        shown_[part] = words;
    }
    shown_.resize(parts.size());
    static Words const noRows{0};
    static Words const noWords;
    run_->alter("shown", [&](World& world) {
        for (std::size_t part = 0; part < parts.size(); ++part) {
            SharedWords words = wordsOf(part);
            bool const isNew = part >= shown_.size() || shown_[part] != words || frame_ == std::nullopt;
            RecordedPart const& what = parts[part];
            if (what.kind == RecordedPart::Kind::objects || !(isNew || !words)) {
                continue;
            }
            if (what.kind == RecordedPart::Kind::column) {
                WordReader in(words ? *words : noRows, callers());
                readColumn(world.store().column(*what.property), in);
            } else if (what.kind == RecordedPart::Kind::slot) {
                WordReader in(words ? *words : noWords, callers());
                auto const slots = recordedSlots();
                std::find_if(slots.begin(), slots.end(), [&](RecordedSlot const& slot) {
                    return slot.info == what.property;
                })->read(world.store(), in);
            } else if (words) {
                showGoals(*words);
            }
            shown_[part] = std::move(words);
        }
    });
    frame_ = recorded.number;
}

void Stage::showGoals(Words const& words) {
    goals_ = run_->judge().status();
    WordReader in(words, callers());
    for (GoalStatus& goal : goals_) {
        in.members(goal.met);
        goal.progress = in.number();
        std::uint64_t const frame = in.word();
        goal.frame = frame > 0 ? std::optional(frame - 1) : std::nullopt;
    }
    std::uint64_t const solved = in.word();
    solvedFrame_ = solved > 0 ? std::optional(solved - 1) : std::nullopt;
}

} // namespace trembler::insight

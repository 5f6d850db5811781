#include "runtime/level/build/part_expander.hpp"

#include "runtime/level/build/joint_names.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace trembler {
namespace {

using Form = StatedProperties::Form;

std::string inside(std::string const& path, std::string_view key) {
    return path.empty() ? std::string() : pointerTo(path, key);
}

std::vector<std::string> pieceNamesOf(PartDefinition const& part) {
    std::vector<std::string> names;
    for (LevelObject const& piece : part.objects) {
        names.push_back(piece.name);
    }
    return names;
}

/// The piece that a name inside the part belongs to, and the rest of the name: of "lamp holder bulb", the
/// piece "lamp holder" and "bulb".
std::optional<std::pair<std::size_t, std::string>> pieceOf(PartDefinition const& part,
                                                           std::string const& name) {
    std::optional<std::pair<std::size_t, std::string>> best;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < part.objects.size(); ++i) {
        std::string const& piece = part.objects[i].name;
        if (name == piece) {
            return std::pair(i, std::string());
        }
        if (name.starts_with(piece + " ") && piece.size() > longest) {
            longest = piece.size();
            best.emplace(i, name.substr(piece.size() + 1));
        }
    }
    return best;
}

PieceFrame frameOf(LevelObject const& entry) {
    PieceFrame frame;
    if (auto const* const position = entry.properties.find<Position>()) {
        frame.at = position->value;
    }
    if (auto const* const rotation = entry.properties.find<Rotation>()) {
        frame.angle = rotation->angle;
    }
    frame.flipped = entry.flipped;
    return frame;
}

} // namespace

PartExpander::PartExpander(PartLibrary const& library, Complain complain)
    : library_(library), complain_(std::move(complain)) {
    centre_.set(Position{});
    centre_.set(Rotation{});
}

ExpandedEntry PartExpander::expand(LevelObject const& entry, StatementScope const& scope, Form form) {
    ExpandedEntry made;
    add({entry, scope.prefix + entry.name, scope, form, {}, false, library_.find(entry.part), {}}, made);
    std::sort(made.objects.begin(), made.objects.end(), [](MadeObject const& a, MadeObject const& b) {
        return std::tie(a.joint, a.name) < std::tie(b.joint, b.name);
    });
    std::string main = scope.prefix + entry.name;
    for (auto at = made.aliases.rbegin(); at != made.aliases.rend(); ++at) { // the outermost first
        if (at->first == main) {
            main = at->second;
        }
    }
    for (std::size_t i = 0; i < made.objects.size(); ++i) {
        if (!made.objects[i].joint && made.objects[i].name == main) {
            made.main = i;
        }
    }
    return made;
}

void PartExpander::add(Task task, ExpandedEntry& into) {
    PartDefinition const* const part = task.entry.part.empty() ? nullptr : library_.find(task.entry.part);
    if (part == nullptr && !task.entry.part.empty()) {
        complain_(task.scope, inside(task.entry.path, "part"),
                  fmt::format("there is no part '{}'{}", task.entry.part,
                              didYouMean(task.entry.part, library_.names())),
                  listed(library_.names()));
    } else if (part == nullptr || !part->composite()) {
        addSingle(task, part, into);
    } else if (mayEnter(task, *part, into)) {
        around_.push_back(part);
        addComposite(task, *part, into);
        around_.pop_back();
    }
}

void PartExpander::addSingle(Task const& task, PartDefinition const* part, ExpandedEntry& into) {
    MadeObject made;
    made.name = task.name;
    made.part = task.represents;
    made.flipped = task.entry.flipped != task.outer.flipped;
    if (task.isPiece) {
        made.stated.push_back({&centre_, &task.scope, task.entry.path, Form::entry, task.outer});
    }
    if (part != nullptr) {
        made.stated.push_back({&part->properties, &scopeOf(*part), "", Form::part, task.outer});
    }
    made.stated.push_back({&task.entry.properties, &task.scope, task.entry.path, task.form, task.outer});
    auto const noPieces = [&](StatementScope const& scope, std::string const& path) {
        complain_(scope, path, fmt::format("'{}' has no pieces", task.name), "properties of a piece");
    };
    for (auto const& [piece, properties] : task.entry.pieces) {
        noPieces(task.scope, inside(inside(task.entry.path, "pieces"), piece));
    }
    for (Override const& over : task.overrides) {
        if (over.piece.empty()) {
            made.stated.push_back(over.stated);
        } else {
            noPieces(*over.stated.scope, over.stated.path);
        }
    }
    into.objects.push_back(std::move(made));
}

void PartExpander::addComposite(Task const& task, PartDefinition const& part, ExpandedEntry& into) {
    StatementScope const& scope =
        scopes_.emplace_back(StatementScope{&part.names, task.name + " ", part.document.get()});
    PieceFrame const frame = task.outer.of(frameOf(task.entry));
    std::vector<std::vector<Override>> passed = passedOn(task, part, scope, frame);
    std::vector<std::size_t> order(part.objects.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return part.objects[a].name < part.objects[b].name; });
    for (std::size_t const i : order) {
        LevelObject const& piece = part.objects[i];
        bool const isMain = piece.name == part.mainPiece();
        add({piece, scope.prefix + piece.name, scope, Form::entry, frame, true,
             isMain ? task.represents : nullptr, std::move(passed[i])},
            into);
    }
    into.aliases.emplace_back(task.name, scope.prefix + part.mainPiece());
    addJoints(task, part, scope, frame, into);
    for (LevelConnection const& stated : part.connections) {
        LevelConnection connection = stated;
        connection.a = scope.prefix + stated.a;
        connection.b = scope.prefix + stated.b;
        into.connections.push_back({std::move(connection), scope.document});
    }
}

void PartExpander::addJoints(Task const& task, PartDefinition const& part, StatementScope const& inside,
                             PieceFrame const& frame, ExpandedEntry& into) {
    std::vector<std::string> const names = jointNames(part.objects, part.joints, part.names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        LevelJoint const& joint = part.joints[i];
        MadeObject made;
        made.name = fmt::format("{} {}", task.name, names[i]);
        made.joint = true;
        made.flipped = frame.flipped;
        made.stated.push_back({&joint.properties, &inside, joint.path, Form::members, frame});
        into.objects.push_back(std::move(made));
    }
}

std::vector<std::vector<PartExpander::Override>> PartExpander::passedOn(Task const& task,
                                                                        PartDefinition const& part,
                                                                        StatementScope const& inner,
                                                                        PieceFrame const& frame) {
    std::vector<std::vector<Override>> passed(part.objects.size());
    auto const pass = [&](std::string const& name, StatedProperties stated) {
        if (auto const found = pieceOf(part, name)) {
            passed[found->first].push_back({found->second, std::move(stated)});
        } else {
            std::vector<std::string> const names = pieceNamesOf(part);
            complain_(*stated.scope, stated.path,
                      fmt::format("'{}' has no piece '{}'{}", part.name, name, didYouMean(name, names)),
                      listed(names));
        }
    };
    std::string const& main = part.mainPiece();
    LevelObject const& entry = task.entry;
    pass(main, {&part.properties, &inner, "", Form::part, frame});
    pass(main,
         {&entry.properties, &task.scope, inside(entry.path, "properties"), Form::overrides, task.outer});
    for (auto const& [piece, properties] : entry.pieces) {
        pass(piece, {&properties, &task.scope, inside(inside(entry.path, "pieces"), piece), Form::overrides,
                     task.outer});
    }
    for (Override const& over : task.overrides) {
        pass(over.piece.empty() ? main : over.piece, over.stated);
    }
    return passed;
}

bool PartExpander::mayEnter(Task const& task, PartDefinition const& part, ExpandedEntry const& into) {
    std::string const path = inside(task.entry.path, "part");
    if (std::find(around_.begin(), around_.end(), &part) != around_.end()) {
        complain_(task.scope, path, fmt::format("the part '{}' would contain itself", part.name),
                  "a part that does not consist of this one");
        return false;
    }
    if (around_.size() >= limits::partDepth) {
        complain_(task.scope, path, "too many parts inside one another",
                  fmt::format("at most {}", limits::partDepth));
        return false;
    }
    if (into.objects.size() + part.objects.size() + part.joints.size() > limits::pieces) {
        complain_(task.scope, path, fmt::format("the part '{}' has too many pieces", part.name),
                  fmt::format("at most {} pieces and joints, with those of its pieces", limits::pieces));
        return false;
    }
    return true;
}

StatementScope const& PartExpander::scopeOf(PartDefinition const& part) {
    auto const [at, isNew] = ofParts_.try_emplace(&part, nullptr);
    if (isNew) {
        at->second = &scopes_.emplace_back(StatementScope{&part.names, "", part.document.get()});
    }
    return *at->second;
}

} // namespace trembler

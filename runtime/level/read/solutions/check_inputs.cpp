#include "runtime/level/read/solutions/check_inputs.hpp"

#include "runtime/level/build/joint_names.hpp"
#include "runtime/level/build/placing.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/population/birth_name.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace trembler {
namespace {

using Pair = std::pair<std::string, std::string>;

Pair inOrder(std::string const& a, std::string const& b) {
    return a < b ? Pair(a, b) : Pair(b, a);
}

/// The inputs of one solution, one after the other.
class InputReader {
public:
    InputReader(std::set<std::string> const& names, std::set<Pair> const& wires, PieceNames pieces,
                Solution const& solution, JsonDocument const& document, Problems& problems)
        : names_(names), wires_(wires), pieces_(std::move(pieces)), solution_(solution), document_(document),
          problems_(problems) {}

    void placed(std::vector<std::string> const& names) {
        placed_.insert(names.begin(), names.end());
        for (std::string const& name : names) {
            pieces_.add(name);
        }
    }

    void readWires(std::size_t most) {
        if (solution_.wires.size() > most) {
            addProblem(problems_, [&] {
                return document_.diagnostic(solution_.wires[most].path,
                                            most == 0   ? "The toolbox of this level has no wire."
                                            : most == 1 ? "The toolbox has only one wire."
                                                        : fmt::format("The toolbox has only {} wires.", most),
                                            "wires that the level allows");
            });
        }
        for (LevelConnection const& wire : solution_.wires) {
            bool const known = isKnown(wire.a, wire.path) && isKnown(wire.b, wire.path);
            bool const isNew =
                !wires_.contains(inOrder(wire.a, wire.b)) && laid_.insert(inOrder(wire.a, wire.b)).second;
            if (known && (wire.a == wire.b || !isNew)) {
                addProblem(problems_, [&] {
                    return document_.diagnostic(wire.path,
                                                wire.a == wire.b ? "connects an object with itself"
                                                                 : "there is such a wire already",
                                                "every pair of objects once");
                });
            }
        }
    }

    void read(RecordedInput const& input) {
        readFrame(input.frame, input.path);
        bool const known = isKnown(input.object, input.path) && isKnown(input.other, input.path);
        if (!known || input.kind != PlayerInput::Kind::cut) {
            return;
        }
        Pair const wire = inOrder(input.object, input.other);
        if (!wires_.contains(wire) && !laid_.contains(wire) &&
            (isPiece(wire.first) || isPiece(wire.second))) {
            return; // a wire inside a composite part, or one that names the same piece in another way
        }
        if (!wires_.contains(wire) && !laid_.contains(wire)) {
            addProblem(problems_, [&] {
                return document_.diagnostic(
                    input.path,
                    fmt::format("there is no wire between '{}' and '{}'", input.object, input.other),
                    "a pair of objects under \"connections\" or \"wires\"");
            });
        } else if (!cut_.insert(wire).second) {
            addProblem(problems_, [&] {
                return document_.diagnostic(input.path,
                                            fmt::format("the wire between '{}' and '{}' has been cut before",
                                                        input.object, input.other),
                                            "every wire once");
            });
        }
    }

    void readFrame(std::uint64_t frame, std::string const& path) {
        if (!solution_.frames || frame <= static_cast<std::uint64_t>(*solution_.frames)) {
            return;
        }
        addProblem(problems_, [&] {
            return document_.diagnostic(
                path, fmt::format("is in frame {}, after the last one", frame),
                fmt::format("frames from 1 to {}, the \"frames\" of the solution", *solution_.frames));
        });
    }

private:
    /// Whether it may be a piece, whose name is known only from its part.
    [[nodiscard]] bool isPiece(std::string const& name) const {
        return !names_.contains(name) && pieces_.mayBe(name);
    }
    bool isKnown(std::string const& name, std::string const& path) {
        // Of objects created during the run, only the form of their names is known.
        if (name.empty() || names_.contains(name) || placed_.contains(name) || isBirthName(name) ||
            pieces_.mayBe(name)) {
            return true;
        }
        addProblem(problems_, [&] {
            std::vector<std::string> known(names_.begin(), names_.end());
            known.insert(known.end(), placed_.begin(), placed_.end());
            return document_.diagnostic(
                path, fmt::format("there is no object '{}'{}", name, didYouMean(name, known)),
                "an object of the level, or one that the solution places");
        });
        return false;
    }

    std::set<std::string> const& names_;
    std::set<Pair> const& wires_;
    PieceNames pieces_;
    Solution const& solution_;
    JsonDocument const& document_;
    Problems& problems_;
    std::set<std::string> placed_;
    std::set<Pair> laid_; // wires of the player
    std::set<Pair> cut_;
};

} // namespace

InputCheck::InputCheck(LevelFile const& level) : level_(level), pieces_(level.objects) {
    for (LevelObject const& object : level.objects) {
        names_.insert(object.name);
    }
    for (std::string& joint : jointNames(level)) {
        names_.insert(std::move(joint));
    }
    for (LevelConnection const& connection : level.connections) {
        wires_.insert(inOrder(connection.a, connection.b));
    }
}

void InputCheck::check(Solution const& solution, JsonDocument const& document, Problems& problems) const {
    InputReader reader(names_, wires_, pieces_, solution, document, problems);
    bool const named = !solution.inputs.empty() || !solution.wires.empty();
    if (named && !solution.placements.empty()) {
        reader.placed(placementNames(level_, solution.placements));
    }
    reader.readWires(static_cast<std::size_t>(level_.wires));
    for (RecordedInput const& input : solution.inputs) {
        reader.read(input);
    }
    for (RecordedChange const& change : solution.changes) {
        reader.readFrame(change.frame, change.path);
    }
}

} // namespace trembler

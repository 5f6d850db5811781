#include "runtime/level/read/check_level.hpp"

#include "runtime/level/build/piece_names.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/model/change_fault.hpp"
#include "runtime/level/read/solutions/check_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace trembler {
namespace {

/// The checks of one level whose sections have all been read.
class LevelCheck {
public:
    LevelCheck(Registry const& registry, LevelFile const& level,
               std::map<std::string, std::string> const& paths, Problems& problems)
        : registry_(registry), level_(level), paths_(paths), pieces_(level.objects), problems_(problems) {}

    void checkConnections() {
        for (LevelConnection const& connection : level_.connections) {
            bool known = true;
            std::size_t end = 0;
            for (std::string const* name : {&connection.a, &connection.b}) {
                if (!paths_.contains(*name) && !pieces_.mayBe(*name)) {
                    complainAboutName(
                        pointerTo(connection.path + (connection.kind.empty() ? "" : "/between"), end), *name);
                    known = false;
                }
                ++end;
            }
            if (known && connection.a == connection.b) {
                complainAt(connection.path, fmt::format("connects '{}' with itself", connection.a),
                           "two different objects");
            }
        }
    }

    /// Complains about connections of one kind between the same two objects: they would look like one
    /// connection, but a cut would remove only one of them.
    void checkTwice() {
        std::map<std::tuple<std::string, std::string, std::string>, std::string> stated;
        for (LevelConnection const& connection : level_.connections) {
            auto const [first, last] = std::minmax(connection.a, connection.b);
            auto const [at, isNew] = stated.try_emplace({first, last, connection.kind}, connection.path);
            if (!isNew) {
                complainAt(connection.path,
                           fmt::format("connects '{}' and '{}', as {} does", first, last, at->second),
                           "every pair once, in whichever order");
            }
        }
    }

    void checkSolutions() {
        if (level_.solutions.empty()) {
            return;
        }
        InputCheck const inputs(level_);
        for (Solution const& solution : level_.solutions) {
            inputs.check(solution, *level_.document, problems_);
        }
    }

    void checkChanges() {
        for (Solution const& solution : level_.solutions) {
            for (RecordedChange const& change : solution.changes) {
                if (auto const fault = faultIn(registry_, change)) {
                    complainAt(change.path, fault->message, fault->expected);
                }
            }
        }
    }

    void checkTeaching() {
        for (TeachingStep const& step : level_.teaching) {
            switch (step.kind) {
            case TeachingStep::Kind::run:
                break;
            case TeachingStep::Kind::place:
                if (!inToolbox(step.object)) {
                    complainAt(pointerTo(step.path, "place"),
                               fmt::format("the toolbox has no '{}'", step.object),
                               "the name of a part in the toolbox");
                }
                break;
            case TeachingStep::Kind::grab:
                checkTaught(pointerTo(step.path, "grab"), step.object);
                break;
            case TeachingStep::Kind::wire:
            case TeachingStep::Kind::cut: {
                bool const wire = step.kind == TeachingStep::Kind::wire;
                std::string const ends = pointerTo(step.path, wire ? "wire" : "cut");
                checkTaught(pointerTo(ends, std::size_t{0}), step.object);
                checkTaught(pointerTo(ends, std::size_t{1}), step.other);
                if (wire && level_.wires == 0) {
                    complainAt(ends, "the toolbox has no wire", "{\"wire\": 1} in the toolbox");
                }
                break;
            }
            }
        }
    }

private:
    [[nodiscard]] bool inToolbox(std::string const& part) const {
        return std::any_of(level_.toolbox.begin(), level_.toolbox.end(),
                           [&](ToolboxEntry const& entry) { return entry.part == part; });
    }

    /// The object may also be a part that the player has placed: its name is the part's, with a number.
    void checkTaught(std::string const& path, std::string const& name) {
        bool const placed =
            std::any_of(level_.toolbox.begin(), level_.toolbox.end(),
                        [&](ToolboxEntry const& entry) { return name.starts_with(entry.part + " "); });
        if (!placed && !paths_.contains(name) && !pieces_.mayBe(name)) {
            complainAboutName(path, name);
        }
    }

    void complainAt(std::string const& path, std::string message, std::string expected) {
        addProblem(problems_, [&] {
            return level_.document->diagnostic(path, std::move(message), std::move(expected));
        });
    }

    /// Complains that no object has that name.
    void complainAboutName(std::string const& path, std::string const& name) {
        addProblem(problems_, [&] { // finding a suggestion takes a walk through all names
            std::vector<std::string> known;
            for (auto const& [other, where] : paths_) {
                known.push_back(other);
            }
            return level_.document->diagnostic(
                path, fmt::format("there is no object '{}'{}", name, didYouMean(name, known)),
                "the name of an object of this level");
        });
    }

    Registry const& registry_;
    LevelFile const& level_;
    std::map<std::string, std::string> const& paths_;
    PieceNames pieces_; // checked when a world is built
    Problems& problems_;
};

} // namespace

void checkLevel(Registry const& registry, LevelFile const& level,
                std::map<std::string, std::string> const& paths, Problems& problems) {
    LevelCheck check(registry, level, paths, problems);
    check.checkConnections();
    check.checkTwice();
    check.checkSolutions();
    check.checkChanges();
    check.checkTeaching();
}

} // namespace trembler

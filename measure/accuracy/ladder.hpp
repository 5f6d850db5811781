// A ladder: the error and the cost of every detail level of an effect in one scene, against a reference.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace trembler {

struct GameData;

namespace accuracy {

/// One detail level, or one setting of a detail level, in a scene.
struct Rung {
    std::string level;
    /// µs per frame of the effect's components, median over the frames; the least of several runs.
    double microseconds = 0;
    double error = 0;            ///< in the ladder's unit; 0: exact
    std::string cannotRepresent; ///< phenomena that the level cannot represent, however long it computes
    bool onFront = false;        ///< Pareto front: no other level is faster and at least as accurate
    std::string beatenBy;        ///< the first level of the ladder that beats it, "" on the front
};

struct Ladder {
    std::string effect;
    std::string scene;     ///< a short description
    std::string unit;      ///< unit of the error: "m", "of the force"
    std::string error;     ///< the measured quantity, in words
    std::string reference; ///< the quantity to which the error is relative
    /// Whether the rungs compete for one task, so that some can beat others in both error and cost. For other
    /// studies no front is drawn.
    bool rivals = true;
    std::vector<Rung> rungs;
    std::string remark; ///< an observation for the documentation; may be empty
};

/// How much work to put into a measurement.
struct Effort {
    bool brief = false; ///< tiny scenes, one second in total: for tests
    /// How often each ladder is measured; the least time of each rung counts, because other load on the
    /// machine only adds time. Errors are the same in every run.
    int runs = 1;
};

/// A ladder that can be measured; its effect is known before that.
struct Plan {
    std::string effect;
    std::function<Ladder(GameData const&, Effort)> climb;
};

/// All plans, by effect and in the order in which they are reported. New ladders are added here only.
[[nodiscard]] std::vector<Plan> plans();

/// Runs the plans of these effects, or all plans if none is named, and marks the fronts. `progress` receives
/// a description of each measurement before it starts. Throws std::invalid_argument, listing the known
/// effects, for an unknown effect.
[[nodiscard]] std::vector<Ladder> climb(GameData const& gameData, std::vector<std::string> const& effects,
                                        Effort effort,
                                        std::function<void(std::string const&)> const& progress = {});

/// Marks the rungs on the Pareto front. Times within 5 % of one another count as equal, which is their
/// uncertainty.
void markFront(Ladder& ladder);

/// The phenomena that a level cannot represent, however long it computes; "" if nothing is known. Settings
/// such as "4 substeps" are looked up by the name of the setting.
[[nodiscard]] std::string whatLevelCannotRepresent(std::string const& effect, std::string const& level);

/// "1 substep", "4 substeps"; "automatic substeps" for 0.
[[nodiscard]] std::string substepsName(int substeps);

// The plans of one effect each, and those of the coupling between effects.
void addDynamicsPlans(std::vector<Plan>& plans);
void addGravityPlans(std::vector<Plan>& plans);
void addElectricityPlans(std::vector<Plan>& plans);
void addMagnetismPlans(std::vector<Plan>& plans);
void addBuoyancyPlans(std::vector<Plan>& plans);
void addSoundPlans(std::vector<Plan>& plans);
void addCoSimulationPlans(std::vector<Plan>& plans);

} // namespace accuracy
} // namespace trembler

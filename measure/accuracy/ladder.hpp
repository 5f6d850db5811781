// What accuracy costs: an effect in a scene, at every detail level, against a reference.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace trembler {

struct GameData;

namespace accuracy {

/// One detail level, or one setting of one, in a scene.
struct Rung {
    std::string level;
    double microseconds =
        0;                  ///< median over the frames, of the effect's components; of several runs the least
    double error = 0;       ///< in the ladder's unit; 0: none
    std::string cannotTell; ///< what no amount of it can tell
    bool onFront = false;   ///< no other level is faster and at least as accurate
    std::string beatenBy;   ///< a level that is: the first in the ladder, "" on the front
};

struct Ladder {
    std::string effect;
    std::string scene;     ///< in a few words
    std::string unit;      ///< of the error: "m", "of the force"
    std::string error;     ///< what is measured, in words
    std::string reference; ///< what it is measured against
    /// Whether the rungs are rivals for one task, of which some may be better than others in all respects.
    /// Where they are a study of something else, no front is drawn.
    bool rivals = true;
    std::vector<Rung> rungs;
    std::string remark; ///< what there is to see in it, for the documentation; may be empty
};

/// How much work to put into it.
struct Effort {
    bool brief = false; ///< tiny scenes, a second in all: for tests
    /// How often to climb each ladder; the least time of each rung counts, as what else a machine does only
    /// adds to it. Errors are the same every time.
    int runs = 1;
};

/// One ladder to be climbed: its effect is known before it is run.
struct Plan {
    std::string effect;
    std::function<Ladder(GameData const&, Effort)> climb;
};

/// All plans, by effect and in the order in which they are reported. The one place where a new one is added.
[[nodiscard]] std::vector<Plan> plans();

/// Runs the plans of these effects, of all if there are none named, and marks the fronts. `progress` is told
/// what is about to run. Throws std::invalid_argument, listing what there is, for an unknown effect.
[[nodiscard]] std::vector<Ladder> climb(GameData const& gameData, std::vector<std::string> const& effects,
                                        Effort effort,
                                        std::function<void(std::string const&)> const& progress = {});

/// Marks who is on the front. Times within 5 % of one another count as the same: they are no more certain.
void markFront(Ladder& ladder);

/// What a level cannot tell, however long it computes; "" if nothing is known of it. `setting` levels such as
/// "4 substeps" go by the name of the setting.
[[nodiscard]] std::string whatCannotTell(std::string const& effect, std::string const& level);

/// "1 substep", "4 substeps"; "automatic substeps" for 0.
[[nodiscard]] std::string substepsName(int substeps);

// The plans of one effect each, and of what lies between them.
void addDynamicsPlans(std::vector<Plan>& plans);
void addGravityPlans(std::vector<Plan>& plans);
void addElectricityPlans(std::vector<Plan>& plans);
void addMagnetismPlans(std::vector<Plan>& plans);
void addBuoyancyPlans(std::vector<Plan>& plans);
void addSoundPlans(std::vector<Plan>& plans);
void addCoSimulationPlans(std::vector<Plan>& plans);

} // namespace accuracy
} // namespace trembler

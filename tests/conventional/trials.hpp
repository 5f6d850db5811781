// How often the simulations, and scripts of increasing effort, are right about perturbed scenes.
#pragma once

#include "tests/conventional/scene.hpp"

namespace trembler::conventional {

/// One perturbed scene.
struct Trial {
    std::uint64_t number = 0;
    std::vector<std::string> kinds;
    std::string right;
    std::string physical;
    std::vector<std::string> scripted; ///< by effort
};

struct SceneResult {
    std::string title;
    std::vector<std::string> efforts;
    std::vector<std::size_t> scripts; ///< number of scripts, by effort
    std::vector<Trial> trials;
};

/// Runs a perturbed scene in every way. The same number gives the same trial.
[[nodiscard]] Trial runTrial(Scene const& scene, Stage const& stage, std::uint64_t number);
/// The scene as it is described.
[[nodiscard]] Trial runDescribed(Scene const& scene, Stage const& stage);
/// Runs the first perturbations of a scene, as many as stated.
[[nodiscard]] SceneResult runTrials(Scene const& scene, Stage const& stage, std::uint64_t count);

/// A share, and its confidence interval of 95 %, by Wilson's formula.
struct Share {
    std::size_t of = 0;
    std::size_t all = 0;
    [[nodiscard]] double low() const;
    [[nodiscard]] double high() const;
};
[[nodiscard]] std::string toText(Share share);

/// As Markdown: scripts and shares of all scenes.
[[nodiscard]] std::string shareTable(std::vector<SceneResult> const& results);
/// By kind of perturbation: how often each is right where it is among the kinds of a trial.
[[nodiscard]] std::string kindTable(SceneResult const& result);
/// The trials in which the simulations are wrong.
[[nodiscard]] std::string missTable(std::vector<SceneResult> const& results);
/// The outcomes of the first trials of each scene.
[[nodiscard]] std::string firstTable(std::vector<SceneResult> const& results, std::size_t count);

/// Numbers of perturbations of each scene: for the page, and for a test.
inline constexpr std::uint64_t fullCount = 200;
inline constexpr std::uint64_t shortCount = 12;

} // namespace trembler::conventional

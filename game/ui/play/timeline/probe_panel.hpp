// Numbers of objects plotted over the timeline.
#pragma once

#include "game/ui/play/timeline/timeline.hpp"
#include "game/ui/shared/layout.hpp"
#include "insight/probe/named_numbers.hpp"
#include "insight/probe/series.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// A quantity of an object that can be plotted.
struct Quantity {
    std::string name; ///< for people
    std::string what; ///< as watch::find() takes it: "ball.velocity.length"
};

/// Reads the recording, a part of it in each picture, so probes that are added late show the whole run.
/// Results that nothing computed while it ran have no values. Window thread only.
class ProbePanel {
public:
    /// Both must outlive this.
    ProbePanel(Registry const& registry, Session const& session);

    /// Adds or removes a probe of that name, see watch::find().
    void toggle(std::string const& what);
    /// The same for a name of an object in that world, which may be gone from the session's.
    void toggle(World const& world, std::string const& what);
    void removeAll();
    [[nodiscard]] insight::Probes const& probes() const { return probes_; }
    /// The quantities of an object of the shown world that can be plotted: the usual quantities that it has,
    /// then all its numbers.
    [[nodiscard]] std::vector<Quantity> quantitiesOf(World const& world, std::string const& object) const;
    /// The quantities whose name contains the word that the player has typed, see watch::namedNumbers().
    [[nodiscard]] watch::NamedNumbers quantitiesNamed(World const& world, std::string const& object) const;

    /// Reads on in the recording; true if frames were read, so that there is something new to see.
    bool read(insight::Recording const& recording);
    /// The same in the recording of a run beside the real one, whose curves are drawn paler.
    bool readOther(insight::Recording const& recording);
    void forgetOther();
    [[nodiscard]] insight::Probes const& other() const { return other_; }
    void forgetAfter(std::uint64_t frame);
    /// The run has ended. The probes stay, for the next one.
    void forget();

    /// Whether the list is open in which the player chooses what to plot.
    [[nodiscard]] bool choosing() const { return choosing_; }
    void setChoosing(bool choosing) { choosing_ = choosing; }
    /// Height of the plots, pixels at UI scale 1; 0 without probes.
    [[nodiscard]] float height() const;
    /// Draws the card of the plots, with the shown frame's values, and returns the frame that the player
    /// points at. `above`: how far from the bottom, pixels at UI scale 1.
    std::optional<std::uint64_t> draw(Layout& layout, float above, std::uint64_t frame, std::uint64_t last);
    /// Draws the card in which the player chooses, for an object by its name; "": none is inspected.
    /// Returns the ending of the file that the player wants, ".csv" or ".svg"; "" if none.
    [[nodiscard]] std::string drawChoice(Layout& layout, World const& world, std::string const& object,
                                         float above);
    [[nodiscard]] std::string csv() const;
    [[nodiscard]] std::string svg(std::uint64_t last) const;

private:
    Registry const& registry_;
    Session const& session_;
    std::vector<watch::WatchedField> fields_; // found on first use
    insight::Probes probes_;
    insight::Probes other_; // the same, of a run beside it
    insight::Stage stage_;
    insight::Stage otherStage_;
    bool choosing_ = false;
    std::array<char, 128> word_{}; // that the player has typed to find a number
    void findFields();
    void drawQuantities(Layout& layout, World const& world, std::string const& object);
    void drawFound(Layout& layout, World const& world, std::string const& object);
    void drawBox(Layout& layout, World const& world, std::string const& name, std::string const& what);
};

} // namespace trembler::ui

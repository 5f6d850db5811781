// The plots: the probes of the run, and those of a run beside it.
#include "game/ui/play/timeline/probe_panel.hpp"

#include "insight/probe/plot.hpp"
#include "insight/probe/watch_table.hpp"
#include "runtime/level/json/diagnostic.hpp"

namespace trembler::ui {
namespace {

using insight::Series;

constexpr int framesReadPerPicture = 300; // that are read

/// Reads on in a recording; true if frames were read.
bool readOn(insight::Probes& probes, insight::Stage& stage, insight::Recording const& recording) {
    if (probes.watches().empty() || !recording.begun()) {
        return false;
    }
    bool any = false;
    for (int i = 0; i < framesReadPerPicture; ++i) {
        // The first of a recording is the one nearest to the beginning.
        auto const next =
            probes.last() ? recording.after(*probes.last()) : std::optional(recording.nearest(0));
        if (!next) {
            break;
        }
        try {
            stage.show(recording, *next);
        } catch (InputError const&) { // the level cannot be built any more; Timeline says so
            break;
        }
        probes.look(stage.world(), *next);
        any = true;
    }
    return any;
}

} // namespace

ProbePanel::ProbePanel(Registry const& registry, Session const& session)
    : registry_(registry), session_(session),
      stage_([&registry, &session] { return insight::buildAgain(registry, session); }),
      otherStage_([&registry, &session] { return insight::buildAgain(registry, session); }) {}

void ProbePanel::findFields() {
    if (fields_.empty()) {
        fields_ = watch::watchedFields(registry_);
    }
}

void ProbePanel::toggle(std::string const& what) {
    toggle(session_.world(), what);
}

void ProbePanel::toggle(World const& world, std::string const& what) {
    findFields();
    if (probes_.has(what)) {
        probes_.remove(what);
        other_.remove(what);
        return;
    }
    for (insight::Probes* const probes : {&probes_, &other_}) {
        probes->add(world, fields_, what);
        probes->clearSamples(); // all are read again, together
    }
}

void ProbePanel::removeAll() {
    probes_ = insight::Probes();
    other_ = insight::Probes();
}

void ProbePanel::forget() {
    probes_.clearSamples();
    stage_.forget();
    forgetOther();
}

void ProbePanel::forgetAfter(std::uint64_t frame) {
    probes_.forgetAfter(frame);
}

bool ProbePanel::read(insight::Recording const& recording) {
    return readOn(probes_, stage_, recording);
}

bool ProbePanel::readOther(insight::Recording const& recording) {
    return readOn(other_, otherStage_, recording);
}

void ProbePanel::forgetOther() {
    other_.clearSamples();
    otherStage_.forget();
}

std::string ProbePanel::csv() const {
    std::string all = watch::csvHeader(probes_.watches()) + "\n";
    std::vector<std::size_t> next(probes_.series().size(), 0);
    for (std::uint64_t const frame : probes_.frames()) { // a row without values, too, as in a WatchTable
        std::vector<watch::Cell> row(next.size());
        for (std::size_t i = 0; i < next.size(); ++i) {
            auto const& samples = probes_.series()[i].samples;
            if (next[i] < samples.size() && samples[next[i]].frame == frame) {
                row[i] = samples[next[i]++].value;
            }
        }
        all += watch::csvRow(frame, row) + "\n";
    }
    return all;
}

std::string ProbePanel::svg(std::uint64_t last) const {
    return insight::plotAsSvg(session_.level().title, probes_.series(), last);
}

} // namespace trembler::ui

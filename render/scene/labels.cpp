#include "render/scene/labels.hpp"

#include "render/scene/facts/look_form.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/objects/body.hpp"

#include <algorithm>

namespace trembler::render {
namespace {

std::size_t characters(std::string_view utf8) {
    return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; // all but continuation bytes
    }));
}

Colour inkOn(Facts const& facts) {
    Style const style = styleOf(facts);
    Colour const ground = style.tint.value_or(colourOf(style.pattern));
    // Luma of Rec. 601; glass shows the paper.
    double const luma = 0.299 * ground.red + 0.587 * ground.green + 0.114 * ground.blue;
    return ground.alpha < 128 || luma > 115 ? palette::ink : palette::paperLight;
}

} // namespace

std::vector<SceneLabel> sceneLabels(World const& world, Poses const& poses, double alpha) {
    std::vector<SceneLabel> labels;
    for (Facts const& facts : FactsReader(world).drawOrder()) {
        LookForm const form = formOf(facts);
        bool const signedAlready = form == LookForm::plus || form == LookForm::minus ||
                                   form == LookForm::battery || form == LookForm::earth ||
                                   facts.shape == nullptr ||
                                   (facts.drawing != nullptr && signOf(facts).has_value());
        if (facts.look == nullptr || facts.look->label.empty() || signedAlready) {
            continue;
        }
        Extent const own = extentOf(*facts.shape, {});
        auto const count = static_cast<double>(characters(facts.look->label));
        double const high = std::min(1.1 * own.half().y, 2 * own.half().x / std::max(0.7 * count, 1.0));
        labels.push_back(
            {toWorld(poses.of(facts, alpha), own.centre()), high, facts.look->label, inkOn(facts)});
    }
    return labels;
}

} // namespace trembler::render

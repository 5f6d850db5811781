// Outlines around objects of the edited scene.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "render/draw/canvas.hpp"
#include "render/scene/facts/poses.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// A closed line through the corners, m.
void outline(render::Canvas& canvas, std::vector<render::Point> corners, render::Stroke const& stroke);
/// Around one object of the world or, if it has no shape, around the sign that stands for it.
void outlineObject(render::Canvas& canvas, render::Facts const& facts, render::Pose const& pose,
                   render::Stroke const& stroke);
/// Around an entry's object; of a composite part, around each of its pieces.
void outlineEntry(render::Canvas& canvas, EditParts const& parts, render::FactsReader const& reader,
                  std::string const& name, render::Stroke const& stroke);

} // namespace trembler::ui

// The shaders' sources, embedded so that the program finds them wherever it is installed.
#pragma once

#include <string_view>

namespace trembler::render::shaders {

extern std::string_view const shapeVertex;   ///< places one quad per shape
extern std::string_view const shapeCommon;   ///< head of the fragment shader: inputs and helpers
extern std::string_view const shapeDistance; ///< signed distances of all kinds of shape
extern std::string_view const shapePattern;  ///< the patterns of surfaces
extern std::string_view const shapeFragment; ///< edge, outline, shading, selection
extern std::string_view const paperVertex;   ///< one triangle over the whole view
extern std::string_view const paperFragment; ///< paper and grid

} // namespace trembler::render::shaders

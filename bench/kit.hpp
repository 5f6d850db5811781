#pragma once

// Headers that most programs include. The tests that compile each program read them only once, precompiled.

#include "bench/measure.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/world/world.hpp"

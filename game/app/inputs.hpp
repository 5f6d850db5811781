// The files of the program that commands read, as inputs that no output may replace.
#pragma once

namespace trembler {

class Outputs;
struct GameData;

/// Registers every part and every level of the program as an input.
void readsAll(Outputs& outputs, GameData const& gameData);

} // namespace trembler

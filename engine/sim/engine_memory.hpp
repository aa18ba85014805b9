#pragma once

namespace fulbito {

/// The engine throws std::bad_alloc where there is no memory. The call itself does nothing: it links the
/// functions that the engine then takes its memory from.
void useCheckedMemory();

}  // namespace fulbito

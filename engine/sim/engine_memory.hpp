#pragma once

namespace fulbito {

/// Makes Box2D throw std::bad_alloc where there is no memory. The call itself does nothing: it links the
/// functions that replace Box2D's own.
void useCheckedMemory();

}  // namespace fulbito

#include "engine/sim/engine_memory.hpp"

#include <cstdlib>
#include <new>

#include <box2d/b2_settings.h>

// Replaces Box2D's function, which returns null where there is no memory, so that Box2D crashes.
void* b2Alloc_Default(int32 size) {
  void* const memory = std::malloc(static_cast<std::size_t>(size));
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void b2Free_Default(void* memory) { std::free(memory); }

namespace fulbito {

void useCheckedMemory() {}

}  // namespace fulbito

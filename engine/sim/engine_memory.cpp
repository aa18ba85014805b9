#include "engine/sim/engine_memory.hpp"

#include <cstdlib>
#include <new>

#include <box2d/b2_settings.h>

// Takes the place of the engine's function, which goes on without the memory and crashes.
void* b2Alloc_Default(int32 size) {
  void* const memory = std::malloc(static_cast<std::size_t>(size));
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void b2Free_Default(void* memory) { std::free(memory); }

namespace fulbito {

void useCheckedMemory() {}

}  // namespace fulbito

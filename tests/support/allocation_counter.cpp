#include "tests/support/allocation_counter.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> count{0};

void* allocateOrNull(std::size_t size) noexcept {
  count.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size > 0 ? size : 1);
}

void* allocateOrNull(std::size_t size, std::align_val_t alignment) noexcept {
  count.fetch_add(1, std::memory_order_relaxed);
  const auto step = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(step, (size + step) / step * step);
}

void* orThrow(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

namespace fulbito::test {
std::uint64_t allocationCount() { return count.load(std::memory_order_relaxed); }
}  // namespace fulbito::test

// All forms, as a sanitizer's own would not go with these deletes.
using Size = std::size_t;
using Align = std::align_val_t;
using Nothrow = const std::nothrow_t&;
void* operator new(Size size) { return orThrow(allocateOrNull(size)); }
void* operator new[](Size size) { return orThrow(allocateOrNull(size)); }
void* operator new(Size size, Align align) { return orThrow(allocateOrNull(size, align)); }
void* operator new[](Size size, Align align) { return orThrow(allocateOrNull(size, align)); }
void* operator new(Size size, Nothrow) noexcept { return allocateOrNull(size); }
void* operator new[](Size size, Nothrow) noexcept { return allocateOrNull(size); }
void* operator new(Size size, Align align, Nothrow) noexcept { return allocateOrNull(size, align); }
void* operator new[](Size size, Align align, Nothrow) noexcept { return allocateOrNull(size, align); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, Size) noexcept { std::free(memory); }
void operator delete[](void* memory, Size) noexcept { std::free(memory); }
void operator delete(void* memory, Align) noexcept { std::free(memory); }
void operator delete[](void* memory, Align) noexcept { std::free(memory); }
void operator delete(void* memory, Size, Align) noexcept { std::free(memory); }
void operator delete[](void* memory, Size, Align) noexcept { std::free(memory); }
void operator delete(void* memory, Nothrow) noexcept { std::free(memory); }
void operator delete[](void* memory, Nothrow) noexcept { std::free(memory); }

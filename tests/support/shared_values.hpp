#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <sys/mman.h>

namespace fulbito::test {

/// Numbers that a process shares with its children, and keeps when they die.
template <typename T, std::size_t kCount = 1>
class SharedValues {
 public:
  SharedValues()
      : place_(
            ::mmap(nullptr, sizeof(T) * kCount, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (place_ == MAP_FAILED) throw std::runtime_error("no memory to share");
  }
  SharedValues(const SharedValues&) = delete;
  SharedValues& operator=(const SharedValues&) = delete;
  ~SharedValues() { ::munmap(place_, sizeof(T) * kCount); }

  T& operator[](std::size_t i) const { return static_cast<T*>(place_)[i]; }

 private:
  void* place_;
};

}  // namespace fulbito::test

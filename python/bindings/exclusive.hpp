#pragma once

#include <atomic>
#include <string>

#include "python/bindings/errors.hpp"

namespace fulbito::python {

/// Finds calls of one object by two threads at once, which the GIL does not prevent while calls give it up.
class Exclusive {
 public:
  /// One call. Throws StateFailure if another goes on.
  class Use {
   public:
    Use(Exclusive& owner, const char* what) : owner_(owner) {
      if (owner_.used_.test_and_set(std::memory_order_acquire))
        throw StateFailure(std::string(what) + " is in use by another thread");
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    ~Use() { owner_.used_.clear(std::memory_order_release); }

   private:
    Exclusive& owner_;
  };

 private:
  std::atomic_flag used_;
};

}  // namespace fulbito::python

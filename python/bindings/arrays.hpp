#pragma once

#include <memory>
#include <nanobind/ndarray.h>
#include <utility>
#include <vector>

namespace fulbito::python {

/// A new NumPy array that owns these values, row by row.
template <typename T>
nanobind::ndarray<nanobind::numpy, T> arrayOf(std::vector<T> values, std::vector<std::size_t> shape) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  T* data = owned->data();
  const nanobind::capsule owner(owned.release(),
                                [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return nanobind::ndarray<nanobind::numpy, T>(data, shape.size(), shape.data(), owner);
}

}  // namespace fulbito::python

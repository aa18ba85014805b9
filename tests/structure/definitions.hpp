#pragma once

#include <string>
#include <vector>

namespace fulbito::test {

/// A type or function that a source file defines for all others.
struct Definition {
  std::string name;  ///< with its namespaces; of a function also with the types of its parameters
  bool is_type = false;
};

/// What a source file's text defines at namespace scope with external linkage. Members, specialisations and
/// what stands in an unnamed namespace are left out.
std::vector<Definition> definitionsIn(const std::string& text);

}  // namespace fulbito::test

#pragma once

#include <string_view>

namespace fulbito {

/// The keeper's program file (keeper/main.cpp), built with the library.
std::string_view keeperImage();

}  // namespace fulbito

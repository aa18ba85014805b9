#pragma once

#include "engine/core/system/shortage.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The error code for an errno of reading or writing: kMachine for a shortage, else kIo (a full disk too).
constexpr ErrorCode ioCode(int error) { return isShortage(error) ? ErrorCode::kMachine : ErrorCode::kIo; }

}  // namespace fulbito

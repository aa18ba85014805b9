#pragma once

#include "engine/core/system/shortage.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The code of an error of reading or writing, by errno. A full disk is the disk's, not the machine's.
constexpr ErrorCode ioCode(int error) { return isShortage(error) ? ErrorCode::kMachine : ErrorCode::kIo; }

}  // namespace fulbito

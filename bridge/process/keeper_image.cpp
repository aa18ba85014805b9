#include "bridge/process/keeper_image.hpp"

// The assembler includes the file, whose path the build defines.
asm(".pushsection .rodata\n"
    ".balign 16\n"
    ".hidden fulbito_keeper_first\n"
    ".globl fulbito_keeper_first\n"
    "fulbito_keeper_first:\n"
    ".incbin \"" FULBITO_KEEPER_FILE
    "\"\n"
    ".hidden fulbito_keeper_last\n"
    ".globl fulbito_keeper_last\n"
    "fulbito_keeper_last:\n"
    ".popsection\n");

extern "C" {
// NOLINTBEGIN(readability-identifier-naming): names of the assembler
extern const char fulbito_keeper_first[] __attribute__((visibility("hidden")));
extern const char fulbito_keeper_last[] __attribute__((visibility("hidden")));
// NOLINTEND(readability-identifier-naming)
}

namespace fulbito {

std::string_view keeperImage() {
  return {fulbito_keeper_first, static_cast<std::size_t>(fulbito_keeper_last - fulbito_keeper_first)};
}

}  // namespace fulbito

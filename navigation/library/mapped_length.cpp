#include "navigation/library/mapped_length.hpp"

#include <algorithm>
#include <cstring>
#include <elf.h>
#include <fstream>
#include <limits>

namespace fulbito {
namespace {

template <typename T>
bool readAt(std::ifstream& in, std::uint64_t place, T& value) {
  in.seekg(static_cast<std::streamoff>(place));
  return static_cast<bool>(in.read(reinterpret_cast<char*>(&value), sizeof value));
}

bool isOurs(const Elf64_Ehdr& header) {
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS64 &&
         header.e_ident[EI_DATA] == ELFDATA2LSB && header.e_phentsize == sizeof(Elf64_Phdr);
}

}  // namespace

std::uint64_t mappedLength(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  Elf64_Ehdr header{};
  if (!readAt(in, 0, header) || !isOurs(header)) return 0;
  std::uint64_t length = header.e_phoff + std::uint64_t{header.e_phnum} * sizeof(Elf64_Phdr);
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    if (!readAt(in, header.e_phoff + i * sizeof segment, segment)) break;
    const std::uint64_t end = segment.p_offset + segment.p_filesz;
    if (end < segment.p_offset) return std::numeric_limits<std::uint64_t>::max();
    if (segment.p_type == PT_LOAD) length = std::max(length, end);
  }
  return length;
}

}  // namespace fulbito

#include "bridge/process/keeper/order.hpp"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/core/system/shortage.hpp"

namespace fulbito::keeper {

Order readOrder() {
  struct stat status{};
  if (::fstat(kPageDescriptor, &status) != 0 || status.st_size < static_cast<off_t>(sizeof(Page)))
    ::_exit(125);
  const auto size = static_cast<std::size_t>(status.st_size);
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, kPageDescriptor, 0);
  if (memory == MAP_FAILED) ::_exit(125);
  Order order;
  order.page = static_cast<Page*>(memory);
  if (order.page->text_size != size - sizeof(Page)) ::_exit(125);
  const char* next = static_cast<const char*>(memory) + sizeof(Page);
  const char* const last = static_cast<const char*>(memory) + size;
  const auto word = [&] {
    const std::size_t length = ::strnlen(next, static_cast<std::size_t>(last - next));
    std::string text(next, length);
    next += next + length < last ? length + 1 : length;
    return text;
  };
  order.program = word();
  order.own_folder = word();
  order.base_folder = word();
  order.path = word();
  order.language = word();
  order.home = word();
  for (std::uint32_t k = 0; k < order.page->readable; ++k) order.readable.push_back(word());
  for (std::uint32_t k = 0; k < order.page->arguments; ++k) order.arguments.push_back(word());
  return order;
}

void reached(Order& order, const char* layer) { order.page->layers.add(std::string(layer) + "\n"); }

void lacks(Order& order, const char* layer, const std::string& why, int error) {
  if (isShortage(error)) giveUp(order, ("contain it by " + std::string(layer)).c_str(), error);
  std::string text = std::string(layer) + ": " + why;
  if (error != 0) text += std::string(": ") + ::strerror(error);
  order.page->missing.add(text + "\n");
}

void failed(Order& order, const char* step, int error) {
  order.page->error = error;
  order.page->step.set(step);
}

void giveUp(Order& order, const char* step, int error) {
  failed(order, step, error);
  ::_exit(125);
}

}  // namespace fulbito::keeper

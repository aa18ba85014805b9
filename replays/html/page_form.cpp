#include "replays/html/page_form.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "replays/html/base64.hpp"

namespace fulbito {

std::string_view textOfFile(std::span<const EmbeddedFile> files, std::string_view name) {
  const auto found = std::find_if(files.begin(), files.end(), [&](const auto& f) { return f.name == name; });
  return found == files.end() ? std::string_view{} : found->text;
}

std::string filledForm(std::string_view form,
                       const std::vector<std::pair<std::string_view, std::string>>& texts) {
  std::string out;
  while (!form.empty()) {
    const std::size_t open = form.find("{{"), close = form.find("}}", open);
    out += form.substr(0, open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    const std::string_view name = form.substr(open + 2, close - open - 2);
    for (const auto& [known, text] : texts) {
      if (known == name) out += text;
    }
    form.remove_prefix(close + 2);
  }
  return out;
}

std::string allowedDigest(std::string_view digest) {
  return fmt::format("'sha256-{}'", base64Of(bytesOfHex(digest)));
}

}  // namespace fulbito

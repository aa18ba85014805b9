#include "apps/common/output_kinds.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

#include "engine/core/system/output_file.hpp"
#include "engine/core/system/regular_file.hpp"

namespace fulbito::app {
namespace {

/// The properties of a kind of output. For kinds that never replace a file without --force, other kinds of
/// files may have the same `beginning`.
struct Known {
  OutputKind kind;
  const char* words;
  std::string_view ending;
  std::string_view beginning;
};

constexpr std::array kKnown{
    Known{OutputKind::kRecording, "a recording", ".fbr",
          "\x89"
          "FBR\r\n\x1a\n"},
    Known{OutputKind::kPng, "a PNG picture", ".png", "\x89PNG\r\n\x1a\n"},
    Known{OutputKind::kGif, "a GIF animation", ".gif", "GIF8"},
    Known{OutputKind::kSvg, "an SVG drawing", ".svg", "<svg "},
    Known{OutputKind::kMp4, "an MP4 video", ".mp4", std::string_view("\0\0\0 ftyp", 8)},
    Known{OutputKind::kWebm, "a WebM video", ".webm", "\x1a\x45\xdf\xa3"},
    Known{OutputKind::kPage, "an HTML page of this program", ".html", "<!doctype html>\n<!-- Fulbito -->"},
    Known{OutputKind::kCsv, "a CSV table", ".csv", "pair,leg,counts,round,id,"},
    Known{OutputKind::kMarkdown, "a Markdown report of a tournament", ".md", "<!-- Fulbito -->\n"},
    Known{OutputKind::kJunit, "a JUnit report", ".xml",
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite"},
    Known{OutputKind::kJsonLines, "a file of JSON lines", ".jsonl", "{\"schema_version\":"}};

const Known& knownOf(OutputKind kind) {
  return *std::find_if(kKnown.begin(), kKnown.end(), [kind](const Known& k) { return k.kind == kind; });
}

std::string_view firstLine(std::string_view text) { return text.substr(0, text.find('\n')); }

}  // namespace

const char* wordsOf(OutputKind kind) { return knownOf(kind).words; }

std::string_view beginningOf(OutputKind kind) { return knownOf(kind).beginning; }

std::optional<OutputKind> kindOfName(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".htm") ending = ".html";
  const auto* const found =
      std::find_if(kKnown.begin(), kKnown.end(), [&](const Known& k) { return k.ending == ending; });
  return found == kKnown.end() ? std::nullopt : std::optional(found->kind);
}

std::string headOf(const std::string& file) {
  const auto opened = RegularFile::open("read", file, O_RDONLY);
  if (!opened) return {};
  std::string head(kHeadOfFile, '\0');
  const ssize_t count = ::pread(opened->descriptor(), head.data(), head.size(), 0);
  head.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return head;
}

bool isOfKind(std::string_view head, OutputKind kind) { return head.starts_with(beginningOf(kind)); }

bool sameKind(std::string_view head, std::string_view other) {
  for (const Known& known : kKnown) {
    if (other.starts_with(known.beginning)) return head.starts_with(known.beginning);
  }
  // The first line of a JSON object does not identify its kind.
  if (other.starts_with(kObjectBeginning)) return head.starts_with(kObjectBeginning);
  // Of a table, only the first column counts, because other columns may depend on settings.
  const auto mark = [](std::string_view line) { return line.substr(0, line.find(',')); };
  return mark(firstLine(head)) == mark(firstLine(other));
}

bool keepsResults(std::string_view head) {
  const std::string_view line = firstLine(head);
  if (line.starts_with("{\"schema_version\":") && line.ends_with("\"content\":\"matches\"}")) return true;
  if (!head.starts_with(kObjectBeginning)) return false;
  const std::string_view second = head.substr(2), rest = second.substr(firstLine(second).size());
  return rest.starts_with("\n  \"plan\": {") || rest.starts_with("\n  \"tune\": {");
}

}  // namespace fulbito::app

#pragma once

#include <set>
#include <string>
#include <sys/types.h>
#include <utility>

namespace fulbito::app {

/// The files that a command may read, found from the words of its command line. It may contain files that are
/// not read; the only effect is that outputs do not replace them.
class InputFiles {
 public:
  /// Adds the files that a word names: files; the files of a folder; names within a longer word such as
  /// "cmd:python3 team.py" or "bezier:file=a.toml"; the files that TOML files among these name; and the
  /// `team.toml` next to each.
  void addWord(const std::string& word);
  /// Whether `file` is one of these files, also under another name.
  bool has(const std::string& file) const;

 private:
  void addParts(const std::string& word, const std::string& folder);
  void addName(const std::string& name);
  void addFile(const std::string& name);
  void addNamesIn(const std::string& toml);

  std::set<std::pair<dev_t, ino_t>> files_;
};

}  // namespace fulbito::app

#include "tests/structure/citations.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace fulbito::test {
namespace {

constexpr std::array<std::string_view, 6> kPages = {"GAME-RULES",       "RULES-VSSS",
                                                    "BOX2D-FACTS",      "NAVIGATION-BENCH",
                                                    "FIRASIM-PROTOCOL", "TOURNAMENT-AND-REPLAY"};
/// Pages when a section's number follows; alone they may name the arguments of a command.
constexpr std::array<std::string_view, 3> kSections = {"STRATEGY ", "NAVIGATION ", "PHYSICS "};
constexpr std::array<std::string_view, 6> kPhrases = {"reference page", "strategy page", "paper 0",
                                                      "Paper 0",        "papers 0",      "paper-0"};

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool isOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

/// Numbers of private lists: a letter with one or two digits (suites N, misprints E), or R, a digit and a
/// letter (rows).
bool isPrivateNumber(std::string_view word) {
  if (word.size() < 2 || !isDigit(word[1]) || word[1] == '0') return false;
  if (word[0] == 'R') return word.size() == 4 && word[2] == '-' && std::islower(word[3]) != 0;
  return (word[0] == 'N' || word[0] == 'E') && (word.size() == 2 || (word.size() == 3 && isDigit(word[2])));
}

/// The longest words of characters that `belongs` accepts.
template <typename Belongs>
std::vector<std::string> wordsOf(const std::string& line, const Belongs& belongs) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i;
    while (end < line.size() && belongs(line[end])) ++end;
    if (end > i) words.push_back(line.substr(i, end - i));
    i = end + 1;
  }
  return words;
}

}  // namespace

std::vector<std::string> privateCitationsIn(const std::string& line) {
  std::vector<std::string> found;
  for (const std::string& word : wordsOf(line, isOfWord)) {
    if (isPrivateNumber(word) || std::find(kPages.begin(), kPages.end(), word) != kPages.end())
      found.push_back(word);
  }
  for (const std::string_view page : kSections) {
    const std::size_t end = line.find(page) + page.size();
    if (line.find(page) != std::string::npos && end < line.size() && isDigit(line[end]))
      found.emplace_back(page.substr(0, page.size() - 1));
  }
  for (const std::string_view phrase : kPhrases) {
    if (line.find(phrase) != std::string::npos) found.emplace_back(phrase);
  }
  return found;
}

std::vector<std::string> pagesNamedIn(const std::string& line) {
  std::vector<std::string> pages = wordsOf(line, [](char c) { return isOfWord(c) || c == '.' || c == '/'; });
  std::erase_if(pages, [](std::string& word) {
    while (word.ends_with('.')) word.pop_back();
    return !word.ends_with(".md") || word.size() == 3;
  });
  return pages;
}

}  // namespace fulbito::test

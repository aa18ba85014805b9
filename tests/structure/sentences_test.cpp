#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/structure/pages.hpp"
#include "tests/structure/text_of.hpp"
#include "tests/support/catch.hpp"

// A reader takes in a sentence of up to 25 words at once. Longer ones become several sentences, a list or a
// row of a table.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostWords = 25;

/// Pages with longer sentences. This list is to be emptied: rewrite a page, then remove it here.
const std::set<std::string> kPagesWithLongerSentences{
    "docs/recordings.md",
    "docs/results/hybrid.md",
};

/// A part of a page under one heading that has longer sentences; this list is to be emptied too.
struct Part {
  std::string_view page;
  std::string_view heading;
};
constexpr std::array kPartsWithLongerSentences = {Part{"docs/navigators.md", "### hybrid"}};

/// A piece of text that its line breaks do not end: a paragraph, an item of a list or a cell of a table.
struct Passage {
  std::size_t line = 0;  ///< the first one
  std::string heading;   ///< that it stands under
  std::string text;
};

struct Sentence {
  std::size_t line = 0;
  std::size_t words = 0;
  std::string heading;
  std::string text;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// Whether a line begins an item of a list: `- `, `* ` or `12. `.
bool beginsItem(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view mark = text.substr(digits, 2);
  return digits == 0 ? mark == "- " || mark == "* " : mark == ". ";
}

/// The passages of a page in Markdown; headings, blocks of code and lines of comments are none.
std::vector<Passage> passagesOf(const std::string& page) {
  std::vector<Passage> passages;
  std::string heading;
  std::istringstream lines(page);
  std::size_t number = 0;
  bool code = false;
  bool goes_on = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string_view text = trimmed(line);
    const bool mark = text.starts_with("```");
    if (mark) code = !code;
    if (!code && text.starts_with('#')) heading = text;
    if (code || mark || text.empty() || text.starts_with('#') || text.starts_with("<!--")) {
      goes_on = false;
    } else if (text.starts_with('|')) {
      std::istringstream cells{std::string(text)};
      for (std::string cell; std::getline(cells, cell, '|');) passages.push_back({number, heading, cell});
      goes_on = false;
    } else if (goes_on && !beginsItem(text)) {
      passages.back().text.append("\n").append(text);
    } else {
      passages.push_back({number, heading, std::string(text)});
      goes_on = true;
    }
  }
  return passages;
}

/// The first place after a code span or the target of a link that begins at `at`; `at` if none does.
std::size_t endOfMarkup(const std::string& text, std::size_t at) {
  const bool code = text[at] == '`';
  if (!code && text.compare(at, 2, "](") != 0) return at;
  const std::size_t end = text.find(code ? '`' : ')', at + 1);
  return end == std::string::npos ? at : end + 1;
}

/// Whether a link's or a picture's text begins at `at`.
bool beginsLink(const std::string& text, std::size_t at) {
  const std::size_t end = text[at] == '[' ? text.find(']', at) : std::string::npos;
  return end != std::string::npos && text.compare(end, 2, "](") == 0;
}

/// The text as it is read: one word for each code span, and a link's text for the link.
std::string plainOf(const std::string& text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t mark = std::min(text.find_first_of("`[]", at), text.size());
    plain.append(text, at, mark - at);
    at = mark;
    if (at == text.size()) break;
    const std::size_t end = endOfMarkup(text, at);
    if (end == at) {
      if (!beginsLink(text, at)) plain += text[at];
      ++at;
      continue;
    }
    if (text[at] == '`') plain += "CODE";
    const auto from = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto to = text.begin() + static_cast<std::ptrdiff_t>(end);
    plain.append(static_cast<std::size_t>(std::count(from, to, '\n')), '\n');
    at = end;
  }
  return plain;
}

/// Whether a word has a letter or a digit, so that signs such as `-` or `≤` count as none. Of letters
/// beyond ASCII it knows the Latin and Greek ones.
bool isWord(const std::string& word) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    const auto byte = static_cast<unsigned char>(word[i]);
    if (std::isalnum(byte) != 0 || byte == '_') return true;
    if ((byte >= 0xC4 && byte <= 0xC9) || (byte >= 0xCD && byte <= 0xCF)) return true;
    if (byte == 0xC3 && word.compare(i, 2, "×") != 0 && word.compare(i, 2, "÷") != 0) return true;
  }
  return false;
}

std::size_t wordsOf(const std::string& sentence) {
  std::istringstream words(sentence);
  std::size_t count = 0;
  for (std::string word; words >> word;) count += isWord(word) ? 1 : 0;
  return count;
}

/// Where the sentence that begins at `begin` ends: after `.`, `!` or `?` that a space and a capital letter or
/// a mark of Markdown follow.
std::size_t endOfSentence(const std::string& text, std::size_t begin) {
  for (std::size_t end = text.find_first_of(".!?", begin); end < text.size();
       end = text.find_first_of(".!?", end + 1)) {
    const std::size_t next = text.find_first_not_of(" \n", end + 1);
    if (next == std::string::npos) break;
    const char first = text[next];
    const bool begins =
        (first >= 'A' && first <= 'Z') || std::string_view("`*([").find(first) != std::string_view::npos;
    if (next > end + 1 && begins) return end + 1;
  }
  return text.size();
}

std::vector<Sentence> sentencesOf(const std::string& page) {
  std::vector<Sentence> sentences;
  for (const Passage& passage : passagesOf(page)) {
    const std::string plain = plainOf(passage.text);
    std::size_t line = passage.line;
    for (std::size_t begin = 0, end = 0; begin < plain.size(); begin = end) {
      end = endOfSentence(plain, begin);
      std::string text = plain.substr(begin, end - begin);
      const auto breaks = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
      const std::size_t first = line + (text.starts_with('\n') ? 1 : 0);
      std::replace(text.begin(), text.end(), '\n', ' ');
      sentences.push_back({first, wordsOf(text), passage.heading, std::string(trimmed(text))});
      line += breaks;
    }
  }
  return sentences;
}

std::vector<Sentence> longSentencesOf(const std::string& page) {
  std::vector<Sentence> sentences = sentencesOf(page);
  std::erase_if(sentences, [](const Sentence& sentence) { return sentence.words <= kMostWords; });
  return sentences;
}

bool isExcepted(const std::string& page, const std::string& heading) {
  return kPagesWithLongerSentences.count(page) == 1 ||
         std::any_of(kPartsWithLongerSentences.begin(), kPartsWithLongerSentences.end(),
                     [&](const Part& part) { return part.page == page && part.heading == heading; });
}

std::string repeated(const std::string& word, std::size_t times) {
  std::string words;
  for (std::size_t i = 0; i < times; ++i) words += word;
  return words;
}

}  // namespace

TEST_CASE("a sentence of the pages has at most 25 words", "[unit]") {
  const std::vector<fs::path> files = pages();
  CHECK(files.size() > 40);
  for (const fs::path& file : files) {
    const std::string page = file.lexically_relative(FULBITO_SOURCE_DIR);
    for (const Sentence& sentence : longSentencesOf(textOf(file))) {
      if (isExcepted(page, sentence.heading)) continue;
      FAIL_CHECK(page << ":" << sentence.line << " has " << sentence.words << " words: " << sentence.text);
    }
  }
}

TEST_CASE("a long sentence is found with its line, and nothing else is", "[unit]") {
  const std::string most = repeated("word ", kMostWords - 1);
  CHECK(longSentencesOf("# One\n\n" + most + "end.\n").empty());
  const std::vector<Sentence> found = longSentencesOf("# One\n\nShort.\nThe " + most + "end\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].line == 4);
  CHECK(found[0].words == kMostWords + 1);
  CHECK(found[0].heading == "# One");
  CHECK(found[0].text == "The " + most + "end");
}

TEST_CASE("what counts as a sentence and as a word", "[unit]") {
  const std::string half = repeated("word ", 20);
  const auto found = [](const std::string& page) { return longSentencesOf(page).size(); };
  // Items, cells and paragraphs are apart; line breaks, semicolons and numbers do not end a sentence.
  CHECK(found("- " + half + "\n- " + half + "\n2. " + half + "\n") == 0);
  CHECK(found("| " + half + " | " + half + " |\n") == 0);
  CHECK(found(half + "\n\n" + half + "\n") == 0);
  CHECK(found(half + "\n" + half + "\n") == 1);
  CHECK(found("- " + half + "\n  " + half + "\n") == 1);
  CHECK(found("| one | " + half + half + " |\n") == 1);
  CHECK(found(half + "; " + half) == 1);
  CHECK(found(half + "0.5 m " + half) == 1);
  CHECK(found(half + "e.g. " + half) == 1);
  CHECK(found(half + "ends. Then " + half) == 0);
  CHECK(found(half + "ends! `Code` " + half) == 0);
  // Code, comments and headings are no sentences.
  CHECK(found("```\n" + half + half + "\n```\n") == 0);
  CHECK(found("# " + half + half + "\n<!-- " + half + half + " -->\n") == 0);
  // A code span is one word, a link its text, and signs are none.
  CHECK(found("`" + half + half + "` `" + half + "\n" + half + "`\n") == 0);
  CHECK(found("[" + half + "](a/b#c) [five more words are here](d)\n") == 0);
  CHECK(found("[" + half + "](a/b#c) [six more words are here now](d)\n") == 1);
  CHECK(found(half + repeated("– ≤ × ", 20)) == 0);
  CHECK(found(half + repeated("ρ ", 5)) == 0);
  CHECK(found(half + repeated("ρ ", 6)) == 1);
}

}  // namespace fulbito::test

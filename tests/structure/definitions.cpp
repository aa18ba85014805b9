#include "tests/structure/definitions.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace fulbito::test {
namespace {

using Tokens = std::vector<std::string>;

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The end of the literal whose quote is at `at`.
std::size_t endOfLiteral(const std::string& text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size() && text[at] != quote; ++at) at += text[at] == '\\' ? 1 : 0;
  return at + 1;
}

/// The end of the raw string whose quote is at `at`.
std::size_t endOfRawString(const std::string& text, std::size_t at) {
  const std::size_t open = text.find('(', at);
  const std::string close = ")" + text.substr(at + 1, open - at - 1) + "\"";
  return text.find(close, open) + close.size();
}

/// The end of the preprocessor's lines that begin at `at`.
std::size_t endOfDirective(const std::string& text, std::size_t at) {
  std::size_t end = text.find('\n', at);
  while (end != std::string::npos && text[end - 1] == '\\') end = text.find('\n', end + 1);
  return std::min(end, text.size());
}

/// The end of a number, a word or a sign that begins at `at`; digits may have quotes between them.
std::size_t endOfToken(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "::") == 0) return at + 2;
  const bool number = std::isdigit(static_cast<unsigned char>(text[at])) != 0;
  std::size_t end = at + 1;
  if (!isWord(text[at])) return end;
  while (end < text.size() && (isWord(text[end]) || (number && text[end] == '\''))) ++end;
  return end;
}

/// Identifiers, `::` and single signs, without comments, literals and preprocessor lines.
Tokens tokensOf(const std::string& text) {
  Tokens tokens;
  bool line_begins = true;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.compare(at, 2, "/*") == 0) {
      at = text.find("*/", at) + 2;
    } else if (text.compare(at, 2, "R\"") == 0) {
      at = endOfRawString(text, at + 1);
    } else if (c == '"' || c == '\'') {
      at = endOfLiteral(text, at);
    } else if (c == '#' && line_begins) {
      at = endOfDirective(text, at);
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      line_begins = line_begins || c == '\n';
      ++at;
    } else {
      const std::size_t end = endOfToken(text, at);
      tokens.push_back(text.substr(at, end - at));
      at = end;
      line_begins = false;
    }
  }
  return tokens;
}

bool has(const Tokens& tokens, const std::string& word) {
  return std::find(tokens.begin(), tokens.end(), word) != tokens.end();
}

bool isIdentifier(const std::string& token) {
  return std::isalpha(static_cast<unsigned char>(token[0])) != 0 || token[0] == '_';
}

/// `tokens` without `template <...>` in front.
Tokens withoutTemplate(Tokens tokens) {
  while (!tokens.empty() && tokens.front() == "template") {
    std::size_t end = 1;
    int depth = 0;
    do {
      depth += tokens[end] == "<" ? 1 : tokens[end] == ">" ? -1 : 0;
      ++end;
    } while (depth > 0 && end < tokens.size());
    tokens.erase(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return tokens;
}

/// The name of a type that `head` begins to define; empty where it defines none.
std::string typeName(const Tokens& head) {
  static const std::vector<std::string> kKeys = {"struct", "class", "enum", "union"};
  const auto is_key = [](const std::string& t) {
    return std::find(kKeys.begin(), kKeys.end(), t) != kKeys.end();
  };
  auto at = std::find_if(head.begin(), head.end(), is_key);
  if (at == head.end() || std::find(head.begin(), at, "(") != at) return {};
  while (at != head.end() && is_key(*at)) ++at;
  std::string name;
  for (; at != head.end() && (isIdentifier(*at) || *at == "::") && *at != "final"; ++at) name += *at;
  const bool specialised = at != head.end() && *at == "<";
  const bool result_type = at != head.end() && *at == "(";
  return specialised || result_type ? std::string() : name;
}

/// One parameter's type: its tokens without default value and, where another token precedes it, its name.
std::string parameterType(Tokens tokens) {
  tokens.erase(std::find(tokens.begin(), tokens.end(), "="), tokens.end());
  const bool named = tokens.size() > 1 && isIdentifier(tokens.back()) && tokens[tokens.size() - 2] != "::" &&
                     tokens[tokens.size() - 2] != "const";
  if (named) tokens.pop_back();
  std::string type;
  for (const std::string& t : tokens) type += (type.empty() ? "" : " ") + t;
  return type;
}

/// The types of the parameters whose list begins at `open`, the place of its bracket.
std::string parameterTypes(const Tokens& head, std::size_t open) {
  std::string types;
  Tokens parameter;
  int depth = 0;
  for (std::size_t i = open + 1; i < head.size(); ++i) {
    const std::string& t = head[i];
    if (depth == 0 && (t == ")" || t == ",")) {
      types += (types.empty() ? "" : ", ") + parameterType(parameter);
      parameter.clear();
      if (t == ")") break;
      continue;
    }
    depth += t == "(" || t == "<" ? 1 : t == ")" || t == ">" ? -1 : 0;
    parameter.push_back(t);
  }
  return types;
}

/// The name and parameter types of a free function that `head` begins to define; empty where it defines none.
std::string functionName(const Tokens& head) {
  if (has(head, "static")) return {};
  const auto open = static_cast<std::size_t>(std::find(head.begin(), head.end(), "(") - head.begin());
  if (open == head.size() || open == 0 ||
      has({head.begin(), head.begin() + static_cast<std::ptrdiff_t>(open)}, "="))
    return {};
  std::size_t begin = open - 1;
  const auto is_operator =
      std::find(head.begin(), head.begin() + static_cast<std::ptrdiff_t>(open), "operator");
  if (is_operator != head.begin() + static_cast<std::ptrdiff_t>(open)) {
    begin = static_cast<std::size_t>(is_operator - head.begin());
  } else if (!isIdentifier(head[begin])) {
    return {};
  }
  if (begin == 0 || head[begin - 1] == "::") return {};  // a constructor, a macro or a member
  std::string name;
  for (std::size_t i = begin; i < open; ++i) name += head[i];
  return name + "(" + parameterTypes(head, open) + ")";
}

/// Walks the tokens, keeping track of the namespaces around.
class Walk {
 public:
  explicit Walk(const Tokens& tokens) : tokens_(tokens) {}

  std::vector<Definition> run() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) step(tokens_[at_]);
    return std::move(found_);
  }

 private:
  void step(const std::string& token) {
    if (token == "{") {
      open();
    } else if (token == "}") {
      if (!namespaces_.empty()) namespaces_.pop_back();
      head_.clear();
    } else if (token == ";") {
      head_.clear();
    } else {
      head_.push_back(token);
    }
  }

  void open() {
    const auto brackets =
        std::count(head_.begin(), head_.end(), "(") - std::count(head_.begin(), head_.end(), ")");
    if (brackets > 0) return skipBraces();
    if (has(head_, "namespace")) {
      std::string name;
      for (auto t = std::find(head_.begin(), head_.end(), "namespace") + 1; t != head_.end(); ++t) name += *t;
      namespaces_.push_back(name);
    } else if (head_.size() == 1 && head_.front() == "extern") {
      namespaces_.push_back("extern C");
    } else {
      note();
      skipBraces();
    }
    head_.clear();
  }

  void note() {
    if (has(namespaces_, "")) return;
    const Tokens head = withoutTemplate(head_);
    const std::string type = typeName(head);
    const std::string name = type.empty() ? functionName(head) : type;
    if (name.empty()) return;
    std::string scope;
    for (const std::string& space : namespaces_) scope += space + "::";
    found_.push_back({scope + name, !type.empty()});
  }

  void skipBraces() {
    int depth = 0;
    for (; at_ < tokens_.size(); ++at_) {
      depth += tokens_[at_] == "{" ? 1 : tokens_[at_] == "}" ? -1 : 0;
      if (depth == 0) return;
    }
  }

  const Tokens& tokens_;
  std::size_t at_ = 0;
  Tokens head_;
  std::vector<std::string> namespaces_;
  std::vector<Definition> found_;
};

}  // namespace

std::vector<Definition> definitionsIn(const std::string& text) {
  const Tokens tokens = tokensOf(text);
  return Walk(tokens).run();
}

}  // namespace fulbito::test

#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace fulbito::test {

/// Names that try to inject markup into a report.
inline std::vector<std::string> hostileNames() {
  return {"<script>alert(1)</script>",
          "\xe2\x80\xae"
          "drawkcab\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d",
          std::string(10000, 'x'),
          "a\n::error::b%0A\r\n\x1b[31m\x07",
          "\"><img src=x onerror=alert(1)>",
          "|--|`]]>&#x3c;{{style}}",
          "\xff\xfe\xc0\xaf",
          "=cmd|' /C calc'!A0"};
}

/// Checks that elements nest, attributes are quoted, and text has neither unescaped markup nor control
/// characters. An element without an end tag is a flaw unless `may_lack_end` names it, as HTML allows some.
/// @return a description of the first flaw; empty if there is none
inline std::string flawOfMarkup(const std::string& xml, const std::vector<std::string>& may_lack_end = {}) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size();) {
    const auto code = static_cast<unsigned char>(xml[i]);
    if (code < 32 && code != '\n') return "a control character at " + std::to_string(i);
    if (xml[i] == '&') {
      const std::size_t end = xml.find(';', i);
      const std::string entity = end == std::string::npos ? "" : xml.substr(i, end - i + 1);
      if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;" && entity != "&quot;" &&
          entity != "&#39;") {
        return "a bare & at " + std::to_string(i);
      }
    }
    if (xml[i] != '<') {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    char quote = 0;
    for (; end < xml.size() && (quote != 0 || xml[end] != '>'); ++end) {
      if (quote != 0 && xml[end] == '<') return "< in an attribute at " + std::to_string(end);
      if (xml[end] == '"') quote = quote == 0 ? '"' : static_cast<char>(0);
    }
    if (end == xml.size()) return "a tag without an end";
    const std::string tag = xml.substr(i + 1, end - i - 1);
    const std::string name =
        tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" \n/>", 1) - (tag[0] == '/' ? 1 : 0));
    i = end + 1;
    if (tag[0] == '?' || tag[0] == '!') continue;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != name)
        return "</" + name + "> in " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (tag.back() != '/' &&
               std::find(may_lack_end.begin(), may_lack_end.end(), name) == may_lack_end.end()) {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> without an end";
}

}  // namespace fulbito::test

#include "support/text_variants.hpp"

namespace fingerpad::test {
namespace {

using namespace std::string_literals;

std::string utf16(const std::string& text, bool mark) {
  std::string out = mark ? "\xff\xfe" : "";
  for (const char c : text) out += {c, '\0'};
  return out;
}

}  // namespace

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string mixed_ends(const std::string& text) {
  const char* ends[] = {"\n", "\r\n", "\r"};
  std::string out;
  int line = 0;
  for (const char c : text) c == '\n' ? out += ends[line++ % 3] : out += c;
  return out;
}

const std::vector<TextVariant>& text_variants() {
  static const std::vector<TextVariant> variants{
      {"mark", [](const std::string& t) { return "\xef\xbb\xbf" + t; }, true},
      {"mark and CR LF", [](const std::string& t) { return "\xef\xbb\xbf" + replaced(t, "\n", "\r\n"); },
       true},
      {"mark and CR", [](const std::string& t) { return "\xef\xbb\xbf" + replaced(t, "\n", "\r"); }, true},
      {"CR LF", [](const std::string& t) { return replaced(t, "\n", "\r\n"); }, true},
      {"CR", [](const std::string& t) { return replaced(t, "\n", "\r"); }, true},
      {"CR CR LF", [](const std::string& t) { return replaced(t, "\n", "\r\r\n"); }, true},
      {"mixed ends", mixed_ends, true},
      {"tabs", [](const std::string& t) { return replaced(t, " ", "\t"); }, true},
      {"form feeds between words", [](const std::string& t) { return replaced(t, " ", " \f"); }, true},
      {"vertical tabs between words", [](const std::string& t) { return replaced(t, " ", " \v"); }, true},
      {"form feeds before ends", [](const std::string& t) { return replaced(t, "\n", "\f\n"); }, true},
      {"form feeds for ends", [](const std::string& t) { return replaced(t, "\n", "\f"); }, false},
      {"vertical tabs for ends", [](const std::string& t) { return replaced(t, "\n", "\v"); }, false},
      {"a form feed for every second end",
       [](const std::string& t) {
         std::string out;
         int line = 0;
         for (const char c : t) out += c == '\n' && line++ % 2 == 1 ? '\f' : c;
         return out;
       },
       false},
      {"blanks before ends", [](const std::string& t) { return replaced(t, "\n", " \t\n"); }, true},
      {"blank lines between", [](const std::string& t) { return replaced(t, "\n", "\n\n"); }, true},
      {"blank lines first", [](const std::string& t) { return "\n\r\n\n" + t; }, false},
      {"no last end", [](const std::string& t) { return t.substr(0, t.size() - 1); }, true},
      {"Ctrl-Z", [](const std::string& t) { return t + "\x1a"; }, true},
      {"many a Ctrl-Z", [](const std::string& t) { return t + std::string(90, '\x1a'); }, true},
      {"a mark within",
       [](const std::string& t) {
         return t.substr(0, t.find('\n') + 1) + "\xef\xbb\xbf" + t.substr(t.find('\n') + 1);
       },
       false},
      {"wide blanks", [](const std::string& t) { return replaced(t, " ", "\xc2\xa0"); }, false},
      {"line separators of Unicode", [](const std::string& t) { return replaced(t, "\n", "\xe2\x80\xa8"); },
       false},
      {"a zero byte first", [](const std::string& t) { return "\0"s + t; }, false},
      {"a zero byte last", [](const std::string& t) { return t + "\0"s; }, false},
      {"UTF-16", [](const std::string& t) { return utf16(t, true); }, false},
      {"UTF-16 without a mark", [](const std::string& t) { return utf16(t, false); }, false},
  };
  return variants;
}

}  // namespace fingerpad::test

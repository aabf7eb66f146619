#include "bt_core/base/plain.h"

#include <cstddef>

namespace coppice {
namespace {

unsigned char ByteOf(char c) { return static_cast<unsigned char>(c); }

std::string HexOf(unsigned char byte) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  return {kDigits[byte >> 4], kDigits[byte & 0xF]};
}

// Its second byte, behind 0xC2.
bool EndsC1(char c) { return ByteOf(c) >= 0x80 && ByteOf(c) < 0xA0; }

}  // namespace

std::string Plain(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\xC2' && i + 1 < text.size() && EndsC1(text[i + 1])) {
      plain += "\\u00" + HexOf(ByteOf(text[++i]));
    } else if (c == '\x7F') {
      plain += "\\u007F";
    } else if (ByteOf(c) < 0x20 && c != '\n' && c != '\t') {
      plain += "\\x" + HexOf(ByteOf(c));
    } else {
      plain += c;
    }
  }
  return plain;
}

std::string PlainLine(std::string_view text) {
  std::string line;
  for (const char c : Plain(text)) {
    if (c == '\n') {
      line += "\\n";
    } else {
      line += c;
    }
  }
  return line;
}

}  // namespace coppice

#include "bt_core/model/xml_text.h"

#include <algorithm>
#include <cstdint>

namespace coppice {
namespace {

// One character, or several bytes of one, as it stands in the raw text and what it stands for.
struct Piece {
  std::size_t raw_length = 1;
  char bytes[4] = {};
  std::size_t length = 1;
};

struct NamedReference {
  std::string_view text;
  char character;
};
constexpr NamedReference kNamed[] = {
    {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};

void EncodeUtf8(std::uint32_t code, Piece& piece) {
  const auto tail = [code](int shift) {
    return static_cast<char>(0x80U | ((code >> static_cast<unsigned>(shift)) & 0x3FU));
  };
  if (code < 0x80) {
    piece.length = 1;
    piece.bytes[0] = static_cast<char>(code);
  } else if (code < 0x800) {
    piece.length = 2;
    piece.bytes[0] = static_cast<char>(0xC0U | (code >> 6U));
    piece.bytes[1] = tail(0);
  } else if (code < 0x10000) {
    piece.length = 3;
    piece.bytes[0] = static_cast<char>(0xE0U | (code >> 12U));
    piece.bytes[1] = tail(6);
    piece.bytes[2] = tail(0);
  } else {
    piece.length = 4;
    piece.bytes[0] = static_cast<char>(0xF0U | (code >> 18U));
    piece.bytes[1] = tail(12);
    piece.bytes[2] = tail(6);
    piece.bytes[3] = tail(0);
  }
}

// The digit's value in that base, or -1.
int Digit(char c, int base) {
  int digit = -1;
  if (c >= '0' && c <= '9') digit = c - '0';
  if (c >= 'a' && c <= 'f') digit = c - 'a' + 10;
  if (c >= 'A' && c <= 'F') digit = c - 'A' + 10;
  return digit < base ? digit : -1;
}

bool ReadNumericReference(std::string_view raw, Piece& piece) {
  if (raw.size() < 4 || raw[1] != '#') return false;
  const int base = raw[2] == 'x' ? 16 : 10;
  const std::size_t first = base == 16 ? 3 : 2;
  constexpr std::uint32_t kLastCodePoint = 0x10FFFF;
  std::uint32_t code = 0;
  std::size_t at = first;
  for (; at < raw.size() && Digit(raw[at], base) >= 0; ++at) {
    code =
        code * static_cast<std::uint32_t>(base) + static_cast<std::uint32_t>(Digit(raw[at], base));
    if (code > kLastCodePoint) return false;
  }
  if (at == first || at == raw.size() || raw[at] != ';' || code == 0) return false;
  piece.raw_length = at + 1;
  EncodeUtf8(code, piece);
  return true;
}

bool ReadReference(std::string_view raw, Piece& piece) {
  for (const NamedReference& named : kNamed) {
    if (raw.substr(0, named.text.size()) != named.text) continue;
    piece.raw_length = named.text.size();
    piece.bytes[0] = named.character;
    return true;
  }
  return ReadNumericReference(raw, piece);
}

// The first piece of a text that is not empty.
Piece ReadPiece(std::string_view raw) {
  Piece piece;
  piece.bytes[0] = raw[0];
  if (raw[0] == '&') {
    ReadReference(raw, piece);
  } else if (raw[0] == '\r' || raw[0] == '\n') {
    const char other = raw[0] == '\r' ? '\n' : '\r';
    piece.bytes[0] = '\n';
    piece.raw_length = raw.size() > 1 && raw[1] == other ? 2 : 1;
  }
  return piece;
}

bool BeginsName(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
         byte == ':' || byte == '_';
}

}  // namespace

bool NeedsDecoding(std::string_view raw) {
  return std::any_of(raw.begin(), raw.end(), [](char c) { return c == '&' || c == '\r'; });
}

std::string DecodeXml(std::string_view raw) {
  std::string text;
  text.reserve(raw.size());
  while (!raw.empty()) {
    const Piece piece = ReadPiece(raw);
    text.append(piece.bytes, piece.length);
    raw.remove_prefix(piece.raw_length);
  }
  return text;
}

std::size_t RawOffset(std::string_view raw, std::size_t decoded_offset) {
  std::size_t at = 0;
  for (std::size_t decoded = 0; at < raw.size();) {
    const Piece piece = ReadPiece(raw.substr(at));
    decoded += piece.length;
    if (decoded > decoded_offset) break;
    at += piece.raw_length;
  }
  return at;
}

std::size_t ReferenceLength(std::string_view raw) {
  Piece piece;
  return !raw.empty() && raw[0] == '&' && ReadReference(raw, piece) ? piece.raw_length : 0;
}

std::string EscapeXmlValue(std::string_view value, char quote) {
  std::string escaped;
  escaped.reserve(value.size());
  for (const char c : value) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '\n' || c == '\r' || c == '\t') {
      escaped += "&#" + std::to_string(static_cast<int>(c)) + ";";
    } else if (c == quote) {
      escaped += quote == '"' ? "&quot;" : "&apos;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::size_t NameLength(std::string_view text) {
  if (text.empty() || !BeginsName(text[0])) return 0;
  const auto end = std::find_if_not(text.begin(), text.end(), [](char c) {
    return BeginsName(c) || (c >= '0' && c <= '9') || c == '.' || c == '-';
  });
  return static_cast<std::size_t>(end - text.begin());
}

bool IsXmlName(std::string_view name) { return !name.empty() && NameLength(name) == name.size(); }

}  // namespace coppice

#include "bt_core/cli/plain_output.h"

namespace coppice {

std::string Plain(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 || c == '\n' || c == '\t') {
      plain += c;
    } else {
      constexpr char kDigits[] = "0123456789ABCDEF";
      plain += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 0xF]};
    }
  }
  return plain;
}

std::streamsize PlainOutput::xsputn(const char* text, std::streamsize size) {
  const std::string plain = Plain({text, static_cast<std::size_t>(size)});
  const auto length = static_cast<std::streamsize>(plain.size());
  return output_->sputn(plain.data(), length) == length ? size : 0;
}

PlainOutput::int_type PlainOutput::overflow(int_type character) {
  const char c = traits_type::to_char_type(character);
  return xsputn(&c, 1) == 1 ? character : traits_type::eof();
}

}  // namespace coppice

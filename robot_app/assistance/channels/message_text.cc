#include "robot_app/assistance/channels/message_text.h"

#include <algorithm>

#include "bt_core/model/utf8.h"
#include "robot_app/common/web/base64.h"

namespace coppice::robot::assistance {
namespace {

constexpr std::size_t kMostLineBytes = 200;
constexpr std::size_t kBytesPerWord = 42;  // an encoded word has at most 75 characters

bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool IsContinuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

// The longest beginning of at most that many bytes that ends between two characters.
std::string_view Beginning(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && IsContinuation(text[most])) --most;
  return text.substr(0, most);
}

std::string ValidUtf8(std::string_view text) {
  std::string valid;
  while (true) {
    const std::size_t bad = FindInvalidUtf8(text);
    valid += text.substr(0, bad);
    if (bad >= text.size()) return valid;
    valid += "\xef\xbf\xbd";
    text.remove_prefix(bad + 1);
  }
}

}  // namespace

std::string MessageText(std::string_view text) {
  std::string plain = ValidUtf8(text.substr(0, 2 * kMostMessageBytes));
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return IsControl(c) && c != '\n'; }, ' ');
  return std::string(Beginning(plain, kMostMessageBytes));
}

std::string OneLine(std::string_view text) {
  std::string line = MessageText(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  return std::string(Beginning(line, kMostLineBytes));
}

std::string MailHeader(std::string_view text) {
  const std::string line = OneLine(text);
  if (std::all_of(line.begin(), line.end(), [](char c) { return c > 0; })) return line;
  std::string words;
  for (std::string_view rest = line; !rest.empty();) {
    const std::string_view part = Beginning(rest, kBytesPerWord);
    rest.remove_prefix(part.size());
    words += (words.empty() ? "=?UTF-8?B?" : " =?UTF-8?B?") + ToBase64(part) + "?=";
  }
  return words;
}

std::string MailAddress(std::string_view text) {
  const bool is_safe = std::all_of(text.begin(), text.end(), [](char c) {
    return c > ' ' && c != 0x7f && std::string_view("<>()[],;:\\\"").find(c) == std::string::npos;
  });
  const bool has_at = std::count(text.begin(), text.end(), '@') == 1;
  return is_safe && has_at && text.size() <= 254 ? std::string(text) : "";
}

std::string WithLink(const std::string& text, const std::string& link) {
  return link.empty() ? text : text + "\n" + link;
}

}  // namespace coppice::robot::assistance

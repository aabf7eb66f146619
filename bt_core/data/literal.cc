#include "bt_core/data/literal.h"

#include <cstdint>
#include <string>

namespace coppice {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// As people write numbers: no blanks, no leading zero, no "inf".
bool LooksLikeNumber(std::string_view text) {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  if (text.empty() || !IsDigit(text.front())) return false;
  return text.front() != '0' || text.size() == 1 || !IsDigit(text[1]);
}

}  // namespace

Value GuessValue(std::string_view text) {
  Value value;
  if (LooksLikeNumber(text)) {
    const bool hexadecimal = text.find_first_of("xX") != std::string_view::npos;
    if (value.Parse(TypeOf<std::int64_t>(), text)) return value;
    if (!hexadecimal && value.Parse(TypeOf<double>(), text)) return value;
  }
  value.Parse(TypeOf<std::string>(), text);
  return value;
}

}  // namespace coppice

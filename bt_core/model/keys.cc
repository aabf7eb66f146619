#include "bt_core/model/keys.h"

#include "bt_core/data/value.h"

namespace coppice {
namespace {

std::string_view Trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

bool IsTrue(std::string_view text) {
  bool value = false;
  return ValueTraits<bool>::Parse(text, value) && value;
}

}  // namespace

std::string_view KeyOf(std::string_view text, std::string_view own_name) {
  text = Trim(text);
  if (text == "=") return own_name;
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') return {};
  const std::string_view key = Trim(text.substr(1, text.size() - 2));
  if (key == "=") return own_name;
  if (key == "@" || key.find_first_of("{}") != std::string_view::npos) return {};
  return key;
}

bool IsAutoremapped(const Document& document, const Element& subtree) {
  return IsTrue(document.AttributeValue(subtree, "_autoremap"));
}

bool IsAutoremapped(const StartTag& subtree) { return IsTrue(subtree.Value("_autoremap")); }

bool IsPrivateKey(std::string_view key) { return key.substr(0, 1) == "_"; }

}  // namespace coppice

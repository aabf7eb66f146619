#include "bt_core/data/value.h"

#include <locale.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

namespace coppice {
namespace {

std::string_view Trim(std::string_view text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The whole text must be one number: "12abc" is not 12.
template <class T>
bool ParseWhole(std::string_view text, T& out) {
  text = Trim(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

// Numbers have a decimal point, whatever the locale of the program that the tree runs in.
class PlainNumbers {
 public:
  PlainNumbers() {
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    before_ = uselocale(plain);
  }
  ~PlainNumbers() { uselocale(before_); }
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

 private:
  locale_t before_;
};

// strtod and strtof, because GCC 9 has no from_chars for them.
template <class T>
bool ParseReal(std::string_view text, T& out, T (*convert)(const char*, char**)) {
  const std::string copy(Trim(text));
  if (copy.empty()) return false;
  const PlainNumbers plain;
  char* end = nullptr;
  out = convert(copy.c_str(), &end);
  return end == copy.c_str() + copy.size();
}

// The shortest text that reads back the same.
template <class T>
std::string PrintReal(T value, std::initializer_list<int> digits,
                      T (*convert)(const char*, char**)) {
  const PlainNumbers plain;
  char text[32];
  for (const int count : digits) {
    std::snprintf(text, sizeof(text), "%.*g", count, static_cast<double>(value));
    if (convert(text, nullptr) == value) break;
  }
  return text;
}

}  // namespace

Value::Value(Value&& other) noexcept { *this = std::move(other); }

Value& Value::operator=(const Value& other) {
  if (this == &other) return *this;
  if (!other.type_) {
    Reset();
  } else if (type_ == other.type_) {
    type_->copy_assign(data(), other.data());
  } else {
    other.type_->copy_construct(Prepare(*other.type_), other.data());
  }
  return *this;
}

Value& Value::operator=(Value&& other) noexcept {
  if (this == &other) return *this;
  if (other.type_ && !other.is_inline()) {
    Reset();
    type_ = std::exchange(other.type_, nullptr);
    heap_ = other.heap_;
    return *this;
  }
  return *this = static_cast<const Value&>(other);
}

bool Value::Parse(const Type& type, std::string_view text) {
  constexpr std::string_view kJson = "json:";
  if (type.has_json_form && text.substr(0, kJson.size()) == kJson) {
    return FromJson(type, text.substr(kJson.size()));
  }
  void* at = Prepare(type);
  type.construct(at);
  if (type.parse(text, at)) return true;
  Reset();
  return false;
}

bool Value::FromJson(const Type& type, std::string_view json) {
  void* at = Prepare(type);
  type.construct(at);
  if (type.from_json(json, at)) return true;
  Reset();
  return false;
}

void Value::Assign(const Type& type, const void* from) {
  if (type_ == &type) {
    type.copy_assign(data(), from);
  } else {
    type.copy_construct(Prepare(type), from);
  }
}

void Value::Reset() {
  if (!type_) return;
  type_->destroy(data());
  if (!is_inline()) ::operator delete(heap_, std::align_val_t(type_->alignment));
  type_ = nullptr;
}

void* Value::Prepare(const Type& type) {
  Reset();
  type_ = &type;
  if (is_inline()) return inline_;
  heap_ = ::operator new(type.size, std::align_val_t(type.alignment));
  return heap_;
}

bool ValueTraits<bool>::Parse(std::string_view text, bool& out) {
  text = Trim(text);
  const bool yes = text == "true" || text == "True" || text == "TRUE" || text == "1";
  const bool no = text == "false" || text == "False" || text == "FALSE" || text == "0";
  out = yes;
  return yes || no;
}
std::string ValueTraits<bool>::Print(const bool& value) { return value ? "true" : "false"; }

bool ValueTraits<int>::Parse(std::string_view text, int& out) { return ParseWhole(text, out); }
std::string ValueTraits<int>::Print(const int& value) { return std::to_string(value); }

bool ValueTraits<unsigned>::Parse(std::string_view text, unsigned& out) {
  return ParseWhole(text, out);
}
std::string ValueTraits<unsigned>::Print(const unsigned& value) { return std::to_string(value); }

bool ValueTraits<std::int64_t>::Parse(std::string_view text, std::int64_t& out) {
  return ParseWhole(text, out);
}
std::string ValueTraits<std::int64_t>::Print(const std::int64_t& value) {
  return std::to_string(value);
}

bool ValueTraits<std::uint64_t>::Parse(std::string_view text, std::uint64_t& out) {
  return ParseWhole(text, out);
}
std::string ValueTraits<std::uint64_t>::Print(const std::uint64_t& value) {
  return std::to_string(value);
}

bool ValueTraits<float>::Parse(std::string_view text, float& out) {
  return ParseReal(text, out, std::strtof);
}
std::string ValueTraits<float>::Print(const float& value) {
  return PrintReal(value, {6, 7, 8, 9}, std::strtof);
}

bool ValueTraits<double>::Parse(std::string_view text, double& out) {
  return ParseReal(text, out, std::strtod);
}
std::string ValueTraits<double>::Print(const double& value) {
  return PrintReal(value, {6, 15, 16, 17}, std::strtod);
}

bool ValueTraits<std::string>::Parse(std::string_view text, std::string& out) {
  out.assign(text);
  return true;
}
std::string ValueTraits<std::string>::Print(const std::string& value) { return value; }

}  // namespace coppice

#include "bt_core/base/json.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "bt_core/base/json_library.h"
#include "bt_core/base/plain.h"

namespace coppice {
namespace {

using Kind = JsonValue::Kind;

// nlohmann's parser does not say where it is, so it reads through an iterator that counts.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, const char** furthest) : at_(at), furthest_(furthest) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    if (furthest_) *furthest_ = at_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** furthest_;
};

class Reader : public nlohmann::json_sax<nlohmann::json> {
 public:
  Reader(std::string_view text, const std::string& file, Diagnostics& diagnostics)
      : text_(text), file_(file), diagnostics_(diagnostics), at_(text.data()) {}

  std::optional<JsonValue> Read(bool allows_comments) {
    const char* end = text_.data() + text_.size();
    const bool good = nlohmann::json::sax_parse(
        CountingIterator(text_.data(), &at_), CountingIterator(end, nullptr), this,
        nlohmann::json::input_format_t::json, true, allows_comments);
    if (!good || diagnostics_.has_errors()) return std::nullopt;
    return std::move(root_);
  }

  bool null() override { return Add(Kind::kNull, "null", 4); }
  bool boolean(bool value) override {
    return Add(Kind::kBool, value ? "true" : "false", value ? 4 : 5);
  }
  bool number_integer(number_integer_t) override { return AddNumber(); }
  bool number_unsigned(number_unsigned_t) override { return AddNumber(); }
  bool number_float(number_float_t, const string_t&) override { return AddNumber(); }
  bool string(string_t& value) override {
    return Add(Kind::kString, value, consumed() - StartOfString());
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return Open(Kind::kObject); }
  bool start_array(std::size_t) override { return Open(Kind::kArray); }
  bool end_object() override { return Close(); }
  bool end_array() override { return Close(); }
  bool key(string_t& name) override {
    key_ = name;
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error) override {
    const std::string what = error.what();
    const std::size_t reason = what.find(": ");
    diagnostics_.Error(Locate(position ? position - 1 : 0),
                       reason == std::string::npos ? what : what.substr(reason + 2));
    return false;
  }

 private:
  std::size_t consumed() const { return static_cast<std::size_t>(at_ - text_.data()); }

  // The parser has just read the closing quote.
  std::size_t StartOfString() const {
    std::size_t start = consumed() - 2;
    const auto is_escaped = [this](std::size_t at) {
      std::size_t slashes = 0;
      while (slashes < at && text_[at - 1 - slashes] == '\\') ++slashes;
      return slashes % 2 == 1;
    };
    while (start > 0 && (text_[start] != '"' || is_escaped(start))) --start;
    return start;
  }

  // The parser has read one character more, unless the number is the whole text.
  bool AddNumber() {
    constexpr std::string_view kCharacters = "+-.0123456789Ee";
    std::size_t end = consumed();
    if (kCharacters.find(text_[end - 1]) == std::string_view::npos) --end;
    std::size_t start = end;
    while (start > 0 && kCharacters.find(text_[start - 1]) != std::string_view::npos) --start;
    return Add(Kind::kNumber, std::string(text_.substr(start, end - start)), consumed() - start);
  }

  bool Open(Kind kind) {
    if (!Add(kind, "", 1)) return false;
    if (open_.size() == static_cast<std::size_t>(kMaxJsonDepth)) {
      diagnostics_.Error(Locate(consumed() - 1), "nested more than 100 levels deep");
      return false;
    }
    open_.push_back(open_.empty() ? &root_ : &open_.back()->children.back());
    return true;
  }

  bool Close() {
    RefuseTwins(*open_.back());
    open_.back()->end = consumed();
    open_.pop_back();
    return true;
  }

  void RefuseTwins(const JsonValue& object) {
    if (!object.is(Kind::kObject)) return;
    std::set<std::string_view> names;
    for (const JsonValue& member : object.children) {
      if (names.insert(member.key).second) continue;
      diagnostics_.Error(member.where, "\"" + member.key + "\" is given twice");
    }
  }

  bool Add(Kind kind, std::string text, std::size_t length) {
    if (++values_ > kMostJsonValues) {
      diagnostics_.Error(Locate(consumed() - length),
                         "more than " + std::to_string(kMostJsonValues) + " values");
      return false;
    }
    JsonValue value{kind, std::exchange(key_, {}), std::move(text), Locate(consumed() - length), {},
                    0};
    if (open_.empty()) {
      root_ = std::move(value);
    } else {
      open_.back()->children.push_back(std::move(value));
    }
    return true;
  }

  // One place mostly lies behind the other: no line is counted twice.
  SourceLocation Locate(std::size_t offset) {
    if (offset < counted_) counted_ = line_start_ = 0, line_ = 1;
    for (const std::size_t end = std::min(offset, text_.size()); counted_ < end; ++counted_) {
      if (text_[counted_] != '\n') continue;
      ++line_;
      line_start_ = counted_ + 1;
    }
    return {file_, line_, static_cast<std::uint32_t>(counted_ - line_start_ + 1)};
  }

  const std::string_view text_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  const char* at_;  // behind what the parser has read
  std::string key_;
  std::size_t values_ = 0;
  std::size_t counted_ = 0, line_start_ = 0;  // offsets
  std::uint32_t line_ = 1;                    // where counted_ is
  JsonValue root_;
  std::vector<JsonValue*> open_;  // an array or object does not grow while a child is open
};

constexpr std::size_t kLineLength = 100;

std::string Label(const JsonValue& member, const JsonValue& parent) {
  return parent.is(Kind::kObject) ? JsonString(member.key) + ": " : std::string();
}

std::string PrintInOneLine(const JsonValue& json) {
  if (json.is(Kind::kString)) return JsonString(json.text);
  if (!json.is(Kind::kArray) && !json.is(Kind::kObject)) return json.text;
  std::string inside;
  for (const JsonValue& child : json.children) {
    inside += (inside.empty() ? "" : ", ") + Label(child, json) + PrintInOneLine(child);
  }
  return json.is(Kind::kArray) ? "[" + inside + "]" : "{" + inside + "}";
}

// `column`: where its first line begins.
std::string PrintInLines(const JsonValue& json, std::size_t indent, std::size_t column) {
  std::string line = PrintInOneLine(json);
  if (column + line.size() < kLineLength || json.children.empty()) return line;
  const std::string inner(indent + 2, ' ');
  std::string text(1, line.front());
  for (const JsonValue& child : json.children) {
    const std::string label = Label(child, json);
    text += (&child == json.children.data() ? "\n" : ",\n") + inner + label +
            PrintInLines(child, indent + 2, indent + 2 + label.size());
  }
  return text + "\n" + std::string(indent, ' ') + line.back();
}

// Reads on until something is nested too deep, or there are too many values.
class LimitCheck final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit LimitCheck(std::size_t most_values) : most_values_(most_values) {}

  bool is_too_deep() const { return depth_ > kMaxJsonDepth; }
  bool has_too_many() const { return values_ > most_values_; }

  bool null() override { return Count(); }
  bool boolean(bool) override { return Count(); }
  bool number_integer(number_integer_t) override { return Count(); }
  bool number_unsigned(number_unsigned_t) override { return Count(); }
  bool number_float(number_float_t, const string_t&) override { return Count(); }
  bool string(string_t&) override { return Count(); }
  bool binary(binary_t&) override { return Count(); }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return Count() && ++depth_ <= kMaxJsonDepth; }
  bool end_object() override { return --depth_ >= 0; }
  bool start_array(std::size_t) override { return Count() && ++depth_ <= kMaxJsonDepth; }
  bool end_array() override { return --depth_ >= 0; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

 private:
  bool Count() { return ++values_ <= most_values_; }

  const std::size_t most_values_;
  int depth_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

const JsonValue* JsonValue::Find(std::string_view name) const {
  for (const JsonValue& child : children) {
    if (child.key == name) return &child;
  }
  return nullptr;
}

std::optional<JsonValue> ParseJson(const std::string& text, const std::string& file,
                                   Diagnostics& diagnostics) {
  return Reader(text, file, diagnostics).Read(/*allows_comments=*/true);
}

std::optional<JsonValue> ParseJson(std::string_view text) {
  Diagnostics diagnostics;
  const std::string file;
  return Reader(text, file, diagnostics).Read(/*allows_comments=*/false);
}

std::string PrintJson(const JsonValue& json, std::size_t indent) {
  return PrintInLines(json, indent, indent);
}

std::string JsonString(std::string_view text) {
  // What JSON leaves as it is, a terminal might obey.
  return Plain(nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string JsonSeconds(Duration time) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.9f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

JsonObject& JsonObject::Add(std::string_view key, const std::string& json) {
  text_ += (text_.size() > 1 ? "," : "") + JsonString(key) + ":" + json;
  return *this;
}

JsonObject& JsonObject::Add(std::string_view key, std::uint64_t number) {
  return Add(key, std::to_string(number));
}

JsonObject& JsonObject::AddText(std::string_view key, std::string_view text) {
  return Add(key, JsonString(text));
}

// Not in one go: with a callback the library looks at all elements of a list after each object.
nlohmann::json ParseLimitedJson(std::string_view text, std::size_t most_values) {
  LimitCheck check(most_values);
  nlohmann::json::sax_parse(text, &check);
  if (check.is_too_deep()) throw std::invalid_argument("the JSON is nested too deep");
  if (check.has_too_many()) {
    throw std::invalid_argument("the JSON has more than " + std::to_string(most_values) +
                                " values");
  }
  return nlohmann::json::parse(text);
}

nlohmann::json ReadLimitedMessagePack(std::string_view bytes) {
  LimitCheck check(kMostJsonValues);
  if (!nlohmann::json::sax_parse(bytes, &check, nlohmann::json::input_format_t::msgpack)) {
    return nlohmann::json(nlohmann::json::value_t::discarded);
  }
  return nlohmann::json::from_msgpack(bytes, true, false);
}

}  // namespace coppice

#include "editor/live/values/value_rows.h"

#include <algorithm>
#include <sstream>

#include "editor/live/key_search.h"

namespace coppice::editor {
namespace {

// It looks for where values begin and end, and leaves to others what is in them.
class Reader {
 public:
  explicit Reader(std::string_view text) { out_.text = text; }

  std::optional<ValueRows> Read() {
    Skip();
    if (!IsAt('{') && !IsAt('[')) return std::nullopt;
    while (!is_wrong_ && (out_.rows.empty() || !open_.empty())) {
      if (IsEndOfOpen()) {
        Close();
      } else {
        Entry();
      }
    }
    Skip();
    if (is_wrong_ || at_ != out_.text.size()) return std::nullopt;
    return std::move(out_);
  }

 private:
  bool IsAt(char c) const { return at_ < out_.text.size() && out_.text[at_] == c; }

  void Skip() { at_ = std::min(out_.text.find_first_not_of(" \t\r\n", at_), out_.text.size()); }

  bool Take(char c) {
    Skip();
    if (!IsAt(c)) return false;
    ++at_;
    return true;
  }

  ValueRow& Row(std::size_t row) { return out_.rows[row]; }

  bool IsEndOfOpen() {
    if (open_.empty()) return false;
    Skip();
    return IsAt(Row(open_.back()).kind == '{' ? '}' : ']');
  }

  void Close() {
    ValueRow& row = Row(open_.back());
    ++at_;
    row.length = static_cast<std::uint32_t>(at_) - row.begin;
    row.end = static_cast<std::uint32_t>(out_.rows.size());
    open_.pop_back();
  }

  // Behind a comma if it is not the first one.
  void Entry() {
    ValueRow row;
    row.depth = static_cast<std::uint16_t>(open_.size());
    if (!open_.empty()) {
      ValueRow& parent = Row(open_.back());
      row.parent = open_.back();
      row.number = parent.count++;
      if (row.number > 0 && !Take(',')) return Fail();
      if (parent.kind == '{' && !Key(row)) return Fail();
    }
    Skip();
    if (at_ == out_.text.size() || out_.rows.size() == ValueRows::kMostRows) return Fail();
    row.begin = static_cast<std::uint32_t>(at_);
    const auto number = static_cast<std::uint32_t>(out_.rows.size());
    row.end = number + 1;
    const char first = out_.text[at_];
    if (first == '{' || first == '[') {
      if (row.depth == ValueRows::kMostDepth) return Fail();
      row.kind = first;
      open_.push_back(number);
      ++at_;
    } else if (first == '"' ? !String() : !Word()) {
      return Fail();
    }
    row.length = static_cast<std::uint32_t>(at_) - row.begin;
    out_.rows.push_back(row);
  }

  bool Key(ValueRow& row) {
    Skip();
    const std::size_t begin = at_ + 1;
    if (!IsAt('"') || !String()) return false;
    row.key = static_cast<std::uint32_t>(begin);
    row.key_length = static_cast<std::uint32_t>(at_ - 1 - begin);
    return Take(':');
  }

  bool String() {
    ++at_;
    while (true) {
      at_ = out_.text.find_first_of("\"\\", at_);
      if (at_ == std::string_view::npos) return false;
      if (out_.text[at_] == '"') break;
      at_ += 2;
    }
    ++at_;
    return true;
  }

  // A number, true, false or null.
  bool Word() {
    const std::size_t begin = at_;
    at_ = std::min(out_.text.find_first_of(",]}[{\": \t\r\n", at_), out_.text.size());
    return at_ > begin;
  }

  void Fail() { is_wrong_ = true; }

  ValueRows out_;
  std::vector<std::uint32_t> open_;
  std::size_t at_ = 0;
  bool is_wrong_ = false;
};

}  // namespace

std::optional<ValueRows> ReadValueRows(std::string_view text) {
  if (text.size() > ValueRows::kMostBytes) return std::nullopt;
  return Reader(text).Read();
}

std::string ValueRows::PathOf(std::uint32_t row) const {
  constexpr std::size_t kPathBytes = 200;  // of a name
  std::string path;
  for (; row != 0; row = rows[row].parent) {
    const ValueRow& at = rows[row];
    const bool is_member = rows[at.parent].kind == '{';
    const std::string name =
        is_member ? std::string(KeyOf(at).substr(0, kPathBytes)) : std::to_string(at.number);
    path.insert(0, "/" + name);
  }
  return path;
}

bool IsOpen(const ValueRows& rows, std::uint32_t row, const ValueFolds& folds) {
  const ValueRow& at = rows.rows[row];
  if (at.count == 0) return false;
  const bool is_few = at.count <= ValueRows::kFew;
  return (folds.count(rows.PathOf(row)) > 0) != is_few;
}

std::vector<std::uint32_t> ShownRows(const ValueRows& rows, const ValueFolds& folds) {
  std::vector<std::uint32_t> shown;
  for (std::uint32_t row = 1; row < rows.rows.size();) {
    shown.push_back(row);
    const ValueRow& at = rows.rows[row];
    row = at.kind != 0 && IsOpen(rows, row, folds) ? row + 1 : at.end;
  }
  return shown;
}

std::vector<std::uint32_t> FoundRows(const ValueRows& rows, const std::string& words) {
  std::istringstream stream(words);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  std::vector<bool> is_found(rows.rows.size());
  for (auto row = static_cast<std::uint32_t>(rows.rows.size()); row-- > 1;) {
    const ValueRow& at = rows.rows[row];
    const bool has_word = std::any_of(list.begin(), list.end(), [&](const std::string& word) {
      return HasWord(rows.KeyOf(at), word) || (at.kind == 0 && HasWord(rows.TextOf(at), word));
    });
    if (has_word) is_found[row] = true;
    if (is_found[row]) is_found[at.parent] = true;
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t row = 1; row < rows.rows.size(); ++row) {
    if (is_found[row]) found.push_back(row);
  }
  return found;
}

std::string SizeText(const ValueRow& row) {
  std::string digits = std::to_string(row.count);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, " ");
  }
  return row.kind == '{' ? "{" + digits + "}" : "[" + digits + "]";
}

}  // namespace coppice::editor

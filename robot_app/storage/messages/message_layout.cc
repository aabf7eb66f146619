#include "robot_app/storage/messages/message_layout.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <map>
#include <set>

namespace coppice::robot::storage {
namespace {

struct Kind {
  const char* word;
  FieldKind kind;
  std::size_t size;
};
// In the order of FieldKind, then other words for the same.
constexpr Kind kKinds[] = {
    {"bool", FieldKind::kBool, 1},         {"int8", FieldKind::kInt8, 1},
    {"uint8", FieldKind::kUint8, 1},       {"int16", FieldKind::kInt16, 2},
    {"uint16", FieldKind::kUint16, 2},     {"int32", FieldKind::kInt32, 4},
    {"uint32", FieldKind::kUint32, 4},     {"int64", FieldKind::kInt64, 8},
    {"uint64", FieldKind::kUint64, 8},     {"float32", FieldKind::kFloat32, 4},
    {"float64", FieldKind::kFloat64, 8},   {"time", FieldKind::kTime, 8},
    {"duration", FieldKind::kDuration, 8}, {"string", FieldKind::kString, 0},
    {"message", FieldKind::kMessage, 0},   {"byte", FieldKind::kInt8, 1},
    {"char", FieldKind::kUint8, 1}};

std::optional<FieldKind> KindOf(std::string_view word) {
  for (const Kind& kind : kKinds) {
    if (word == kind.word && kind.kind != FieldKind::kMessage) return kind.kind;
  }
  return std::nullopt;
}

constexpr const char* kSpaces = " \t\r";

std::string_view Trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpaces);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

// The next line of `text`, which gets shorter.
std::string_view TakeLine(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

bool IsLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool IsName(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), IsLetter);
}

std::string PackageOf(std::string_view type) { return std::string(type.substr(0, type.find('/'))); }

std::uint64_t Times(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return b != 0 && a > kMost / b ? kMost : a * b;
}

std::uint64_t Plus(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return a > kMost - b ? kMost : a + b;
}

// The sections of a definition, one for each type, become messages; the names of types within
// become their numbers when all are known.
class Parser {
 public:
  Expected<MessageLayout> Parse(const std::string& type, std::string_view text) {
    if (!IsTypeName(type)) return Problem{"expected the name of a type"};
    if (text.size() > kLongestDefinition) return Problem{type + ": the definition is too long"};
    Begin(type);
    for (line_ = 1; !text.empty(); ++line_) {
      const Outcome outcome = ReadLine(Trimmed(TakeLine(text)));
      if (!outcome) return Problem{Here() + outcome.problem()};
    }
    layout_.messages.back().end = static_cast<std::uint32_t>(layout_.fields.size());
    const Outcome outcome = Resolve();
    if (!outcome) return Problem{outcome.problem()};
    return std::move(layout_);
  }

 private:
  std::string Here() const {
    return layout_.messages.back().type + ": line " + std::to_string(line_) + ": ";
  }

  void Begin(const std::string& type) {
    const auto fields = static_cast<std::uint32_t>(layout_.fields.size());
    if (!layout_.messages.empty()) layout_.messages.back().end = fields;
    numbers_.emplace(type, static_cast<std::uint32_t>(layout_.messages.size()));
    layout_.messages.push_back({type, fields, fields});
    names_.clear();
  }

  Outcome ReadLine(std::string_view line) {
    if (line.substr(0, 3) == "===") return {};
    if (line.substr(0, 4) == "MSG:") {
      const std::string type(Trimmed(line.substr(4)));
      if (!IsTypeName(type)) return Problem{"expected the name of a type"};
      if (numbers_.count(type) != 0) return Problem{type + " is defined twice"};
      Begin(type);
      return {};
    }
    line = Trimmed(line.substr(0, line.find('#')));
    return line.empty() ? Outcome() : ReadField(line);
  }

  Outcome ReadField(std::string_view line) {
    const std::size_t space = line.find_first_of(kSpaces);
    if (space == std::string_view::npos) return Problem{"expected a type and a name"};
    const std::string_view name = Trimmed(line.substr(space));
    if (name.find('=') != std::string_view::npos) return {};  // a constant
    MessageField field;
    field.name = name;
    if (!IsName(name)) return Problem{"expected a name, not \"" + field.name + "\""};
    if (!names_.insert(field.name).second) return Problem{field.name + " is there twice"};
    const Expected<std::string_view> word = TakeCount(line.substr(0, space), field);
    if (!word) return Problem{word.problem()};
    const std::optional<FieldKind> kind = KindOf(*word);
    field.kind = kind.value_or(FieldKind::kMessage);
    words_.emplace_back(kind ? std::string_view() : *word);
    layout_.fields.push_back(std::move(field));
    return {};
  }

  // The word without what follows in brackets, which goes into the field.
  static Expected<std::string_view> TakeCount(std::string_view word, MessageField& field) {
    const std::size_t bracket = word.find('[');
    if (bracket == std::string_view::npos) return word;
    if (word.back() != ']') return Problem{"expected a \"]\""};
    const std::string_view number = word.substr(bracket + 1, word.size() - bracket - 2);
    field.count = number.empty() ? MessageField::Count::kAny : MessageField::Count::kFixed;
    const auto [end, error] =
        std::from_chars(number.data(), number.data() + number.size(), field.length);
    if (!number.empty() && (error != std::errc() || end != number.data() + number.size())) {
      return Problem{"expected the length of an array"};
    }
    return word.substr(0, bracket);
  }

  Outcome Resolve() {
    for (const MessageLayout::Message& message : layout_.messages) {
      for (std::uint32_t i = message.first; i < message.end; ++i) {
        if (layout_.fields[i].kind != FieldKind::kMessage) continue;
        const auto found = Find(words_[i], PackageOf(message.type));
        if (!found) return Problem{message.type + ": there is no definition of " + words_[i]};
        layout_.fields[i].message = *found;
      }
    }
    return Measure(0, 0);
  }

  std::optional<std::uint32_t> Find(const std::string& word, const std::string& package) const {
    for (const std::string& name :
         {word, word == "Header" ? "std_msgs/Header" : package + "/" + word}) {
      const auto found = numbers_.find(name);
      if (found != numbers_.end()) return found->second;
    }
    return std::nullopt;
  }

  Outcome Measure(std::uint32_t number, int depth) {
    MessageLayout::Message& message = layout_.messages[number];
    if (depth > kDeepestMessage) return Problem{message.type + " is nested too deep"};
    if (measured_.count(number) != 0) return {};
    std::optional<std::uint64_t> size = 0;
    for (std::uint32_t i = message.first; i < message.end; ++i) {
      const MessageField& field = layout_.fields[i];
      if (field.kind == FieldKind::kMessage) {
        const Outcome outcome = Measure(field.message, depth + 1);
        if (!outcome) return outcome;
      }
      if (field.count == MessageField::Count::kFixed && field.length == 0) continue;
      const auto one = layout_.SizeOfOne(field);
      const bool is_fixed = size && one && field.count != MessageField::Count::kAny;
      size = is_fixed ? std::optional(Plus(*size, Times(*one, field.length))) : std::nullopt;
    }
    message.size = size;
    measured_.insert(number);
    return {};
  }

  MessageLayout layout_;
  std::vector<std::string> words_;  // of each field: the type that is a message, or empty
  std::map<std::string, std::uint32_t> numbers_;
  std::set<std::uint32_t> measured_;
  std::set<std::string> names_;  // of the fields of the message that is being read
  int line_ = 0;
};

}  // namespace

const char* Word(FieldKind kind) { return kKinds[static_cast<std::size_t>(kind)].word; }
std::size_t SizeOf(FieldKind kind) { return kKinds[static_cast<std::size_t>(kind)].size; }

bool IsTypeName(std::string_view text) {
  return !text.empty() && text.size() <= kLongestTypeName &&
         std::all_of(text.begin(), text.end(), [](char c) { return IsLetter(c) || c == '/'; });
}

std::optional<std::uint64_t> MessageLayout::SizeOfOne(const MessageField& field) const {
  if (field.kind == FieldKind::kString) return std::nullopt;
  if (field.kind == FieldKind::kMessage) return messages[field.message].size;
  return SizeOf(field.kind);
}

Expected<MessageLayout> ParseDefinition(const std::string& type, std::string_view definition) {
  return Parser().Parse(type, definition);
}

}  // namespace coppice::robot::storage

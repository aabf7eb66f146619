#include "robot_app/storage/export/csv_table.h"

#include <nlohmann/json.hpp>

#include "bt_core/base/json_library.h"

namespace coppice::robot::storage {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestHeader = std::size_t{1} << 20;  // bytes

std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

bool IsMessage(const MessageField& field) {
  return field.kind == FieldKind::kMessage && field.count == MessageField::Count::kOne;
}

// Until there are too many.
void AddNames(const MessageLayout& layout, const MessageLayout::Message& message,
              const std::string& before, std::string& line) {
  for (std::uint32_t i = message.first; i < message.end && line.size() <= kLongestHeader; ++i) {
    const MessageField& field = layout.fields[i];
    if (IsMessage(field)) {
      AddNames(layout, layout.messages[field.message], before + field.name + ".", line);
    } else {
      line += "," + Cell(before + field.name);
    }
  }
}

bool IsTime(const MessageField& field) {
  return field.count == MessageField::Count::kOne &&
         (field.kind == FieldKind::kTime || field.kind == FieldKind::kDuration);
}

// Of a time its seconds, exactly.
std::string TextOf(const MessageField& field, const json& value) {
  if (IsTime(field)) {
    const std::string nanoseconds = std::to_string(value.at("nsecs").get<std::int64_t>());
    const std::string zeros(nanoseconds.size() < 9 ? 9 - nanoseconds.size() : 0, '0');
    return value.at("secs").dump() + "." + zeros + nanoseconds;
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void AddCells(const MessageLayout& layout, const MessageLayout::Message& message, const json& value,
              std::string& line) {
  for (std::uint32_t i = message.first; i < message.end; ++i) {
    const MessageField& field = layout.fields[i];
    const json& member = value.at(field.name);
    if (IsMessage(field)) {
      AddCells(layout, layout.messages[field.message], member, line);
    } else {
      line += "," + Cell(TextOf(field, member));
    }
  }
}

}  // namespace

Expected<std::string> CsvHeader(const MessageLayout& layout) {
  std::string line = "time,stamp";
  AddNames(layout, layout.messages[0], "", line);
  if (line.size() > kLongestHeader) {
    return Problem{layout.messages[0].type + ": has too many fields for a table"};
  }
  return line + "\n";
}

Expected<std::string> CsvLine(const MessageLayout& layout, const StoredMessage& message) {
  try {
    std::string line = message.time + "," + std::to_string(message.stamp);
    AddCells(layout, layout.messages[0], ParseLimitedJson(message.json, kMostOwnJsonValues), line);
    return line + "\n";
  } catch (const std::exception& error) {
    return Problem{message.type->name + ": " + error.what()};
  }
}

}  // namespace coppice::robot::storage

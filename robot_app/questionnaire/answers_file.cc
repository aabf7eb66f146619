#include "robot_app/questionnaire/answers_file.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <system_error>

#include "bt_core/base/json_library.h"
#include "bt_core/base/read_file.h"
#include "bt_core/data/value.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot::questionnaire {
namespace {

// Of more people than a robot meets. Each answer writes the file anew.
constexpr std::size_t kMostAnswers = std::size_t{4} << 20;  // bytes

std::vector<std::string> SplitRow(const std::string& row) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t end; (end = row.find(',', begin)) != std::string::npos; begin = end + 1) {
    fields.push_back(row.substr(begin, end - begin));
  }
  fields.push_back(row.substr(begin));
  return fields;
}

std::string HeaderOf(const Questionnaire& questionnaire) {
  std::string header;
  for (const std::string& column : questionnaire.Columns()) {
    header += (header.empty() ? "" : ",") + column;
  }
  return header;
}

// -1: no mark.
int ReadMark(const std::string& text, int points) {
  if (text.empty()) return 0;
  int mark = 0;
  const bool is_mark = ValueTraits<int>::Parse(text, mark) && mark >= 1 && mark <= points;
  return is_mark ? mark : -1;
}

Marks ReadRow(const std::string& row, const Questionnaire& questionnaire, SourceLocation where,
              Diagnostics& diagnostics) {
  Marks marks;
  const std::vector<std::string> columns = questionnaire.Columns();
  const std::vector<std::string> fields = SplitRow(row);
  if (fields.size() != columns.size()) {
    diagnostics.Error(where, "expected " + std::to_string(columns.size()) + " fields, found " +
                                 std::to_string(fields.size()));
    return marks;
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    marks.push_back(ReadMark(fields[i], questionnaire.points));
    if (marks.back() < 0) {
      diagnostics.Error(where, columns[i] + ": \"" + fields[i] + "\" is no mark from 1 to " +
                                   std::to_string(questionnaire.points));
    }
  }
  return marks;
}

// Of other people, with the header, whole lines.
Expected<std::string> AnswersSoFar(const std::string& path, const Questionnaire& questionnaire) {
  const std::string header = HeaderOf(questionnaire) + "\n";
  std::error_code error;
  const bool is_new =
      std::filesystem::status(path, error).type() == std::filesystem::file_type::not_found;
  if (is_new) return header;
  Diagnostics diagnostics;
  std::optional<std::string> text = ReadFile(path, diagnostics, kMostAnswers);
  if (!text) return Problem{diagnostics.ToString()};
  if (text->empty()) return header;
  if (text->back() != '\n') *text += "\n";
  std::string first = text->substr(0, text->find('\n') + 1);
  if (first.size() > 1 && first[first.size() - 2] == '\r') first.erase(first.size() - 2, 1);
  if (first == header) return *std::move(text);
  return Problem{path + ": these are no answers to this questionnaire\n"};
}

}  // namespace

std::vector<Marks> ReadAnswers(const std::string& path, const Questionnaire& questionnaire,
                               Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadFile(path, diagnostics);
  if (!text) return {};
  std::vector<Marks> people;
  std::istringstream rows(*text);
  std::string row;
  for (std::uint32_t line = 1; std::getline(rows, row); ++line) {
    if (!row.empty() && row.back() == '\r') row.pop_back();
    const SourceLocation where{path, line, 1};
    if (line > 1) {
      if (!row.empty()) people.push_back(ReadRow(row, questionnaire, where, diagnostics));
    } else if (row != HeaderOf(questionnaire)) {
      diagnostics.Error(where, "these are no answers to this questionnaire",
                        "expected the columns " + HeaderOf(questionnaire));
      return {};
    }
  }
  return diagnostics.has_errors() ? std::vector<Marks>() : people;
}

// The whole file is written anew, so that no row is ever half there; so one that cannot be read is
// left as it is.
Outcome AddAnswers(const std::string& path, const Questionnaire& questionnaire,
                   const Marks& marks) {
  Expected<std::string> answers = AnswersSoFar(path, questionnaire);
  if (!answers) return Problem{answers.problem()};
  std::string text = *std::move(answers);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    text += (i == 0 ? "" : ",") + (marks[i] == 0 ? "" : std::to_string(marks[i]));
  }
  Diagnostics diagnostics;
  if (WriteFile(path, text + "\n", diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

Expected<Marks> MarksOf(const std::string& json, const Questionnaire& questionnaire) {
  Marks marks;
  bool are_whole = true;  // 1.5, true and numbers beyond an int would become some mark
  try {
    const nlohmann::json call = ParseLimitedJson(json);
    for (const auto& mark : call.at("marks").get_ref<const nlohmann::json::array_t&>()) {
      const auto value = mark.get<std::int64_t>();
      are_whole =
          are_whole && mark.is_number_integer() && value >= 0 && value <= questionnaire.points;
      marks.push_back(are_whole ? static_cast<int>(value) : 0);
    }
  } catch (const std::exception&) {
    return Problem{"expected {\"marks\": [...]}"};
  }
  if (!are_whole || marks.size() != questionnaire.Columns().size()) {
    return Problem{"expected a mark for each item"};
  }
  if (std::count(marks.begin(), marks.end(), 0) == static_cast<std::ptrdiff_t>(marks.size())) {
    return Problem{"no mark was made"};
  }
  return marks;
}

}  // namespace coppice::robot::questionnaire

#include "editor/live/values/value_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "bt_core/data/value_bytes.h"

namespace coppice::editor {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kBlanks[] = " \t\r\n";

// The JSON in the bytes: of a value, or of a string that holds some.
std::string_view TextOf(const std::string& bytes) {
  const ValueForm form = FormOfValue(bytes);
  if (form != ValueForm::kJson && form != ValueForm::kText) return {};
  return std::string_view(bytes).substr(1);
}

bool IsRows(const Json& json) {
  return json.is_array() && !json.empty() &&
         std::all_of(json.begin(), json.end(), [](const Json& row) { return row.is_object(); });
}

// The list of objects; null if there is none.
const Json* RowsOf(const Json& json) {
  if (IsRows(json)) return &json;
  const Json* rows = nullptr;
  if (!json.is_object()) return nullptr;
  for (const Json& member : json) {
    if (IsRows(member) && std::exchange(rows, &member)) return nullptr;
  }
  return rows;
}

ValueTable::Cell CellOf(const Json& value) {
  if (value.is_null()) return {};
  ValueTable::Cell cell;
  if (value.is_string()) {
    cell.text = value.get<std::string>();
  } else {
    cell.text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  if (value.is_number()) cell.number = value.get<double>();
  return cell;
}

bool ComesBefore(const ValueTable::Cell& a, const ValueTable::Cell& b) {
  if (a.number && b.number) return *a.number < *b.number;
  if (a.number.has_value() != b.number.has_value()) return a.number.has_value();
  return a.text < b.text;
}

}  // namespace

void ValueTable::Sort(std::size_t column, bool descending) {
  if (column >= columns.size()) return;
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
    return descending ? ComesBefore(b[column], a[column]) : ComesBefore(a[column], b[column]);
  });
}

bool LooksLikeTable(const std::string& bytes) {
  constexpr std::size_t kLookedAt = 64;  // an object has its list near the beginning
  const std::string_view text = TextOf(bytes);
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos || (text[first] != '[' && text[first] != '{')) return false;
  const std::size_t list = text.substr(0, first + kLookedAt).find('[');
  if (list == text.npos) return false;
  const std::size_t row = text.find_first_not_of(kBlanks, list + 1);
  return row != text.npos && text[row] == '{';
}

std::optional<ValueTable> ReadTable(const std::string& bytes) {
  const Json json = Json::parse(TextOf(bytes), nullptr, false);
  const Json* const rows = json.is_discarded() ? nullptr : RowsOf(json);
  if (!rows) return std::nullopt;
  ValueTable table;
  for (const Json& row : *rows) {
    if (table.rows.size() == ValueTable::kMostRows) break;
    std::vector<ValueTable::Cell>& cells = table.rows.emplace_back();
    for (const auto& [name, value] : row.items()) {
      const auto at = std::find(table.columns.begin(), table.columns.end(), name);
      const auto column = static_cast<std::size_t>(at - table.columns.begin());
      if (at == table.columns.end()) {
        if (table.columns.size() == ValueTable::kMostColumns) continue;
        table.columns.push_back(name);
      }
      if (cells.size() <= column) cells.resize(column + 1);
      cells[column] = CellOf(value);
    }
  }
  for (auto& cells : table.rows) cells.resize(table.columns.size());
  return table;
}

CellLevel LevelOf(const std::string& word) {
  struct Known {
    std::string_view word;
    CellLevel level;
  };
  static constexpr std::array<Known, 20> kKnown = {
      {{"READY", CellLevel::kGood},      {"OK", CellLevel::kGood},
       {"SUCCESS", CellLevel::kGood},    {"STARTING", CellLevel::kBusy},
       {"RUNNING", CellLevel::kBusy},    {"CHANGING", CellLevel::kBusy},
       {"STOPPED", CellLevel::kOff},     {"IDLE", CellLevel::kOff},
       {"SKIPPED", CellLevel::kOff},     {"WARN", CellLevel::kWarning},
       {"WARNING", CellLevel::kWarning}, {"BACKING_OFF", CellLevel::kWarning},
       {"CLOSURE", CellLevel::kWarning}, {"STACK", CellLevel::kWarning},
       {"PERSON", CellLevel::kBad},      {"GIVEN_UP", CellLevel::kBad},
       {"UNREACHABLE", CellLevel::kBad}, {"ERROR", CellLevel::kBad},
       {"STALE", CellLevel::kBad},       {"FAILURE", CellLevel::kBad}}};
  std::string upper = word;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const Known& known : kKnown) {
    if (known.word == upper) return known.level;
  }
  return CellLevel::kNone;
}

}  // namespace coppice::editor
